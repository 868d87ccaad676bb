// Loops without an end: those that no run leaves, and under FEATURE 0x20 ways round that an error which became a message makes.
#include <algorithm>
#include <map>

#include "analyzer/flow/analysis.h"

namespace owlint::flow {

/// Loops that no run leaves: nothing leads out of their way round, and no end is on it. A loop inside one of them that ends is
/// left for the rest of the outer one: it shows when the way back to the beginning of the outer one is taken away.
void Analysis::endless_loops() {
  const std::vector<bool>& hanging = trace_->hanging();
  if (std::ranges::find(hanging, true) == hanging.end()) return;
  constexpr int kMaxNesting = 64;
  std::vector<bool> found(program_.size());  // by statement: the opener of such a loop
  const auto goes_back = [&](RecordId from, RecordId to) {
    const StatementId target = trace_->at(to).statement;
    const StatementId source = trace_->at(from).statement;
    if (target == kNoStatement || source == kNoStatement || target > source) return false;
    const Statement& s = program_.at(target);
    return s.is(Keyword::kWhile) || s.is(Keyword::kDo) || s.is(Keyword::kRepeat);
  };
  const auto removed = [&](RecordId from, RecordId to) { return goes_back(from, to) && found[trace_->at(to).statement]; };
  for (int i = 0; i < kMaxNesting; ++i) {
    const std::vector<uint32_t> round = trace_->closed_cycles(removed);
    std::vector<StatementId> outermost(trace_->size() + 1, kNoStatement);  // by way round
    trace_->for_edges([&](RecordId from, RecordId to) {
      if (!hanging[from] || round[from] == 0 || round[from] != round[to] || !goes_back(from, to) || removed(from, to)) return;
      outermost[round[from]] = std::min(outermost[round[from]], trace_->at(to).statement);
    });
    bool grew = false;
    for (const StatementId loop : outermost) {
      if (loop == kNoStatement) continue;
      grew = found[loop] = true;
      hazards_.emplace(std::make_tuple(HazardKind::kEndlessLoop, loop, kNoStatement, 0U),
                       Hazard{HazardKind::kEndlessLoop, loop, kNoStatement, 0, Reach::kMaybe, StopKind::kNone, "", {}, {}});
    }
    if (!grew) return;
  }
}

/// Under FEATURE 0x20: ways round that an error which became a message leads into or keeps going. Loops as they
/// are meant go round while a condition is true; these do with every condition false, so that nothing ends them.
void Analysis::idle_loops() {
  if (warned_.empty()) return;
  const std::vector<uint32_t> group = trace_->idle_cycles();
  struct Loop {
    StatementId first = kNoStatement;   ///< the foremost line of the way round
    StatementId warned = kNoStatement;  ///< the foremost warning on it
    RecordId entry = kNoRecord;
  };
  std::map<uint32_t, Loop> loops;
  for (RecordId id = 0; id < trace_->size(); ++id) {
    const StatementId here = trace_->at(id).statement;
    if (group[id] == 0 || here == kNoStatement) continue;
    Loop& loop = loops[group[id]];
    if (loop.entry == kNoRecord) loop.entry = id;
    if (loop.first == kNoStatement || here < loop.first) loop.first = here;
    if (warned_.contains(id) && (loop.warned == kNoStatement || here < loop.warned)) loop.warned = here;
  }
  for (auto& [number, loop] : loops) {
    for (RecordId id = loop.entry; loop.warned == kNoStatement && id != kNoRecord; id = trace_->at(id).parent) {
      if (warned_.contains(id)) loop.warned = trace_->at(id).statement;
    }
    if (loop.warned == kNoStatement) continue;
    hazards_.emplace(std::make_tuple(HazardKind::kHang, loop.warned, kNoStatement, 0U),
                     Hazard{HazardKind::kHang, loop.warned, loop.first, 0, Reach::kMaybe, StopKind::kNone, "", {}, {}});
  }
}

}  // namespace owlint::flow
