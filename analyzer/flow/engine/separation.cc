#include "analyzer/flow/engine/separation.h"

#include "analyzer/flow/interpreter/fallible.h"

namespace owlint::flow {

/// The operations of a sub, or of the main program, that can fail: the first ones, for they are computed often.
const std::vector<ExprId>& Separation::fallible_in(RegionId region) {
  const auto [known, is_new] = fallible_.try_emplace(region);
  if (is_new) {
    const bool is_main = region == kMainRegion;
    const StatementId first = is_main ? 0 : program_.regions[region].opener;
    const StatementId last = is_main ? static_cast<StatementId>(program_.size()) : program_.regions[region].last;
    for (StatementId id = first; id < last && known->second.size() < limits_.fallible_operations; ++id) {
      if (program_.region_of[id] == region) add_fallible(program_.syntax, program_.at(id), known->second);
    }
  }
  return known->second;
}

bool Separation::joins(const State& state, StatementId position, size_t there, size_t most) {
  if (there < most) return false;
  if (precision_.coarse() || there >= limits_.times_for_failing * most) return true;
  const RegionId region = position < program_.size() ? program_.region_of[position] : kMainRegion;
  const Parameters& p = state.parameters;
  const auto [known, is_new] = failing_.try_emplace(mix(
      mix(p.locals.hash(), p.globals.hash()), static_cast<uint64_t>(region) << 1 | static_cast<uint64_t>(p.outside)));
  if (is_new) known->second = machine_.evaluator().will_fail(fallible_in(region), p);
  return !known->second;
}

}  // namespace owlint::flow
