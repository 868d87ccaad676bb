#include "analyzer/flow/engine/call_keys.h"

#include <algorithm>
#include <bit>

namespace owlint::flow {
namespace {

void add_number(std::string& key, uint64_t number) {
  key.append(reinterpret_cast<const char*>(&number), sizeof number);
}

}  // namespace

/// Notes what a line depends on; false if a sub with such a line cannot be kept: it may end the program, call others,
/// fail, or change what is not its own.
bool CallKeys::note_line(StatementId id, Dependence& out) const {
  const Statement& s = program_.at(id);
  if (s.has_error() || s.is(Keyword::kCall)) return false;
  if (machine_.mode_uses().changed_at(id) != 0) return false;
  if (s.kind == LineKind::kModeLine) return !machine_.mode_uses().refuses() && !machine_.mode_uses().follows_place();
  if (s.kind == LineKind::kWords) return machine_.dependences().note_assignments(s, out);
  if (s.kind != LineKind::kOWord) return false;
  const BlockId block = program_.block_of[id];
  if (block != kNoBlock && !machine_.structure().structured[block]) return false;
  for (const ExprId value : program_.syntax.values_of(s)) machine_.dependences().note(value, out);
  return out.known;
}

void CallKeys::look_at(RegionId number, Sub& sub) const {
  sub.looked_at = true;
  const Region& region = program_.regions[number];
  if (!machine_.structure().apart[number]) return;
  for (StatementId id = region.opener; id <= region.end; ++id) {
    if (!note_line(id, sub.dependence)) return;
  }
  for (auto* keys : {&sub.dependence.locals, &sub.dependence.globals}) {
    std::ranges::sort(*keys);
    keys->erase(std::unique(keys->begin(), keys->end()), keys->end());
  }
  sub.fits = true;
  const std::string_view text =
      linked_.source_of(region.opener).slice({program_.at(region.opener).offset, program_.at(region.end).end()});
  add_number(sub.text, text.size());
  sub.text += text;
  sub.text += sub.dependence.circumstances;
  sub.dependence.circumstances.clear();
}

std::optional<std::string> CallKeys::of(const Context& callee, const State& entry, size_t level) {
  if (entry.seek || entry.skip != kNoLabel || entry.defining != kNoName || callee.fanuc) return std::nullopt;
  const RegionId region = program_.region_of[entry.position];
  if (program_.regions[region].opener != entry.position || program_.regions[region].name != callee.sub)
    return std::nullopt;
  Sub& sub = subs_[region];
  if (!sub.looked_at) look_at(region, sub);
  if (!sub.fits) return std::nullopt;
  const Parameters& p = entry.parameters;
  if (sub.dependence.global_outcomes && p.global_outcomes.hash() != PersistentMap().hash()) return std::nullopt;
  if (std::ranges::any_of(entry.counts.all(),
                          [&](const auto& count) { return machine_.scope_of(count.first) == callee.sub; }))
    return std::nullopt;
  std::string key = sub.text;
  add_number(key,
             level << 32 | static_cast<uint64_t>(entry.flags.executed) << 24 |
                 static_cast<uint64_t>(entry.flags.breaking) << 16 |
                 static_cast<uint64_t>(entry.flags.continuing) << 8 | entry.flags.returned);
  add_number(key,
             static_cast<uint64_t>(entry.joined) | static_cast<uint64_t>(entry.mixed) << 1 |
                 static_cast<uint64_t>(p.outside) << 2);
  add_number(key, circumstances_);
  const auto add_values = [&](const std::vector<uint32_t>& keys, const PersistentMap& map) {
    for (const uint32_t k : keys) {
      const ValueId value = map.get(k);
      key.push_back(static_cast<char>(std::min(value, kFirstConstant)));
      if (value < kFirstConstant) continue;
      const Range range = machine_.evaluator().values().range(value);
      key.push_back(static_cast<char>(range.above_low << 1 | range.below_high));
      for (const double end : {range.low, range.high}) add_number(key, std::bit_cast<uint64_t>(end));
    }
  };
  add_values(machine_.evaluator().result_keys(), p.globals);
  add_values(sub.dependence.locals, p.locals);
  add_values(sub.dependence.globals, p.globals);
  return key;
}

}  // namespace owlint::flow
