#include "analyzer/flow/engine/call_memo.h"

#include "analyzer/flow/engine/calls.h"

namespace owlint::flow {
namespace {

/// Whether a call has left everything but the flags, which are part of its outcome, as it was.
bool leaves_nothing(const State& entry, const State& exit) {
  const auto same = [](const PersistentMap& a, const PersistentMap& b) { return a.hash() == b.hash(); };
  return same(entry.table, exit.table) && same(entry.parameters.globals, exit.parameters.globals) &&
      same(entry.parameters.global_outcomes, exit.parameters.global_outcomes) && entry.counts == exit.counts &&
      entry.flags.breaking == exit.flags.breaking && entry.flags.continuing == exit.flags.continuing &&
      entry.parameters.outside == exit.parameters.outside;
}

}  // namespace

const CallOutcome* CallMemo::find(ContextId context, const Context& callee, const State& entry) {
  if (precision_.coarse() || callee.contour) return nullptr;
  std::optional<std::string> key = keys_.of(callee, entry, precision_.level());
  if (!key) return nullptr;
  const CallOutcome* outcome = known_.find(*key);
  if (outcome != nullptr && precision_.lasts(outcome->steps)) return outcome;
  if (context >= recorded_.size()) recorded_.resize(context + 1);
  recorded_[context] = std::make_unique<Recorded>(Recorded{std::move(*key), entry, precision_.level(), 0, false, {}});
  return nullptr;
}

void CallMemo::count_step(ContextId context) {
  Recorded* call = recorded(context);
  if (call == nullptr) return;
  ++call->steps;
  if (precision_.level() != call->level) call->disturbed = true;
}

void CallMemo::disturb(ContextId context) {
  if (Recorded* call = recorded(context)) call->disturbed = true;
}

std::vector<LearnedCall> CallMemo::learned(const Calls& calls, const Partitions& partitions, Trace& trace,
                                           const std::vector<bool>& stuck) {
  const std::vector<bool>& hanging = trace.hanging();
  for (ContextId id = 0; id < calls.size(); ++id) {
    const Frame& frame = calls[id];
    // In a program that never ends, all loops on the way are reported.
    if (frame.known && hanging[frame.exits.front().record]) trace.miss_left_out();
    Recorded* call = recorded(id);
    if (call == nullptr) continue;
    const Region& region = program_.regions[program_.region_of[call->entry.position]];
    call->lines.resize(region.end + 1 - region.opener);
    if (frame.exits.size() != 1 || frame.joined_exit != Frame::kNoExit || frame.joined_entry != nullptr ||
        !leaves_nothing(call->entry, frame.exits.front()))
      call->disturbed = true;
  }
  for (const Partition& partition : partitions.all()) {
    Recorded* call = recorded(partition.context);
    if (call == nullptr || call->disturbed) continue;
    for (const auto& [hash, record] : partition.seen) {
      const StatementId line = partition.position - call->entry.position;  // wraps for lines before
      if (hanging[record] || stuck[record] || line >= call->lines.size())
        call->disturbed = true;
      else if (trace.at(record).executed)
        call->lines[line] = true;
    }
  }
  std::vector<LearnedCall> out;
  for (ContextId id = 0; id < recorded_.size(); ++id) {
    Recorded* call = recorded(id);
    if (call == nullptr || call->disturbed) continue;
    const State& exit = calls[id].exits.front();
    out.push_back(
        {std::move(call->key),
         {exit.flags.executed, exit.flags.returned, exit.joined, exit.mixed, std::move(call->lines), call->steps},
         call->entry.position});
  }
  return out;
}

}  // namespace owlint::flow
