// Arguments that a sub can do without: it tests them (`if [#3 EQ 0]`), asks how many there are (`#<n_args>`), or copies
// them into a name that it tests (`#<verbose> = #5`, then `if [#<verbose>]`) or never reads. A call may leave them out.
#pragma once

#include <unordered_set>

#include "analyzer/program/program.h"

namespace owlint::flow {

class OptionalArguments {
 public:
  explicit OptionalArguments(const Program& program);

  /// Whether the sub of a line that reads #number is made for calls without it, or most of its calls are without it.
  bool optional(StatementId line, uint32_t number) const;

 private:
  static uint64_t key(RegionId region, uint32_t what) { return static_cast<uint64_t>(region) << 32 | what; }
  void note(RegionId region, ExprId value, bool condition);
  bool reads(ExprId value, uint32_t number) const;
  bool copies(StatementId line, uint32_t number) const;
  bool mostly_left_out(RegionId region, uint32_t number) const;

  const Program& program_;
  NameId count_ = kNoName;                       ///< `#<n_args>`
  std::unordered_set<uint64_t> tested_;          ///< names by region; global ones for the main region
  std::unordered_set<uint64_t> tested_numbers_;  ///< arguments by region
  std::unordered_set<uint64_t> read_;            ///< names by region
};

}  // namespace owlint::flow
