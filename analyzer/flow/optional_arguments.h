// Arguments that a sub can do without: it copies them into a name of its own, and tests that (`#<verbose> = #5`, then
// `if [#<verbose>]`). Not to pass them is meant, as it is where #5 itself is tested.
#pragma once

#include <unordered_set>

#include "analyzer/program/program.h"

namespace owlint::flow {

class OptionalArguments {
 public:
  explicit OptionalArguments(const Program& program);

  /// Whether all that a line does with #number is to copy it into a name that a condition of the same sub tests.
  bool copies(StatementId line, uint32_t number) const;

 private:
  static uint64_t key(RegionId region, NameId name) { return static_cast<uint64_t>(region) << 32 | name; }
  void note(RegionId region, ExprId condition);
  bool reads(ExprId value, uint32_t number) const;

  const Program& program_;
  std::unordered_set<uint64_t> tested_;  ///< names by region
};

}  // namespace owlint::flow
