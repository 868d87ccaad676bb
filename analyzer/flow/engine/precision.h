// How exactly runs are followed at the moment: the levels of Limits, one after the other as the analysis takes its steps.
#pragma once

#include "analyzer/flow/limits.h"

namespace owlint::flow {

class Precision {
 public:
  /// `coarse`: at the last level from the start. `limits` must outlive it.
  Precision(const Limits& limits, bool coarse) : limits_(limits), level_(coarse ? limits.levels.size() - 1 : 0) {}

  /// Counts steps of the analysis, and goes to the level that is for so many.
  void count(uint64_t steps) {
    steps_ += steps;
    while (steps_ >= now().steps) ++level_;
  }
  /// Whether the level is the same after so many more steps.
  bool lasts(uint64_t steps) const { return steps_ + steps < now().steps; }

  uint64_t steps() const { return steps_; }
  size_t level() const { return level_; }
  const Limits::Level& now() const { return limits_.levels[level_]; }
  /// Constants are joined, too, and stretches of harmless lines are one step.
  bool coarse() const { return level_ + 1 == limits_.levels.size(); }

 private:
  const Limits& limits_;
  size_t level_;
  uint64_t steps_ = 0;
};

}  // namespace owlint::flow
