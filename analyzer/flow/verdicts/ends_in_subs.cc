#include "analyzer/flow/verdicts/ends_in_subs.h"

#include <algorithm>
#include <unordered_map>

namespace owlint::flow {
namespace {

/// Whether a line is executed only on a condition.
bool conditional(const Program& program, StatementId id) {
  for (BlockId block = program.open_above(program.region_of[id], id); block != kNoBlock;
       block = program.blocks[block].parent) {
    if (program.blocks[block].kind == Keyword::kIf) return true;
  }
  return false;
}

/// Whether lines would be executed after a call if it came back. Not if the call itself depends on a condition: that is how
/// programs are aborted on purpose.
bool leaves_work(const Iteration& analysis, ContextId context, StatementId call, int depth) {
  const Program& program = analysis.program();
  if (conditional(program, call)) return false;
  const RegionId region = program.region_of[call];
  if (program.at(call).plain_code_follows) return true;
  for (StatementId id = call + 1; id < program.size() && program.at(id).kind != LineKind::kFileEnd; ++id) {
    const Statement& s = program.at(id);
    if (program.region_of[id] != region) {  // a definition is passed over
      const Region& other = program.regions[program.region_of[id]];
      if (region != kMainRegion || other.last <= id) return false;
      id = other.last - 1;
      if (program.at(id).plain_code_follows) return true;
      continue;
    }
    if (s.kind == LineKind::kProgramEnd || s.kind == LineKind::kPercent || s.kind == LineKind::kM99) return false;
    if (!s.is(Keyword::kEndsub) && !s.is(Keyword::kReturn)) return true;
    if (depth >= kMaxCallDepth) return false;
    size_t asked = 0;
    return std::ranges::any_of(analysis.calls()[context].callers, [&](const Caller& caller) {
      return ++asked <= analysis.limits().asked_callers &&
          leaves_work(analysis, caller.state.context, caller.state.position, depth + 1);
    });
  }
  return false;
}

}  // namespace

void find_ends_in_subs(const Iteration& analysis, Hazards& hazards) {
  const Program& program = analysis.program();
  std::unordered_map<ContextId, std::vector<StatementId>>
      ends;  // M2, M30 and `%`, by the call in which they are executed
  for (const Partition& partition : analysis.partitions().all()) {
    const Frame& frame = analysis.calls()[partition.context];
    if (frame.callers.empty() || !frame.exits.empty() || partition.skip != kNoLabel ||
        partition.position >= program.size())
      continue;
    const LineKind kind = program.at(partition.position).kind;
    const bool ends_program = kind == LineKind::kProgramEnd || (kind == LineKind::kPercent && program.syntax.percent);
    if (program.region_of[partition.position] != kMainRegion && ends_program)
      ends[partition.context].push_back(partition.position);
  }
  for (auto& [context, lines] : ends) {
    std::ranges::sort(lines);
    // One that depends on a condition is on purpose, unless the other branches end as well.
    const auto plain = std::ranges::find_if(lines, [&](StatementId id) { return !conditional(program, id); });
    if (plain == lines.end() && lines.front() == lines.back()) continue;
    const StatementId end = plain == lines.end() ? lines.back() : *plain;
    for (const Caller& caller : analysis.calls()[context].callers) {
      const StatementId call = caller.state.position;
      if (!leaves_work(analysis, caller.state.context, call, 0)) continue;
      hazards.add(hazard_at(HazardKind::kEndsInSub, end, call));
      break;
    }
  }
}

}  // namespace owlint::flow
