#include "analyzer/flow/engine/iteration.h"

#include <algorithm>

#include "analyzer/flow/interpreter/new_machine.h"

namespace owlint::flow {

Iteration::Iteration(const Linked& linked, const Profile& profile, Detail detail, KnownCalls* known,
                     const Limits& limits, ModeMask modes)
    : linked_(linked),
      program_(linked.program()),
      profile_(profile),
      limits_(limits),
      passes_over_(detail != Detail::kStepwise),
      machine_(linked, profile, limits, pool_, modes),
      precision_(limits, detail != Detail::kBySize || program_.size() > limits.followed_statements),
      trace_(std::make_shared<Trace>(limits, program_.size())),
      separation_(program_, machine_, precision_, limits),
      partitions_(program_, machine_, separation_, precision_, memory_),
      // Under FEATURE 0x20 any label may lead out of a sub.
      memo_(known != nullptr && !profile.warn_only()
                ? std::optional<CallMemo>(std::in_place, *known, linked, machine_, precision_)
                : std::nullopt),
      calls_(machine_, limits, precision_, separation_, worklist_, *trace_, memo_ ? &*memo_ : nullptr, memory_),
      marked_(program_.size()) {}

void Iteration::start(Machines machines) {
  follow_precision();
  State state;
  if (program_.sub_file) {
    const uint16_t built_in = machine_.remapped_codes().built_in_within(program_.name(program_.entry));
    calls_.begin({.sub = program_.entry,
                  .depth = 1,
                  .passed = 30,
                  .remaps = static_cast<uint8_t>(built_in != 0),
                  .built_in = built_in},
                 true);
    state.skip = machine_.full_label(kGlobalScope, program_.entry);
    state.seek = true;
    state.parameters.outside = true;
    machine_.modes().begin_level(state.parameters);
    machine_.evaluator().expect_from_outside(program_.name(program_.entry), state.parameters);
  } else {
    calls_.begin({}, false);
    machine_.modes().set(state.parameters, machine_.start());
    machine_.modes().apply(state.parameters, program_.syntax.first_changes);
    // Lines before that one are not carried out again, for its numbers are known.
    if (machine_.mode_uses().follows_place())
      machine_.modes().set_place(state.parameters, program_.syntax.place_at_start);
    if (program_.syntax.runs_python) machine_.evaluator().expect_from_python(state.parameters);
  }
  // The first record is that of any machine: what all its runs pass, those of a new one pass as well.
  successor(state);
  if (machines == Machines::kAlsoNew && !coarse_ && !program_.sub_file) start_new_machine(std::move(state));
}

void Iteration::start_new_machine(State state) {
  unset_ = read_and_not_set(program_, machine_.tracked());
  if (unset_.empty() && !program_.syntax.reads_place) return;
  begin_on_new_machine(unset_, state.parameters, machine_.evaluator(), pool_);
  state.mixed = true;
  successor(std::move(state));
}

void Iteration::run(Events& events, Machines machines) {
  events_ = &events;
  start(machines);
  while (!worklist_.empty()) {
    // All states that wait at the foremost line arrive together.
    const StatementId position = worklist_.position();
    while (!worklist_.empty() && worklist_.position() == position) arrive(worklist_.take());
    for (const uint32_t number : partitions_.take_joined()) execute_joined(partitions_[number]);
  }
}

void Iteration::successor(State state) { worklist_.add(machine_.skip_ahead(std::move(state))); }

/// Takes in a state that arrives at its line. New ones are executed at once; where there are many already they are
/// joined, and the join waits until all that arrive together are in it.
void Iteration::arrive(State state) {
  Partition& partition = partitions_.at(state);
  const uint64_t hash = state.hash();
  if (const RecordId known = partition.find(hash); known != kNoRecord) {
    if (state.record != kNoRecord) trace_->link(state.record, known, state.branch);
  } else if (partitions_.joins(state, partition)) {
    events_->joined(state, partition);
    partitions_.join(std::move(state), partition);
  } else {
    execute(std::move(state), partition, hash);
  }
}

void Iteration::execute_joined(Partition& partition) {
  partition.waits = false;
  State state = *partition.joined;
  const uint64_t hash = state.hash();
  const std::vector<std::pair<RecordId, Branch>> parents(partition.parents.begin(), partition.parents.end());
  partition.parents.clear();
  RecordId record = partition.find(hash);
  if (record == kNoRecord) {
    record = static_cast<RecordId>(trace_->size());  // the one that execute() makes next
    execute(std::move(state), partition, hash);
  }
  for (const auto& [parent, branch] : parents) {
    if (trace_->at(record).parent != parent || trace_->at(record).branch != branch)
      trace_->link(parent, record, branch);
  }
}

void Iteration::execute(State state, Partition& partition, uint64_t hash) {
  const Context context = calls_[state.context].info;
  const bool at_file_end = linked_.at_end(state.position);
  bool executed = !at_file_end;
  if (state.skip != kNoLabel && !at_file_end) executed = machine_.is_target(state, context);
  const RecordId record =
      trace_->add({state.record, at_file_end ? kNoStatement : state.position, state.branch, executed, false});
  if (executed) trace_->mark_executed(state.position);
  partition.seen.emplace_back(hash, record);
  state.record = record;
  precision_.count(1);
  follow_precision();
  if (memo_) memo_->count_step(state.context);
  events_->executed(state);
  if (at_file_end) return events_->end_of_file(state);
  if (const CalmStretch* stretch = machine_.pass_over(state, context)) {
    mark_executed(*stretch);
    return successor(std::move(state));
  }
  machine_.step(std::move(state), context, *this);
}

void Iteration::follow_precision() {
  if (coarse_ || !precision_.coarse()) return;
  coarse_ = true;
  machine_.set_coarse(passes_over_);
}

void Iteration::mark_executed(const CalmStretch& stretch) {
  const auto definitions = machine_.defined_in(stretch);
  auto defined = definitions.begin();
  for (StatementId id = stretch.first; id < stretch.last; ++id) {
    trace_->mark_executed(id);
    if (defined == definitions.end() || *defined != id) continue;
    // Of a definition only its two ends are executed; its lines are when it is called.
    id = program_.regions[program_.region_of[id]].end;
    trace_->mark_executed(id);
    ++defined;
  }
  for (const StatementId opener : machine_.called_in(stretch)) {
    if (marked_[opener]) continue;
    marked_[opener] = true;
    const Region& region = program_.regions[program_.region_of[opener]];
    for (StatementId id = opener; id <= region.end; ++id) trace_->mark_executed(id);
  }
}

void Iteration::stop(const State& at, StopReport report) {
  if (memo_) memo_->disturb(at.context);
  events_->stop(at, std::move(report));
}

void Iteration::hazard(const State& at, HazardReport report) {
  if (memo_) memo_->disturb(at.context);
  events_->hazard(at, std::move(report));
}

void Iteration::call(const State& at, State entry, Context callee, int repeats) {
  calls_.call(at, std::move(entry), callee, repeats);
}

void Iteration::leave(const State& at) {
  if (!calls_.leave(at)) events_->end(at);
}

std::shared_ptr<std::vector<LearnedCall>> Iteration::learned_calls(const std::vector<bool>& stuck) {
  if (!memo_) return nullptr;
  return std::make_shared<std::vector<LearnedCall>>(memo_->learned(calls_, partitions_, *trace_, stuck));
}

std::vector<std::string> Iteration::computed_calls() const {
  std::vector<std::string> names;
  for (const NameId id : machine_.computed_calls()) names.push_back(machine_.name(id));
  std::ranges::sort(names);
  return names;
}

FlowStatistics Iteration::statistics() const {
  return {precision_.steps(), partitions_.joined_states() + calls_.joined_states(), calls_.recalled()};
}

}  // namespace owlint::flow
