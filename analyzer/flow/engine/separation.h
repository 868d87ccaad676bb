// Whether one more state is joined with others or kept apart from them. How many there are decides, and there is more room for
// states in which an operation will fail: joined with other values, the stop would not be seen.
#pragma once

#include <unordered_map>
#include <vector>

#include "analyzer/flow/engine/precision.h"
#include "analyzer/flow/interpreter/abstract_machine.h"

namespace owlint::flow {

class Separation {
 public:
  /// All must outlive it.
  Separation(const Program& program, AbstractMachine& machine, const Precision& precision, const Limits& limits)
      : program_(program), machine_(machine), precision_(precision), limits_(limits) {}

  /// Whether a state that enters the sub at `position`, or goes on in it, is joined with others where `there` are kept apart
  /// already, and `most` are if nothing speaks for more. Those that will fail get Limits::times_for_failing times the room, but
  /// not at the last level.
  bool joins(const State& state, StatementId position, size_t there, size_t most);

 private:
  const std::vector<ExprId>& fallible_in(RegionId region);

  const Program& program_;
  AbstractMachine& machine_;
  const Precision& precision_;
  const Limits& limits_;
  std::unordered_map<RegionId, std::vector<ExprId>> fallible_;
  std::unordered_map<uint64_t, bool> failing_;  // by hash of region and parameters
};

}  // namespace owlint::flow
