#include "analyzer/flow/engine/calls.h"

#include <algorithm>

namespace owlint::flow {

void Calls::begin(const Context& info, bool outside) {
  Frame& frame = frames_.emplace_back(&memory_);
  frame.info = info;
  frame.outside = outside;
}

ContextId Calls::context_for(const Context& callee, const State& entry, bool* joined) {
  const Kind kind{callee.sub,     callee.depth,  callee.fanuc,    callee.passed,
                  callee.contour, callee.remaps, callee.built_in, callee.remap};
  const auto key = std::make_pair(kind, entry.hash());
  *joined = false;
  if (const auto found = contexts_.find(key); found != contexts_.end()) return found->second;
  auto& [count, shared] = counts_.try_emplace(kind, 0, 0).first->second;
  if (separation_.joins(entry, entry.position, count, precision_.now().contexts)) {
    *joined = true;
    if (shared != 0) return shared;
  }
  frames_.emplace_back(&memory_).info = callee;
  const auto id = static_cast<ContextId>(frames_.size() - 1);
  if (*joined) {
    shared = id;
  } else {
    ++count;
    contexts_.emplace(key, id);
  }
  return id;
}

void Calls::call(const State& at, State entry, const Context& callee, int repeats) {
  enter(at, std::move(entry), callee, repeats);
  come_back();
}

void Calls::enter(const State& at, State entry, const Context& callee, int repeats) {
  bool joined = false;
  const ContextId id = context_for(callee, entry, &joined);
  Frame& frame = frames_[id];
  const bool first = frame.callers.empty();
  if (!joined && first && memo_ != nullptr) recall(id, at, entry);
  entry.context = id;
  entry.record = at.record;
  Caller* const caller = add_caller(frame, at, repeats);
  if (joined) {
    ++joined_states_;
    if (frame.joined_entry == nullptr || frame.joined_entry->position != entry.position ||
        frame.joined_entry->skip != entry.skip) {
      frame.joined_entry = std::make_unique<State>(entry);
    } else {
      *frame.joined_entry = machine_.states().join(*frame.joined_entry, entry);
      frame.joined_entry->record = at.record;
      entry = *frame.joined_entry;
    }
  }
  if (!frame.known) {
    worklist_.add(machine_.skip_ahead(std::move(entry)));  // an equal one is recognised on arrival
  } else if (!first) {
    trace_.link(at.record, frame.exits.front().record);
  }
  for (size_t exit = 0; caller != nullptr && exit < frame.exits.size(); ++exit) returns_.push_back({caller, id, exit});
}

/// Whether one state holds all that another holds.
bool Calls::holds(const State& all, const State& some) {
  return machine_.states().join(all, some).hash() == all.hash();
}

/// Null for a caller that was there before. Where states at the call's line were joined and one more is joined with them, the
/// result takes the place of the first join, so that calls come back to the last one only.
Caller* Calls::add_caller(Frame& frame, const State& at, int repeats) {
  const uint64_t place = mix((static_cast<uint64_t>(at.context) << 32) + static_cast<uint32_t>(repeats), at.position);
  if (!frame.caller_hashes.insert(mix(at.hash(), place)).second) return nullptr;
  if (!at.joined) return &frame.callers.emplace_back(Caller{at, repeats});
  Caller*& last = frame.joined_callers[place];
  if (last != nullptr && holds(at, last->state)) {
    last->state = at;
  } else {
    last = &frame.callers.emplace_back(Caller{at, repeats});
  }
  return last;
}

/// Returns are made one after the other: one that repeats its call may add callers and returns.
void Calls::come_back() {
  while (!returns_.empty()) {
    const Return back = returns_.front();
    returns_.pop_front();
    resume(back);
  }
}

void Calls::resume(const Return& back) {
  const Caller& caller = *back.caller;
  const Frame& frame = frames_[back.callee];
  const State& exit = frame.exits[back.exit];
  State after = machine_.resume(caller.state, exit, frame.info, frame.joined_entry != nullptr);
  if (frames_[caller.state.context].info.depth == 0) after.flags.returned = kYes;
  // The way back is a record of its own, so that "every run" and "never ends" see it.
  const bool shared = frame.callers.size() > 1;
  const RecordId exit_record = exit.record;
  after.record = trace_.add({shared ? caller.state.record : exit_record, kNoStatement, Branch::kNone, false, true});
  if (shared) trace_.link(exit_record, after.record);
  trace_.come_back(caller.state.record, after.record);
  // M98 with L: the call is made again. A few times are counted; more, or an unknown number, run the line again.
  if (caller.repeats > 1 && caller.repeats <= limits_.counted_repeats) {
    const FullLabel label = machine_.full_label(kGlobalScope, frame.info.sub);
    const Definers::Set set = machine_.definers().get(after.table.get(label));
    if (set.lines.empty()) return;
    after.position = caller.state.position;
    State entry = after;
    entry.position = set.lines.front();
    return enter(after, std::move(entry), frame.info, caller.repeats - 1);
  }
  if (caller.repeats != 1) {
    State again = after;
    again.position = caller.state.position;
    worklist_.add(std::move(again));
  }
  worklist_.add(std::move(after));
}

bool Calls::leave(const State& at) {
  Frame& frame = frames_[at.context];
  if (frame.outside) return false;
  State exit = at;
  exit.position = 0;
  exit.context = 0;
  if (!frame.info.fanuc) exit.parameters.locals = exit.parameters.local_outcomes = PersistentMap();
  exit.skip = kNoLabel;
  exit.seek = false;
  exit.branch = Branch::kNone;
  exit.looped = false;
  const uint64_t hash = exit.hash();
  size_t number = static_cast<size_t>(std::ranges::find(frame.exit_hashes, hash) - frame.exit_hashes.begin());
  if (number < frame.exits.size()) {
    trace_.link(at.record, frame.exits[number].record);
    return true;
  }
  if (separation_.joins(exit, frame.callers.front().state.position, frame.exits.size(), precision_.now().states)) {
    if (!join_exit(frame, std::move(exit))) return true;
    number = frame.joined_exit;
  } else {
    frame.exits.push_back(std::move(exit));
    frame.exit_hashes.push_back(hash);
  }
  for (const Caller& caller : frame.callers) returns_.push_back({&caller, at.context, number});
  come_back();
  return true;
}

/// False if the exits that were joined before hold this one. All of them are one exit with a record of its own: callers come back
/// from that only, however often something was joined.
bool Calls::join_exit(Frame& frame, State exit) {
  ++joined_states_;
  if (frame.joined_exit == Frame::kNoExit) {
    frame.joined_exit = frame.exits.size();
    const RecordId from = exit.record;
    exit.record = trace_.add({from, kNoStatement, Branch::kNone, false, false});
    frame.exit_hashes.push_back(exit.hash());
    frame.exits.push_back(std::move(exit));
    return true;
  }
  State& all = frame.exits[frame.joined_exit];
  trace_.link(exit.record, all.record);
  State joined = machine_.states().join(all, exit);
  const uint64_t hash = joined.hash();
  if (hash == frame.exit_hashes[frame.joined_exit]) return false;
  all = std::move(joined);
  frame.exit_hashes[frame.joined_exit] = hash;
  return true;
}

/// A call that begins like none before in this analysis: its outcome may be known from an earlier one.
void Calls::recall(ContextId context, const State& at, const State& entry) {
  Frame& frame = frames_[context];
  const CallOutcome* outcome = memo_->find(context, frame.info, entry);
  if (outcome == nullptr) return;
  frame.known = true;
  ++recalled_;
  precision_.count(outcome->steps);
  const StatementId opener = entry.position;
  for (StatementId i = 0; i < outcome->lines.size(); ++i) {
    if (outcome->lines[i]) trace_.mark_executed(opener + i);
  }
  trace_.leave_out(opener + 1, opener + static_cast<StatementId>(outcome->lines.size()));
  State exit = entry;
  exit.position = 0;
  exit.context = 0;
  exit.parameters.locals = exit.parameters.local_outcomes = PersistentMap();
  exit.flags.executed = outcome->executed;
  exit.flags.returned = outcome->returned;
  exit.joined = outcome->joined;
  exit.mixed = outcome->mixed;
  exit.branch = Branch::kNone;
  exit.record = trace_.add({at.record, opener, Branch::kNone, true, false});
  frame.exit_hashes.push_back(exit.hash());
  frame.exits.push_back(std::move(exit));
}

StatementId Calls::call_of(const Linked& linked, ContextId context, StatementId at) const {
  StatementId call = kNoStatement;
  const uint32_t file = linked.file_of(at);
  for (int depth = 0; depth <= kMaxCallDepth && !frames_[context].callers.empty(); ++depth) {
    const State& caller = frames_[context].callers.front().state;
    call = caller.position;
    if (file == 0 && frames_[context].joined_entry != nullptr) return kNoStatement;
    if (file == 0 || linked.file_of(call) != file) break;
    context = caller.context;
  }
  return call;
}

bool Calls::recursion_comes_back(ContextId context) const {
  std::vector<NameId> seen;
  std::vector<NameId> back;
  for (int depth = 0; depth <= kMaxCallDepth && !frames_[context].callers.empty(); ++depth) {
    const Frame& frame = frames_[context];
    seen.push_back(frame.info.sub);
    if (!frame.exits.empty()) back.push_back(frame.info.sub);
    context = frame.callers.front().state.context;
  }
  return std::ranges::any_of(back, [&](NameId sub) { return std::ranges::count(seen, sub) > 1; });
}

}  // namespace owlint::flow
