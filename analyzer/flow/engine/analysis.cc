// Runs the machine over all branch outcomes until nothing new appears. States that meet at a line in the same mode
// are kept apart while they are few and joined when they are many; calls that begin alike are analysed once. So the
// cost grows with the program, never with the number of its paths.
#include "analyzer/flow/engine/analysis.h"

#include <algorithm>

namespace owlint::flow {

void Analysis::start() {
  called_calmly_.resize(program_.size());
  if (coarse()) machine_.set_coarse(passes_over_);
  State state;
  Frame main(&memory_);
  if (program_.sub_file) {
    main.info = {program_.entry, 1, false, 30};
    main.outside = true;
    state.skip = machine_.full_label(kGlobalScope, program_.entry);
    state.seek = true;
    state.parameters.outside = true;
    machine_.evaluator().expect_from_outside(program_.name(program_.entry), state.parameters);
  }
  frames_.push_back(std::move(main));
  successor(std::move(state));
}

FlowResult Analysis::run() {
  start();
  while (!queue_.empty()) {
    // All states that wait at the foremost line arrive together.
    const StatementId position = queue_.top().position;
    while (!queue_.empty() && queue_.top().position == position) {
      const uint32_t slot = queue_.top().state;
      queue_.pop();
      State state = std::move(waiting_[slot]);
      free_.push_back(slot);
      arrive(std::move(state));
    }
    std::vector<uint32_t> dirty;
    dirty.swap(dirty_);
    for (const uint32_t group : dirty) execute_joined(group);
  }
  finish();
  return std::move(result_);
}

void Analysis::push(State state) {
  uint32_t slot = 0;
  const StatementId position = state.position;
  if (free_.empty()) {
    slot = static_cast<uint32_t>(waiting_.size());
    waiting_.push_back(std::move(state));
  } else {
    slot = free_.back();
    free_.pop_back();
    waiting_[slot] = std::move(state);
  }
  queue_.push({position, order_++, slot});
}

void Analysis::successor(State state) { push(machine_.skip_ahead(std::move(state))); }

Analysis::Group& Analysis::group_at(const State& state) {
  constexpr uint32_t kFew = 8;  // more groups than this at one place are not gone through one by one
  const uint8_t executed = state.skip == kNoLabel ? uint8_t{0} : state.flags.executed;
  const auto hash = [](const auto& mode, uint8_t taken, StatementId position) {
    const uint64_t where = mix(mix(mix(position, mode.context), mode.skip), mode.defining);
    return mix(
        where,
        static_cast<uint64_t>(taken) << 2 | static_cast<uint64_t>(mode.seek) << 1 | static_cast<uint64_t>(mode.looped));
  };
  const auto fits = [&](const Group& g) {
    return g.position == state.position && g.context == state.context && g.skip == state.skip &&
        g.defining == state.defining && g.seek == state.seek && g.looped == state.looped && g.executed == executed;
  };
  uint32_t& head = heads_[state.position];
  const uint32_t rank = head == UINT32_MAX ? 0 : groups_[head].rank + 1;
  if (rank <= kFew) {
    for (uint32_t i = head; i != UINT32_MAX; i = groups_[i].next) {
      if (fits(groups_[i])) return groups_[i];
    }
  } else {
    const auto [first, last] = crowds_.equal_range(hash(state, executed, state.position));
    for (auto found = first; found != last; ++found) {
      if (fits(groups_[found->second])) return groups_[found->second];
    }
  }
  const auto number = static_cast<uint32_t>(groups_.size());
  groups_.push_back({state.position, number, rank, state.context, state.skip, state.defining, state.seek, state.looped,
                     executed, head, std::pmr::vector<std::pair<uint64_t, RecordId>>(&memory_), nullptr,
                     std::pmr::vector<std::pair<RecordId, Branch>>(&memory_), false});
  head = number;
  if (rank == kFew) {
    for (uint32_t i = head; i != UINT32_MAX; i = groups_[i].next)
      crowds_.emplace(hash(groups_[i], groups_[i].executed, state.position), i);
  } else if (rank > kFew) {
    crowds_.emplace(hash(state, executed, state.position), number);
  }
  return groups_.back();
}

RegionId Analysis::region_at(StatementId position) const {
  return position < program_.size() ? program_.region_of[position] : kMainRegion;
}

/// The operations of a sub, or of the main program, that can fail: the first ones, for they are computed often.
const std::vector<ExprId>& Analysis::fragile_in(RegionId region) {
  const auto [known, is_new] = fragile_.try_emplace(region);
  if (is_new) {
    const bool is_main = region == kMainRegion;
    const StatementId first = is_main ? 0 : program_.regions[region].opener;
    const StatementId last = is_main ? static_cast<StatementId>(program_.size()) : program_.regions[region].last;
    for (StatementId id = first; id < last && known->second.size() < limits_.fallible_operations; ++id) {
      if (program_.region_of[id] == region) machine_.evaluator().note_fragile(program_.at(id), known->second);
    }
  }
  return known->second;
}

/// Whether one more state is joined with others where there are `there` already. What will make an operation of `region`
/// fail is kept apart longer: among other values the stop would not be seen.
bool Analysis::joins(const State& state, RegionId region, size_t there, size_t most) {
  if (there < most) return false;
  if (coarse() || there >= 2 * most) return true;
  const Parameters& p = state.parameters;
  const auto [known, is_new] = failing_.try_emplace(mix(
      mix(p.locals.hash(), p.globals.hash()), static_cast<uint64_t>(region) << 1 | static_cast<uint64_t>(p.outside)));
  if (is_new) known->second = machine_.evaluator().will_fail(fragile_in(region), p);
  return !known->second;
}

/// Takes in a state that arrives at its line. New ones are executed at once; where there are many already they are
/// joined, and the join waits until all that arrive together are in it.
void Analysis::arrive(State state) {
  Group& group = group_at(state);
  const uint64_t hash = state.hash();
  if (const RecordId known = group.find(hash); known != kNoRecord) {
    if (state.record != kNoRecord) trace_->link(state.record, known, state.branch);
    return;
  }
  if (!joins(state, region_at(state.position), group.seen.size(), level().states))
    return execute(std::move(state), group, hash);
  ++result_.statistics.merges;
  if (state.record != kNoRecord) group.parents.emplace_back(state.record, state.branch);
  if (group.joined == nullptr) {
    group.joined = std::make_unique<State>(std::move(state));
  } else {
    State joined = machine_.states().join(*group.joined, state);
    joined.record = state.record;
    joined.branch = state.branch;
    *group.joined = std::move(joined);
  }
  if (!group.dirty) dirty_.push_back(group.number);
  group.dirty = true;
}

void Analysis::execute_joined(uint32_t index) {
  Group& group = groups_[index];
  group.dirty = false;
  State state = *group.joined;
  const uint64_t hash = state.hash();
  const std::vector<std::pair<RecordId, Branch>> parents(group.parents.begin(), group.parents.end());
  group.parents.clear();
  RecordId record = group.find(hash);
  if (record == kNoRecord) {
    record = static_cast<RecordId>(trace_->size());  // the one that execute() makes next
    execute(std::move(state), group, hash);
  }
  for (const auto& [parent, branch] : parents) {
    if (trace_->at(record).parent != parent || trace_->at(record).branch != branch)
      trace_->link(parent, record, branch);
  }
}

void Analysis::execute(State state, Group& group, uint64_t hash) {
  const bool at_file_end = linked_.at_end(state.position);
  bool executed = !at_file_end;
  if (state.skip != kNoLabel && !at_file_end) executed = machine_.is_target(state, frames_[state.context].info);
  const RecordId record =
      trace_->add({state.record, at_file_end ? kNoStatement : state.position, state.branch, executed, false});
  if (executed) result_.executed[state.position] = true;
  group.seen.emplace_back(hash, record);
  state.record = record;
  count_steps(1);
  if (Watch* watch = frames_[state.context].watch.get(); watch != nullptr) {
    ++watch->steps;
    if (level_ != watch->level) watch->disturbed = true;
  }
  if (at_file_end) return end_of_file(state);
  if (const CalmStretch* stretch = machine_.pass_over(state, frames_[state.context].info)) {
    mark_executed(*stretch);
    return successor(std::move(state));
  }
  const Context context = frames_[state.context].info;
  machine_.step(std::move(state), context, *this);
}

void Analysis::count_steps(uint64_t steps) {
  result_.statistics.steps += steps;
  while (result_.statistics.steps >= level().steps) {
    ++level_;
    if (coarse()) machine_.set_coarse(passes_over_);
  }
}

void Analysis::mark_executed(const CalmStretch& stretch) {
  const auto definitions = machine_.defined_in(stretch);
  auto defined = definitions.begin();
  for (StatementId id = stretch.first; id < stretch.last; ++id) {
    result_.executed[id] = true;
    if (defined == definitions.end() || *defined != id) continue;
    // Of a definition only its two ends are executed; its lines are when it is called.
    id = program_.regions[program_.region_of[id]].end;
    result_.executed[id] = true;
    ++defined;
  }
  for (const StatementId opener : machine_.called_in(stretch)) {
    if (called_calmly_[opener]) continue;
    called_calmly_[opener] = true;
    const Region& region = program_.regions[program_.region_of[opener]];
    for (StatementId id = opener; id <= region.end; ++id) result_.executed[id] = true;
  }
}

ContextId Analysis::context_for(const Context& callee, const State& entry, bool* merged) {
  State key_state = entry;
  key_state.context = 0;
  const CallKind kind{callee.sub, callee.depth, callee.fanuc, callee.passed, callee.contour};
  const auto key = std::make_pair(kind, key_state.hash());
  *merged = false;
  if (const auto found = contexts_.find(key); found != contexts_.end()) return found->second;
  auto& [count, shared] = context_counts_.try_emplace(kind, 0, 0).first->second;
  if (joins(entry, region_at(entry.position), count, level().contexts)) {
    *merged = true;
    if (shared != 0) return shared;
  }
  frames_.emplace_back(&memory_).info = callee;
  const auto id = static_cast<ContextId>(frames_.size() - 1);
  if (*merged) {
    shared = id;
  } else {
    ++count;
    contexts_.emplace(key, id);
  }
  return id;
}

void Analysis::call(const State& at, State entry, Context callee, int repeats) {
  bool merged = false;
  const ContextId id = context_for(callee, entry, &merged);
  Frame& frame = frames_[id];
  const bool first = frame.callers.empty();
  if (!merged && first) recall(id, at, entry);
  entry.context = id;
  entry.record = at.record;
  const Caller caller{at, repeats};
  const uint64_t caller_hash =
      mix(at.hash(), (static_cast<uint64_t>(at.context) << 32) + static_cast<uint32_t>(repeats));
  if (frame.caller_hashes.insert(caller_hash).second) frame.callers.push_back(caller);
  if (merged) {
    ++result_.statistics.merges;
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
    successor(std::move(entry));  // an equal one is recognised on arrival
  } else if (!first) {
    trace_->link(at.record, frame.exits.front().record);
  }
  for (size_t i = 0; i < frames_[id].exits.size(); ++i) {
    const State exit = frames_[id].exits[i];
    resume_one(caller, exit, frames_[id]);
  }
}

void Analysis::resume_one(const Caller& caller, const State& exit, Frame& frame) {
  State after = machine_.resume(caller.state, exit, frame.info, frame.joined_entry != nullptr);
  if (frames_[caller.state.context].info.depth == 0) after.flags.returned = kYes;
  // The way back is a record of its own, so that "every run" and "never ends" see it.
  const bool shared = frame.callers.size() > 1;
  after.record = trace_->add({shared ? caller.state.record : exit.record, kNoStatement, Branch::kNone, false, true});
  if (shared) trace_->link(exit.record, after.record);
  trace_->come_back(caller.state.record, after.record);
  // M98 with L: the call is made again. A few times are counted; more, or an unknown number, run the line again.
  if (caller.repeats > 1 && caller.repeats <= limits_.counted_repeats) {
    const FullLabel label = machine_.full_label(kGlobalScope, frame.info.sub);
    const Definers::Set set = machine_.definers().get(after.table.get(label));
    if (set.lines.empty()) return;
    after.position = caller.state.position;
    State entry = after;
    entry.position = set.lines.front();
    return call(after, std::move(entry), frame.info, caller.repeats - 1);
  }
  if (caller.repeats != 1) {
    State again = after;
    again.position = caller.state.position;
    successor(std::move(again));
  }
  successor(std::move(after));
}

void Analysis::leave(const State& at) {
  Frame& frame = frames_[at.context];
  if (frame.outside) return end(at);
  State exit = at;
  exit.position = 0;
  exit.context = 0;
  if (joins(exit, region_at(frame.callers.front().state.position), frame.exits.size(), level().states)) {
    ++result_.statistics.merges;
    if (frame.joined_exit == nullptr) {
      frame.joined_exit = std::make_unique<State>(exit);
    } else {
      *frame.joined_exit = machine_.states().join(*frame.joined_exit, exit);
    }
    exit = *frame.joined_exit;
    exit.record = at.record;
  }
  if (!frame.info.fanuc) exit.parameters.locals = exit.parameters.local_facts = PersistentMap();
  exit.skip = kNoLabel;
  exit.seek = false;
  const uint64_t hash = exit.hash();
  if (const auto known = std::ranges::find(frame.exit_hashes, hash); known != frame.exit_hashes.end()) {
    trace_->link(at.record, frame.exits[known - frame.exit_hashes.begin()].record);
    return;
  }
  frame.exits.push_back(exit);
  frame.exit_hashes.push_back(hash);
  for (const Caller& caller : frame.callers) resume_one(caller, exit, frame);
}

std::vector<std::string> Analysis::computed_calls() const {
  std::vector<std::string> names;
  for (const NameId id : machine_.computed_calls()) names.push_back(machine_.name(id));
  std::ranges::sort(names);
  return names;
}

/// A call that begins like none before in this analysis: its outcome may be known from an earlier one.
void Analysis::recall(ContextId context, const State& at, const State& entry) {
  if (!memory_of_calls_ || coarse() || frames_[context].info.contour) return;
  std::optional<std::string> key = memory_of_calls_->keys.of(frames_[context].info, entry, level_);
  if (!key) return;
  Frame& frame = frames_[context];
  const CallOutcome* outcome = memory_of_calls_->known.find(*key);
  const bool joins_more = outcome != nullptr && result_.statistics.steps + outcome->steps >= level().steps;
  if (outcome == nullptr || joins_more) {
    frame.watch = std::make_unique<Watch>(Watch{std::move(*key), entry, level_, 0, false, {}});
    return;
  }
  frame.known = true;
  ++result_.statistics.recalled;
  count_steps(outcome->steps);
  const StatementId opener = entry.position;
  for (StatementId i = 0; i < outcome->lines.size(); ++i) {
    if (outcome->lines[i]) result_.executed[opener + i] = true;
  }
  trace_->leave_out(opener + 1, opener + static_cast<StatementId>(outcome->lines.size()));
  State exit = entry;
  exit.position = 0;
  exit.context = 0;
  exit.flags.executed = outcome->executed;
  exit.flags.returned = outcome->returned;
  exit.joined = outcome->joined;
  exit.mixed = outcome->mixed;
  exit.parameters.locals = exit.parameters.local_facts = PersistentMap();
  exit.branch = Branch::kNone;
  exit.record = trace_->add({at.record, opener, Branch::kNone, true, false});
  frame.exit_hashes.push_back(exit.hash());
  frame.exits.push_back(std::move(exit));
}

void Analysis::disturb(ContextId context) {
  if (frames_[context].watch != nullptr) frames_[context].watch->disturbed = true;
}

}  // namespace owlint::flow

namespace owlint {

Reach FlowResult::reach(StatementId statement) const { return trace->reach(first + statement); }

std::vector<FlowResult> analyze_flow(Linked& linked, const Profile& profile, Detail detail, flow::KnownCalls* known,
                                     const flow::Limits& limits) {
  for (int round = 1;; ++round) {
    flow::Analysis analysis(linked, profile, detail, known, limits);
    FlowResult result = analysis.run();
    bool grown = false;
    for (const std::string& name : analysis.computed_calls()) grown |= linked.add(name);
    if (grown && round < limits.rounds) continue;
    if (linked.files().size() == 1) result.structure = analysis.structure();
    return flow::by_file(linked, std::move(result));
  }
}

}  // namespace owlint
