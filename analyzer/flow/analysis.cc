// Runs the machine over all branch outcomes until nothing new appears. States that meet at a line in the same mode
// are kept apart while they are few and joined when they are many; calls that begin alike are analysed once. So the
// cost grows with the program, never with the number of its paths.
#include <algorithm>
#include <deque>
#include <map>
#include <queue>
#include <unordered_set>

#include "analyzer/flow/machine.h"
#include "analyzer/flow/trace.h"

namespace owlint::flow {
namespace {

// How many states are kept apart at one place. Small programs are followed almost path by path; the further an
// analysis goes on, the more it joins.
struct Patience {
  uint64_t steps;
  size_t states;
  size_t contexts;
};
constexpr Patience kPatience[] = {{60'000, 64, 32}, {200'000, 8, 4}, {UINT64_MAX, 1, 1}};
constexpr size_t kCoarse = 2;  // from this level on, constants are not told apart either

constexpr uint32_t kNormalEnd = 0;

class Analysis final : public Listener {
 public:
  Analysis(Program& program, const Profile& profile)
      : program_(program), machine_(program, profile, pool_), heads_(program.size() + 1, UINT32_MAX),
        trace_(std::make_shared<Trace>()) {
    result_.executed.resize(program.size());
  }

  FlowResult run();

  void successor(State state) override;
  void stop(const State& at, StopKind kind, StatementId other, std::string message, std::string detail) override;
  void hazard(const State& at, HazardKind kind, uint32_t number, StopKind warned, std::string message) override;
  void end(const State& at) override { trace_->terminate(at.record, kNormalEnd); result_.ends = true; }
  void call(const State& at, State entry, Context callee, int repeats) override;
  void leave(const State& at) override;

 private:
  /// All states at one line in one mode (same call, same skip).
  struct Group {
    ContextId context;
    FullLabel skip;
    NameId defining;
    bool seek;
    bool looped;
    uint32_t next;
    std::vector<std::pair<uint64_t, RecordId>> seen;
    std::unique_ptr<State> joined;
    std::vector<RecordId> parents;  ///< records whose states wait in `joined`
    bool dirty;

    RecordId find(uint64_t hash) const {
      const auto found = std::ranges::find(seen, hash, &std::pair<uint64_t, RecordId>::first);
      return found == seen.end() ? kNoRecord : found->second;
    }
  };
  struct Caller {
    State state;
    int repeats;
  };
  struct Frame {
    Context info;
    bool outside = false;  ///< called from outside the file: its return ends the run
    std::vector<Caller> callers;
    std::unordered_set<uint64_t> caller_hashes;
    std::vector<State> exits;
    std::vector<uint64_t> exit_hashes;
    std::unique_ptr<State> joined_exit;
    std::unique_ptr<State> joined_entry;
    RecordId entry = kNoRecord;
  };
  struct Pending {
    StatementId position;
    uint64_t order;
    uint32_t state;
    bool operator<(const Pending& other) const {
      return position != other.position ? position > other.position : order > other.order;
    }
  };
  struct StopKey {
    StatementId statement;
    StopKind kind;
    std::string detail;
    auto operator<=>(const StopKey&) const = default;
  };
  struct StopInfo {
    uint32_t key;
    RecordId record;
    FlowStop stop;
  };

  const Patience& patience() const { return kPatience[level_]; }
  void start();
  void push(State state);
  void arrive(State state);
  void execute(State state, Group& group, uint64_t hash);
  void execute_joined(uint32_t index);
  void end_of_file(const State& state);
  void add_stop(RecordId record, FlowStop stop);
  void resume_one(const Caller& caller, const State& exit, Frame& frame);
  ContextId context_for(const Context& callee, const State& entry, bool* merged);
  void finish();
  void endless_loops();
  Group& group_at(const State& state);

