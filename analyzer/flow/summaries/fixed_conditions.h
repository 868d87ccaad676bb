// Conditions that are the same every time, whatever the arguments and the globals of the sub are.
#pragma once

#include "analyzer/flow/domain/ranges.h"
#include "analyzer/flow/facts/accesses.h"
#include "analyzer/flow/facts/control_flow.h"
#include "analyzer/flow/limits.h"

namespace owlint::flow {

/// A condition with only one outcome.
struct FixedCondition {
  StatementId statement = kNoStatement;
  bool truth = false;
  StatementId same_as = kNoStatement;  ///< an earlier branch of its `if` with the same condition
};

/// Parameters that the program sets once, to a written number. The user may change that number by hand, so nothing is
/// concluded from it.
class Presets {
 public:
  explicit Presets(const Program& program);
  bool has(ParameterKey key) const;

 private:
  std::vector<ParameterKey> keys_;  // sorted
};

/// Adds the conditions of one sub, or of the main program.
void find_fixed_conditions(const Program& program, const ControlFlow& flow, const Presets& presets,
                           const Limits& limits, std::vector<FixedCondition>& out);

}  // namespace owlint::flow
