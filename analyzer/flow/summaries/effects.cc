#include "analyzer/flow/summaries/effects.h"

#include <algorithm>
#include <bit>

#include "analyzer/flow/domain/modes.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {
namespace {

void add_line(const Program& program, const Statement& s, Effects& effects) {
  if (s.is(Keyword::kBreak) || s.is(Keyword::kContinue)) effects.jumps = true;
  if (s.is(Keyword::kIf)) effects.tests = true;
  if (s.kind == LineKind::kRemap) effects.any_global = true;  // it may run Python
  for (const Item& item : program.syntax.items_of(s)) {
    if (item.target_name != kNoName) {
      if (is_global_name(program.name(item.target_name))) effects.globals.insert(kGlobalNames + item.target_name);
      continue;
    }
    if (item.target == kNoExpr) continue;
    const std::optional<long> index = literal_integer(program.syntax.exprs, item.target);
    if (!index) {
      effects.any_global = true;
    } else if (*index >= kFirstGlobalNumber) {
      effects.globals.insert(static_cast<uint32_t>(*index));
    }
  }
}

}  // namespace

EffectsOfSubs::EffectsOfSubs(const Program& program, bool regular, const ModeUses& modes, const Limits& limits)
    : program_(program), regular_(regular), modes_(modes), reached_subs_(limits.reached_subs) {
  const auto name_of = [&](RegionId r) { return r == kMainRegion ? kNoName : program.regions[r].name; };
  regions_.assign(program.syntax.names.size(), static_cast<uint32_t>(program.regions.size()), name_of);
  calls_.assign(program.regions.size(), static_cast<uint32_t>(program.calls.size()),
                [&](uint32_t i) { return program.calls[i].caller; });
}

const Effects& EffectsOfSubs::of(NameId sub) {
  const auto [entry, added] = known_.try_emplace(sub);
  Effects& effects = entry->second;
  if (!added) return effects;
  effects.everything = !regular_;
  for (const char* result : {"_value", "_value_returned"}) {
    if (const NameId name = program_.syntax.names.find(result); name != kNoName)
      effects.globals.insert(kGlobalNames + name);
  }
  std::vector<NameId> todo{sub};
  while (!todo.empty() && !effects.everything) {
    const NameId name = todo.back();
    todo.pop_back();
    if (!effects.subs.insert(name).second) continue;
    if (effects.subs.size() > reached_subs_) effects.everything = true;
    if (name >= regions_.size()) continue;  // a computed one
    for (const RegionId r : regions_[name]) {
      const Region& region = program_.regions[r];
      for (StatementId id = region.opener; id < region.last; ++id) {
        add_line(program_, program_.at(id), effects);
        for (ModeMask changed = modes_.changed_at(id); changed != 0; changed &= changed - 1)
          effects.globals.insert(mode_key(static_cast<Mode>(std::countr_zero(changed))));
      }
      for (const uint32_t call : calls_[r]) todo.push_back(program_.calls[call].callee);
    }
  }
  return effects;
}

}  // namespace owlint::flow
