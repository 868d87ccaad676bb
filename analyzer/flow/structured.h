// What the analysis can rely on without following any run: the shape of the program as a whole, and which blocks need
// no entry in the interpreter's label table, because every run that gets to one of their lines has come through their
// opener. That is nearly every block of a sound program, and it keeps states alike.
#pragma once

#include <vector>

#include "analyzer/program/program.h"

namespace owlint::flow {

struct Structure {
  explicit Structure(const Program& program);

  /// Every sub and block of the program is closed and every label known, so that a run is always in the sub that its
  /// line stands in.
  bool regular = false;
  /// No chain of calls can be deeper than LinuxCNC allows, whatever the conditions.
  bool shallow_calls = false;
  /// By region: a sub that is closed, in which every block is, whose labels are all known and that is defined once. Then
  /// a call stays in it until it comes back, whatever the rest of the program is like.
  std::vector<bool> apart;
  /// By block. A block is structured when it is closed, nothing overlaps it, no sub begins or ends in it, everything in
  /// it is structured too, and its label stands on no other block that a run could confuse it with. In a program that is
  /// not regular, those of subs that are apart are so only for a call of that sub; see structured_for().
  std::vector<bool> structured;

  /// Whether the blocks of a region that are structured are so for a run that is in a call of `sub` (kNoName: in none).
  bool structured_for(const Program& program, RegionId region, NameId sub) const {
    return regular || !apart[region] || sub == program.regions[region].name;
  }
};

}  // namespace owlint::flow
