// The modes in effect before each line of a program, over all runs that get there, and where they were set: what a reader of the
// program asks.
#pragma once

#include <optional>
#include <vector>

#include "analyzer/flow/engine/mode_setters.h"

namespace owlint::flow {

struct ModeThere {
  Mode mode{};
  ValueSet may = 0;                ///< its values
  bool known = false;              ///< false: it is whatever it was before
  std::vector<ModeSetter> set_on;  ///< by the runs that come here, as far as lines have set it
};

class ModeMap {
 public:
  /// Analyses the program; `linked` must outlive it.
  ModeMap(const Linked& linked, const Profile& profile, const Limits& limits);
  ~ModeMap();

  /// Before a line of the program's own file (from 1) is carried out. Nothing if no run gets there.
  std::optional<std::vector<ModeThere>> before(uint32_t line) const;

 private:
  class Collector;
  struct Seen;

  void carry_on(uint32_t first, uint32_t last, ModeState* state, std::vector<ModeThere>* modes) const;
  void add_setters(const Seen& seen, StatementId next, std::vector<ModeThere>* modes) const;

  const Linked& linked_;
  Iteration analysis_;
  std::unique_ptr<Collector> collector_;
};

}  // namespace owlint::flow
