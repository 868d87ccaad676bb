#include "analyzer/flow/verdicts/undefined_names.h"

#include <algorithm>

namespace owlint::flow {

bool assigned_in_most_cases(const Program& program, const FlowStop& stop) {
  const NameId name = program.syntax.names.find(stop.detail);
  const RegionId region = program.region_of[stop.statement];
  const auto skips = [&](const Block& block) {
    if (block.kind == Keyword::kWhile || block.kind == Keyword::kRepeat) return true;
    const auto parts = program.parts[static_cast<size_t>(&block - program.blocks.data())];
    return block.kind == Keyword::kIf && (parts.empty() || std::ranges::any_of(parts, [&](StatementId part) {
                                            return program.at(part).is(Keyword::kElseif);
                                          }));
  };
  std::vector<StatementId> assigned;
  for (StatementId id = 0; id < stop.statement; ++id) {
    const Statement& s = program.at(id);
    for (const Item& item : program.syntax.items_of(s)) {
      if (item.target_name == name && program.region_of[id] == region) assigned.push_back(id);
    }
  }
  size_t ifs = 0;
  return std::ranges::any_of(program.blocks, [&](const Block& block) {
    if (block.region != region || block.end == kNoStatement || block.end > stop.statement || !skips(block))
      return false;
    const auto first = std::ranges::lower_bound(assigned, block.opener);
    if (first == assigned.end() || *first > block.end) return false;
    const bool alone =
        block.kind == Keyword::kIf && program.parts[static_cast<size_t>(&block - program.blocks.data())].empty();
    return !alone || ++ifs > 1;
  });
}

bool followed(const Program& program, const Refinement& refinement, const std::vector<Decision>& path) {
  std::vector<std::vector<ParameterKey>> exact;
  std::vector<std::vector<ParameterKey>> others;
  for (const Decision& decision : path) {
    const Statement& s = program.at(decision.statement);
    if (s.value_count == 0 || s.is(Keyword::kRepeat)) continue;
    std::vector<ParameterKey> reads;
    const bool is_exact = refinement.followed(program.syntax.values_of(s).front(), reads);
    for (const ParameterKey key : reads) {
      const auto shares = [&](const std::vector<ParameterKey>& other) {
        return key == kComputedKey || std::ranges::count(other, key) + std::ranges::count(other, kComputedKey) > 0;
      };
      if (std::ranges::any_of(others, shares) || (!is_exact && std::ranges::any_of(exact, shares))) return false;
    }
    (is_exact ? exact : others).push_back(std::move(reads));
  }
  return true;
}

}  // namespace owlint::flow
