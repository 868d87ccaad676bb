// Why no run gets to a line: the text after "not reached:" in the report.
#pragma once

#include <optional>
#include <vector>

#include "rules/driver/rule.h"

namespace owlint::rules {

/// For the lines of one file. Made only if a finding needs it.
class Unreached {
 public:
  explicit Unreached(const Input& in);

  /// The line that keeps runs away from the statement at `offset`, with the reason as its message; nothing if it is not known.
  std::optional<Related> reason(uint64_t offset) const;

 private:
  std::optional<Related> of(StatementId statement) const;
  std::optional<Related> of_sub(RegionId region) const;
  Related at(StatementId statement, const std::string& what) const;

  const Input& in_;
  std::vector<StatementId> last_;  // by statement: the last one before it, in the same sub, that some run executes
  std::vector<StatementId> first_call_;  // by name of the sub
  bool calls_computed_ = false;          // a call computes its name
  StatementId stop_ = kNoStatement;      // where every run stops
};

}  // namespace owlint::rules
