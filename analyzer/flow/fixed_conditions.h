// Conditions that come out the same every time, whatever a sub is called with and whatever its globals are.
#pragma once

#include "analyzer/flow/accesses.h"
#include "analyzer/flow/control_flow.h"
#include "analyzer/flow/ranges.h"

namespace owlint::flow {

/// A condition that has one outcome.
struct FixedCondition {
  StatementId statement = kNoStatement;
  bool truth = false;
  StatementId same_as = kNoStatement;  ///< an earlier branch of its `if` with the same condition
};

/// Parameters that the program sets once, to a number that somebody has written: they are there to be changed by hand, so
/// nothing is concluded from the number that they have today.
class Settings {
 public:
  explicit Settings(const Program& program);
  bool has(ParameterKey key) const;

 private:
  std::vector<ParameterKey> keys_;  // sorted
};

/// Adds those of one sub, or of the main program.
void find_fixed_conditions(const Program& program, const ControlFlow& flow, const Settings& settings, std::vector<FixedCondition>& out);

}  // namespace owlint::flow
