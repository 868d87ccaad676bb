// Whether it is certain that some run reads a name that is not there: then it is an error, else a warning.
#include <algorithm>

#include "analyzer/flow/engine/analysis.h"

namespace owlint::flow {

/// Whether a name is missing only after a loop without a pass, or for a value that a list of cases does not have (`elseif`, or one
/// `if` after the other): lines above assign it there, and nobody but the program's author knows whether that happens.
bool Analysis::assigned_in_most_cases(const FlowStop& stop) const {
  const NameId name = program_.syntax.names.find(stop.detail);
  const RegionId region = program_.region_of[stop.statement];
  const auto skips = [&](const Block& block) {
    if (block.kind == Keyword::kWhile || block.kind == Keyword::kRepeat) return true;
    const auto parts = program_.parts[static_cast<size_t>(&block - program_.blocks.data())];
    return block.kind == Keyword::kIf && (parts.empty() || std::ranges::any_of(parts, [this](StatementId part) {
                                            return program_.at(part).is(Keyword::kElseif);
                                          }));
  };
  std::vector<StatementId> assigned;
  for (StatementId id = 0; id < stop.statement; ++id) {
    const Statement& s = program_.at(id);
    const auto assigns = [&](uint32_t i) { return program_.syntax.items[s.first + i].target_name == name; };
    for (uint32_t i = 0; i < s.item_count; ++i) {
      if (assigns(i) && program_.region_of[id] == region) assigned.push_back(id);
    }
  }
  size_t ifs = 0;
  return std::ranges::any_of(program_.blocks, [&](const Block& block) {
    if (block.region != region || block.end == kNoStatement || block.end > stop.statement || !skips(block))
      return false;
    const auto first = std::ranges::lower_bound(assigned, block.opener);
    if (first == assigned.end() || *first > block.end) return false;
    const bool alone =
        block.kind == Keyword::kIf && program_.parts[static_cast<size_t>(&block - program_.blocks.data())].empty();
    return !alone || ++ifs > 1;
  });
}

/// Whether the branches on a path go as they do independently of each other, or are known not to.
bool Analysis::followed(const std::vector<Decision>& path) const {
  std::vector<std::vector<uint64_t>> exact;
  std::vector<std::vector<uint64_t>> others;
  for (const Decision& decision : path) {
    const Statement& s = program_.at(decision.statement);
    if (s.value_count == 0 || s.is(Keyword::kRepeat)) continue;
    std::vector<uint64_t> reads;
    const bool is_exact = machine_.evaluator().followed(program_.syntax.values[s.first], reads);
    for (const uint64_t key : reads) {
      const auto shares = [&](const std::vector<uint64_t>& other) {
        return key == UINT64_MAX || std::ranges::count(other, key) + std::ranges::count(other, UINT64_MAX) > 0;
      };
      if (std::ranges::any_of(others, shares) || (!is_exact && std::ranges::any_of(exact, shares))) return false;
    }
    (is_exact ? exact : others).push_back(std::move(reads));
  }
  return true;
}

}  // namespace owlint::flow