  Program& program_;
  PersistentMap::Pool pool_;
  Machine machine_;
  std::vector<uint32_t> heads_;
  std::vector<Group> groups_;  // grows only while states arrive, never while one is executed
  std::deque<Frame> frames_;  // a deque: references stay valid while calls are added
  std::map<std::tuple<NameId, int, bool, int, uint64_t>, ContextId> contexts_;
  std::map<std::tuple<NameId, int, bool>, std::pair<size_t, ContextId>> context_counts_;
  std::priority_queue<Pending> queue_;
  std::vector<State> waiting_;
  std::vector<uint32_t> free_;
  std::vector<uint32_t> dirty_;  // groups with a join to execute
  uint64_t order_ = 0;
  size_t level_ = 0;
  std::shared_ptr<Trace> trace_;
  std::map<StopKey, StopInfo> stops_;
  std::map<std::tuple<HazardKind, StatementId, StatementId, uint32_t>, Hazard> hazards_;
  std::vector<std::tuple<ContextId, uint32_t, StatementId>> not_passed_;
  std::unordered_set<RecordId> warned_;  // records with an error that FEATURE 0x20 turned into a message
  std::vector<std::pair<ContextId, StatementId>> deepest_;  // calls beyond the limit
  std::map<std::pair<HazardKind, StatementId>, size_t> origins_;
  uint32_t next_key_ = 1;
  FlowResult result_;
};

void Analysis::start() {
  State state;
  Frame main;
  if (program_.sub_file) {
    main.info = {program_.entry, 1, false, 30};
    main.outside = true;
    state.skip = machine_.full_label(kGlobalScope, program_.entry);
    state.seek = true;
    state.parameters.outside = true;
    machine_.evaluator().expect_from_outside(state.parameters);
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

void Analysis::successor(State state) {
  if (state.skip != kNoLabel) state.position = machine_.next_stop(state, state.position);
  push(std::move(state));
}

Analysis::Group& Analysis::group_at(const State& state) {
  uint32_t& head = heads_[state.position];
  for (uint32_t i = head; i != UINT32_MAX; i = groups_[i].next) {
    Group& g = groups_[i];
    if (g.context == state.context && g.skip == state.skip && g.defining == state.defining && g.seek == state.seek && g.looped == state.looped) return g;
  }
  groups_.push_back({state.context, state.skip, state.defining, state.seek, state.looped, head, {}, nullptr, {}, false});
  head = static_cast<uint32_t>(groups_.size() - 1);
  return groups_.back();
}

/// Takes in a state that arrives at its line. New ones are executed at once; where there are many already they are
/// joined, and the join waits until all that arrive together are in it.
void Analysis::arrive(State state) {
  Group& group = group_at(state);
  const uint64_t hash = state.hash();
  if (const RecordId known = group.find(hash); known != kNoRecord) {
    if (state.record != kNoRecord) trace_->link(state.record, known);
    return;
  }
  if (group.seen.size() < patience().states) return execute(std::move(state), group, hash);
  ++result_.statistics.merges;
  if (state.record != kNoRecord) group.parents.push_back(state.record);
  if (group.joined == nullptr) {
    group.joined = std::make_unique<State>(std::move(state));
  } else {
    State joined = machine_.join(*group.joined, state);
    joined.record = state.record;
    joined.branch = state.branch;
    *group.joined = std::move(joined);
  }
  if (!group.dirty) dirty_.push_back(static_cast<uint32_t>(&group - groups_.data()));
  group.dirty = true;
}

void Analysis::execute_joined(uint32_t index) {
  Group& group = groups_[index];
  group.dirty = false;
  State state = *group.joined;
  const uint64_t hash = state.hash();
  std::vector<RecordId> parents;
  parents.swap(group.parents);
  RecordId record = group.find(hash);
  if (record == kNoRecord) {
    record = static_cast<RecordId>(trace_->size());  // the one that execute() makes next
    execute(std::move(state), group, hash);
  }
  for (const RecordId parent : parents) {
    if (trace_->at(record).parent != parent) trace_->link(parent, record);
  }
}

void Analysis::execute(State state, Group& group, uint64_t hash) {
  const bool at_file_end = state.position >= program_.size();
  bool executed = !at_file_end;
  if (state.skip != kNoLabel && !at_file_end) executed = machine_.is_target(state, frames_[state.context].info);
  const RecordId record = trace_->add({state.record, at_file_end ? kNoStatement : state.position, state.branch, executed});
  if (executed) result_.executed[state.position] = true;
  group.seen.emplace_back(hash, record);
  state.record = record;
  if (++result_.statistics.steps >= kPatience[level_].steps) {
    ++level_;
    machine_.evaluator().set_coarse(level_ >= kCoarse);
  }
  if (at_file_end) return end_of_file(state);
  const Context context = frames_[state.context].info;
  machine_.step(std::move(state), context, *this);
}

void Analysis::end_of_file(const State& state) {
  const Frame& frame = frames_[state.context];
  if (state.seek) return;  // reported for each call when all are known: see finish()
  FlowStop stop;
  stop.kind = StopKind::kFileEnd;
  const bool percent = program_.syntax.percent || program_.syntax.blank;
  stop.interpreter = percent ? "File ended with no percent sign" : "File ended with no percent sign or program end";
  const auto blame = [&](FullLabel label) {
    const Definers::Set set = machine_.definers().get(machine_.entry(state, label));
    if (!set.lines.empty()) stop.statement = set.lines.front();
    if (stop.statement == kNoStatement) return;
    const BlockId block = program_.block_of[stop.statement];
    if (block == kNoBlock || program_.blocks[block].end == kNoStatement) return;
    // The block is closed: what set the skip is a line with its label further on.
    const NameId name = machine_.label_of(label);
    const StatementId last = trace_->nearest(state.record, [&](StatementId id) { return program_.at(id).label == name; });
    if (last != kNoStatement) stop.statement = last;
  };
  if (state.skip != kNoLabel) {
    blame(state.skip);
  } else if (frame.info.depth > 0 && !frame.info.fanuc) {
    blame(machine_.full_label(kGlobalScope, frame.info.sub));
  }
  add_stop(state.record, std::move(stop));
}

void Analysis::add_stop(RecordId record, FlowStop stop) {
  const StopKey key{stop.statement, stop.kind, stop.detail};
  auto found = stops_.find(key);
  if (found == stops_.end()) found = stops_.emplace(key, StopInfo{next_key_++, record, std::move(stop)}).first;
  trace_->terminate(record, found->second.key);
}

void Analysis::stop(const State& at, StopKind kind, StatementId other, std::string message, std::string detail) {
  FlowStop stop;
  stop.statement = at.position;
  stop.kind = kind;
  stop.other = other;
  stop.interpreter = std::move(message);
  stop.detail = std::move(detail);
  if (kind == StopKind::kFileEnd) {  // `%` while lines are skipped: blame what is being skipped
    const Definers::Set set = machine_.definers().get(machine_.entry(at, at.skip));
    stop.statement = kNoStatement;
    if (!set.lines.empty()) stop.statement = set.lines.front();
    if (at.seek) return;  // the seeking call: see finish()
  }
  const Frame& frame = frames_[at.context];
  if (!frame.callers.empty()) stop.call = frame.callers.front().state.position;
  if (kind == StopKind::kCallTooDeep) deepest_.emplace_back(at.context, at.position);
  add_stop(at.record, std::move(stop));
}

void Analysis::hazard(const State& at, HazardKind kind, uint32_t number, StopKind warned, std::string message) {
  Hazard hazard{kind, at.position, kNoStatement, number, Reach::kMaybe, warned, std::move(message)};
  const auto executed = [&](Keyword keyword, Keyword loop) {
    return [this, keyword, loop](StatementId id) {
      if (!program_.at(id).is(keyword)) return false;
      const BlockId block = program_.block_of[id];
      return loop == Keyword::kUnknown || (block != kNoBlock && program_.blocks[block].kind == loop);
    };
  };
  const auto begins_at = [&](StatementId origin) {
    if (origin == kNoStatement) return;
    hazard.other = hazard.statement;
    hazard.statement = origin;
  };
  // Looking for where it began walks back along the run; a few such places are enough.
  constexpr size_t kMaxOrigins = 4;
  const bool has_origin = kind == HazardKind::kStaleBreak || kind == HazardKind::kStaleContinue ||
                          kind == HazardKind::kContinueMeetsBreak || kind == HazardKind::kStaleRepeatCount;
  if (has_origin && ++origins_[{kind, at.position}] > kMaxOrigins) return;
  switch (kind) {
    case HazardKind::kStaleBreak: begins_at(trace_->nearest(at.record, executed(Keyword::kBreak, Keyword::kWhile))); break;
    case HazardKind::kStaleContinue: begins_at(trace_->nearest(at.record, executed(Keyword::kContinue, Keyword::kDo))); break;
    case HazardKind::kContinueMeetsBreak: begins_at(trace_->nearest(at.record, executed(Keyword::kContinue, Keyword::kDo))); break;
    case HazardKind::kStaleRepeatCount: begins_at(trace_->nearest(at.record, executed(Keyword::kReturn, Keyword::kUnknown))); break;
    case HazardKind::kArgumentNotPassed: not_passed_.emplace_back(at.context, number, at.position); return;
    case HazardKind::kWarned: warned_.insert(at.record); break;
    case HazardKind::kCrash: trace_->terminate(at.record, next_key_++); break;
    default: break;
  }
  hazards_.emplace(std::make_tuple(kind, hazard.statement, hazard.other, static_cast<uint32_t>(warned)), std::move(hazard));
}

ContextId Analysis::context_for(const Context& callee, const State& entry, bool* merged) {
  State key_state = entry;
  key_state.context = 0;
  const auto key = std::make_tuple(callee.sub, callee.depth, callee.fanuc, callee.passed, key_state.hash());
  *merged = false;
  if (const auto found = contexts_.find(key); found != contexts_.end()) return found->second;
  auto& [count, shared] = context_counts_.try_emplace({callee.sub, callee.depth, callee.fanuc}, 0, 0).first->second;
  if (count >= patience().contexts) {
    *merged = true;
    if (shared != 0) return shared;
  }
  frames_.emplace_back().info = callee;
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
  entry.context = id;
  entry.record = at.record;
  Frame& frame = frames_[id];
  const Caller caller{at, repeats};
  const uint64_t caller_hash = mix(at.hash(), (static_cast<uint64_t>(at.context) << 32) + static_cast<uint32_t>(repeats));
  if (frame.caller_hashes.insert(caller_hash).second) frame.callers.push_back(caller);
  if (merged) {
    ++result_.statistics.merges;
    if (frame.joined_entry == nullptr || frame.joined_entry->position != entry.position ||
        frame.joined_entry->skip != entry.skip) {
      frame.joined_entry = std::make_unique<State>(entry);
    } else {
      *frame.joined_entry = machine_.join(*frame.joined_entry, entry);
      frame.joined_entry->record = at.record;
      entry = *frame.joined_entry;
    }
  }
  successor(std::move(entry));  // an equal one is recognised on arrival
  for (size_t i = 0; i < frames_[id].exits.size(); ++i) {
    const State exit = frames_[id].exits[i];
    resume_one(caller, exit, frames_[id]);
  }
}

void Analysis::resume_one(const Caller& caller, const State& exit, Frame& frame) {
  State after = machine_.resume(caller.state, exit, frame.info, frame.joined_entry != nullptr);
  if (frames_[caller.state.context].info.depth == 0) after.returned = kYes;
  after.record = frame.callers.size() > 1 ? caller.state.record : exit.record;
  if (frame.callers.size() > 1) {
    // The way back is an edge of its own, so that "every run" and "never ends" see it.
    const RecordId bridge = trace_->add({caller.state.record, kNoStatement, 0, false});
    trace_->link(exit.record, bridge);
    after.record = bridge;
  }
  // M98 with L: the call is made again. A few times are counted; more, or an unknown number, run the line anew.
  constexpr int kCountedRepeats = 8;
  if (caller.repeats > 1 && caller.repeats <= kCountedRepeats) {
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
  if (frame.exits.size() >= patience().states) {
    ++result_.statistics.merges;
    if (frame.joined_exit == nullptr) {
      frame.joined_exit = std::make_unique<State>(exit);
    } else {
      *frame.joined_exit = machine_.join(*frame.joined_exit, exit);
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
  const ContextId id = at.context;
  for (size_t i = 0; i < frames_[id].callers.size(); ++i) {
    const Caller caller = frames_[id].callers[i];
    resume_one(caller, exit, frames_[id]);
  }
}

/// A loop that no run leaves: its lines are in records from which no end can be reached.
void Analysis::endless_loops() {
  const std::vector<bool>& hanging = trace_->hanging();
  std::vector<StatementId> loops;
  // Under FEATURE 0x20: an error that became a message, met on the way round, is what the loop is due to.
  const auto warned_on_the_way = [&](RecordId from, StatementId target) {
    StatementId first = kNoStatement;
    for (RecordId id = from; id != kNoRecord; id = trace_->at(id).parent) {
      if (warned_.contains(id)) first = trace_->at(id).statement;
      if (trace_->at(id).statement == target) break;
    }
    return first;
  };
  bool hangs = false;
  const auto back = [&](RecordId from, RecordId to) {
    if (!hanging[from] || !hanging[to]) return;
    const StatementId target = trace_->at(to).statement;
    const StatementId source = trace_->at(from).statement;
    if (target == kNoStatement || source == kNoStatement || target > source) return;
    const StatementId warned = warned_.empty() ? kNoStatement : warned_on_the_way(from, target);
    if (warned == kNoStatement) {
      loops.push_back(target);
    } else {
      hangs = true;
      hazards_.emplace(std::make_tuple(HazardKind::kHang, warned, kNoStatement, 0U), Hazard{HazardKind::kHang, warned, target, 0, Reach::kMaybe, StopKind::kNone, ""});
    }
  };
  // A wrong end that became a message goes back to an `if` or a `do`, again and again as long as the conditions stay
  // as they are, also where other outcomes lead out.
  constexpr size_t kMaxSearches = 64;
  size_t searches = 0;
  const auto goes_round = [&](RecordId from, RecordId to) {
    if (hanging[from] || !warned_.contains(from)) return;
    const StatementId target = trace_->at(to).statement;
    const StatementId end = trace_->at(from).statement;
    if (target == kNoStatement || target > end || !ends_block(program_.at(end).keyword)) return;
    if (!program_.at(target).is(Keyword::kIf) && !program_.at(target).is(Keyword::kDo)) return;
    if (searches++ >= kMaxSearches || !trace_->leads(to, from)) return;
    hazards_.emplace(std::make_tuple(HazardKind::kHang, end, kNoStatement, 0U),
                     Hazard{HazardKind::kHang, end, target, 0, Reach::kMaybe, StopKind::kNone, ""});
  };
  for (const auto& [from, to] : trace_->links()) {
    back(from, to);
    goes_round(from, to);
  }
  for (RecordId id = 0; id < trace_->size(); ++id) {
    if (trace_->at(id).parent == kNoRecord) continue;
    back(trace_->at(id).parent, id);
    goes_round(trace_->at(id).parent, id);
  }
  if (hangs) return;  // one mistake, one finding
  std::ranges::sort(loops);
  loops.erase(std::unique(loops.begin(), loops.end()), loops.end());
  for (const StatementId loop : loops) {
    Hazard hazard{HazardKind::kEndlessLoop, loop, kNoStatement, 0, Reach::kMaybe, StopKind::kNone, ""};
    hazards_.emplace(std::make_tuple(hazard.kind, loop, kNoStatement, 0U), std::move(hazard));
  }
}

void Analysis::finish() {
  // A call that seeks its sub to the end of the file: blame every call that began that search.
  for (Frame& frame : frames_) {
    if (frame.callers.empty()) continue;
    for (const Caller& caller : frame.callers) {
      const auto at_end = [&](uint32_t head) {
        for (uint32_t i = head; i != UINT32_MAX; i = groups_[i].next) {
          if (groups_[i].seek && &frames_[groups_[i].context] == &frame) return true;
        }
        return false;
      };
      bool sought = at_end(heads_[program_.size()]);
      bool percent = false;
      for (StatementId id = 1; program_.syntax.percent && !sought && id < program_.size(); ++id) {
        if (program_.at(id).kind == LineKind::kPercent) sought = percent = at_end(heads_[id]);
        if (percent) break;
      }
      if (!sought) continue;
      FlowStop stop;
      stop.statement = caller.state.position;
      stop.kind = StopKind::kSubNotFound;
      stop.detail = program_.name(frame.info.sub);
      stop.unproven = machine_.may_be_elsewhere(frame.info.sub);
      stop.interpreter = percent ? "Failed to find sub 'O" + stop.detail + "' before EOF"
                                 : "EOF in file:" + program_.source->path() + " seeking o-word: o<" + stop.detail +
                                       "> from line: " + std::to_string(program_.at(stop.statement).line);
      add_stop(caller.state.record, stop);
      const uint32_t key = stops_.at({stop.statement, stop.kind, stop.detail}).key;
      for (const Group& group : groups_) {
        if (!group.seek || &frames_[group.context] != &frame) continue;
        for (const auto& [hash, record] : group.seen) trace_->terminate(record, key);
      }
    }
  }
  trace_->finish();
  endless_loops();
  for (const auto& [context, number, read] : not_passed_) {
    for (const Caller& caller : frames_[context].callers) {
      const StatementId call = caller.state.position;
      if (program_.at(call).value_count >= number) continue;
      hazards_.emplace(std::make_tuple(HazardKind::kArgumentNotPassed, call, read, number),
                       Hazard{HazardKind::kArgumentNotPassed, call, read, number, Reach::kMaybe, StopKind::kNone, ""});
    }
  }
  for (const auto& [context, call] : deepest_) {
    // A recursion that can come back: nobody knows here how deep it goes.
    if (frames_[context].exits.empty()) continue;
    for (auto& [key, info] : stops_) {
      if (key.kind == StopKind::kCallTooDeep && key.statement == call) info.stop.unproven = true;
    }
  }
  constexpr size_t kMaxPaths = 64;
  size_t paths = 0;
  for (auto& [key, info] : stops_) {
    FlowStop stop = std::move(info.stop);
    stop.reach = trace_->only_end(info.key) ? Reach::kAlways : Reach::kMaybe;
    // Without values, a name that only some branches assign may be read on just the same ones; a global one may come
    // from another program.
    if (key.kind == StopKind::kNameUndefined && (stop.reach != Reach::kAlways || key.detail.starts_with("_"))) stop.unproven = true;
    if (stop.reach == Reach::kMaybe && paths++ < kMaxPaths) stop.path = trace_->path(info.record, info.key);
    result_.stops.push_back(std::move(stop));
  }
  result_.trace = trace_;
  for (auto& [key, hazard] : hazards_) {
    hazard.reach = trace_->reach(hazard.statement);
    result_.hazards.push_back(std::move(hazard));
  }
}

}  // namespace
}  // namespace owlint::flow

namespace owlint {

Reach FlowResult::reach(StatementId statement) const { return trace->reach(statement); }

FlowResult analyze_flow(Program& program, const Profile& profile) {
  return flow::Analysis(program, profile).run();
}

}  // namespace owlint
