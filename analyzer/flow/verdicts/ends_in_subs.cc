// Calls that never come back because the program ends in the sub, where lines below the call were to be executed.
#include "analyzer/flow/engine/analysis.h"

namespace owlint::flow {

/// Whether a line is executed only on a condition.
bool Analysis::conditional(StatementId id) const {
  for (BlockId block = program_.open_above(program_.region_of[id], id); block != kNoBlock;
       block = program_.blocks[block].parent) {
    if (program_.blocks[block].kind == Keyword::kIf) return true;
  }
  return false;
}

/// Whether lines would be executed after a call if it came back. Not if the call itself depends on a condition: that is how
/// programs are aborted on purpose.
bool Analysis::leaves_work(ContextId context, StatementId call, int depth) const {
  if (conditional(call)) return false;
  const RegionId region = program_.region_of[call];
  if (program_.at(call).plain_code_follows) return true;
  for (StatementId id = call + 1; id < program_.size() && program_.at(id).kind != LineKind::kFileEnd; ++id) {
    const Statement& s = program_.at(id);
    if (program_.region_of[id] != region) {  // a definition is passed over
      const Region& other = program_.regions[program_.region_of[id]];
      if (region != kMainRegion || other.last <= id) return false;
      id = other.last - 1;
      if (program_.at(id).plain_code_follows) return true;
      continue;
    }
    if (s.kind == LineKind::kProgramEnd || s.kind == LineKind::kPercent || s.kind == LineKind::kM99) return false;
    if (!s.is(Keyword::kEndsub) && !s.is(Keyword::kReturn)) return true;
    size_t callers = 0;
    return depth < kMaxCallDepth && std::ranges::any_of(frames_[context].callers, [&](const Caller& caller) {
             return ++callers <= limits_.asked_callers &&
                 leaves_work(caller.state.context, caller.state.position, depth + 1);
           });
  }
  return false;
}

void Analysis::ends_in_subs() {
  std::unordered_map<ContextId, std::vector<StatementId>> ends;  // M2 and M30, by the call in which they are executed
  for (const Group& group : groups_) {
    const Frame& frame = frames_[group.context];
    if (frame.callers.empty() || !frame.exits.empty() || group.skip != kNoLabel || group.position >= program_.size())
      continue;
    const RegionId region = program_.region_of[group.position];
    if (region != kMainRegion && program_.at(group.position).kind == LineKind::kProgramEnd)
      ends[group.context].push_back(group.position);
  }
  for (auto& [context, lines] : ends) {
    std::ranges::sort(lines);
    // One that depends on a condition is on purpose, unless the other branches end as well.
    const auto plain = std::ranges::find_if(lines, [this](StatementId id) { return !conditional(id); });
    if (plain == lines.end() && lines.front() == lines.back()) continue;
    const StatementId end = plain == lines.end() ? lines.back() : *plain;
    for (const Caller& caller : frames_[context].callers) {
      const StatementId call = caller.state.position;
      if (!leaves_work(caller.state.context, call, 0)) continue;
      hazards_.emplace(std::make_tuple(HazardKind::kEndsInSub, end, call, 0U),
                       Hazard{HazardKind::kEndsInSub, end, call, 0, Reach::kMaybe, StopKind::kNone, "", {}, {}});
      break;
    }
  }
}

}  // namespace owlint::flow
