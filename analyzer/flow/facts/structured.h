// What the analysis knows without following any run: the structure of the program, and which blocks need no entry in the
// interpreter's label table, because every run that gets to one of their lines has come through their first line. These
// are nearly all blocks of a correct program. So more states are equal.
#pragma once

#include <vector>

#include "analyzer/program/program.h"

namespace owlint::flow {

inline constexpr int kMaxCallDepth = 9;  ///< LinuxCNC's (measured): the tenth nested call is an error

struct Structure {
  explicit Structure(const Program& program);

  /// Every sub and block of the program is closed and every label known, so that a run is always in the sub around its
  /// line.
  bool regular = false;
  /// No chain of calls can be deeper than LinuxCNC allows, whatever the conditions.
  bool shallow_calls = false;
  /// By region: a closed sub with closed blocks and known labels that is defined once. Then a call stays in it until it
  /// returns, whatever the rest of the program is.
  std::vector<bool> apart;
  /// By block. A block is structured when it is closed, nothing overlaps it, no sub begins or ends in it, everything in
  /// it is structured too, and no other block that a run could confuse it with has its label. In a program that is
  /// not regular, those of subs that are apart are so only for a call of that sub; see structured_for().
  std::vector<bool> structured;

  /// Whether the structured blocks of a region are also structured for a run in a call of `sub` (kNoName: in no call).
  bool structured_for(const Program& program, RegionId region, NameId sub) const {
    return regular || !apart[region] || sub == program.regions[region].name;
  }
};

}  // namespace owlint::flow
