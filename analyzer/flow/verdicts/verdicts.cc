// From the analysis to its results: what each stop and each hazard is due to, and how it is reached.
#include <algorithm>

#include "analyzer/flow/engine/analysis.h"
#include "analyzer/flow/summaries/optional_arguments.h"

namespace owlint::flow {
namespace {

/// LinuxCNC cuts its messages off (measured).
std::string as_printed(std::string message) {
  constexpr size_t kLongest = 254;
  if (message.size() > kLongest) message.resize(kLongest);
  return message;
}

}  // namespace

void Analysis::end_of_file(const State& state) {
  const Frame& frame = frames_[state.context];
  if (state.seek) return;  // reported for each call when all are known: see finish()
  FlowStop stop;
  stop.kind = StopKind::kFileEnd;
  stop.end_of = state.position;
  stop.call = call_of(state.context, state.position);
  stop.unproven = state.mixed;
  const bool percent = program_.syntax.percent || program_.syntax.blank;
  stop.interpreter = percent ? "File ended with no percent sign" : "File ended with no percent sign or program end";
  const auto blame = [&](FullLabel label) {
    const Definers::Set set = machine_.definers().get(machine_.entry(state, label));
    if (!set.lines.empty()) stop.statement = set.lines.front();
    if (stop.statement == kNoStatement) return;
    const BlockId block = program_.block_of[stop.statement];
    if (block == kNoBlock || program_.blocks[block].end == kNoStatement ||
        program_.at(program_.blocks[block].end).refused)
      return;
    // The block is closed: what set the skip is a line with its label further on.
    const NameId name = machine_.label_of(label);
    const StatementId last =
        trace_->nearest(state.record, [&](StatementId id) { return program_.at(id).label == name; });
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
  stop.interpreter = as_printed(std::move(stop.interpreter));
  // A stop without a line to blame is reported at the end of its file.
  const uint32_t file =
      stop.statement == kNoStatement && stop.end_of != kNoStatement ? linked_.file_of(stop.end_of) : 0;
  const StopKey key{stop.statement, stop.kind, stop.detail, file};
  const bool unsure = stop.unproven;
  auto found = stops_.find(key);
  if (found == stops_.end()) {
    found = stops_.emplace(key, StopInfo{next_key_++, record, std::move(stop)}).first;
  } else if (found->second.stop.unproven && !stop.unproven) {
    found->second.stop.unproven = false;
    found->second.record = record;
  }
  trace_->terminate(record, found->second.key, unsure);
}

void Analysis::stop(const State& at, StopKind kind, StatementId other, std::string message, std::string detail) {
  disturb(at.context);
  FlowStop stop;
  stop.statement = at.position;
  stop.kind = kind;
  stop.other = other;
  stop.interpreter = std::move(message);
  stop.detail = std::move(detail);
  if (kind == StopKind::kFileEnd) {  // `%` while lines are skipped: blame what is being skipped
    const Definers::Set set = machine_.definers().get(machine_.entry(at, at.skip));
    stop.statement = kNoStatement;
    stop.end_of = at.position;
    if (!set.lines.empty()) stop.statement = set.lines.front();
    if (at.seek) return;  // the seeking call: see finish()
  }
  stop.call = call_of(at.context, at.position);
  stop.unproven = at.mixed;
  // A called file does not know whether the program that calls it is between `%` lines.
  if (kind == StopKind::kBadCharacter && program_.sub_file && program_.at(at.position).kind == LineKind::kPercent)
    stop.unproven = true;
  if (kind == StopKind::kSubNotFound) {
    stop.kind = why_not_found(machine_.intern(stop.detail), at.position);
    stop.unproven = stop.unproven || machine_.may_be_elsewhere(machine_.intern(stop.detail));
  }
  if (kind == StopKind::kCallTooDeep) deepest_.emplace_back(at.context, at.position);
  add_stop(at.record, std::move(stop));
}

void Analysis::hazard(const State& at, HazardKind kind, uint32_t number, StopKind warned, std::string message,
                      StatementId other) {
  disturb(at.context);
  Hazard hazard{kind, at.position, other, number, Reach::kMaybe, warned, as_printed(std::move(message)), {}, {}};
  hazard.unproven = at.mixed;
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
  const bool of_value = kind == HazardKind::kValueNotReturned || kind == HazardKind::kValueCleared;
  const bool has_origin = of_value || kind == HazardKind::kStaleBreak || kind == HazardKind::kStaleContinue ||
      kind == HazardKind::kContinueMeetsBreak || kind == HazardKind::kStaleRepeatCount;
  if (has_origin && ++origins_[{kind, at.position}] > limits_.origins) return;
  if (has_origin && trace_->leaves_out()) trace_->miss_left_out();  // it may have begun there
  switch (kind) {
    case HazardKind::kStaleBreak:
      begins_at(trace_->nearest(at.record, executed(Keyword::kBreak, Keyword::kWhile)));
      break;
    case HazardKind::kStaleContinue:
      begins_at(trace_->nearest(at.record, executed(Keyword::kContinue, Keyword::kDo)));
      break;
    case HazardKind::kContinueMeetsBreak:
      begins_at(trace_->nearest(at.record, executed(Keyword::kContinue, Keyword::kDo)));
      break;
    case HazardKind::kStaleRepeatCount:
      begins_at(trace_->nearest(at.record, executed(Keyword::kReturn, Keyword::kUnknown)));
      break;
    case HazardKind::kRunsIntoSub: begins_at(other); break;
    case HazardKind::kArgumentNotPassed: not_passed_.emplace_back(at.context, number, at.position); return;
    case HazardKind::kValueNotReturned:
    case HazardKind::kValueCleared:
      hazard.other = trace_->nearest(at.record, [this](StatementId id) {
        const Statement& s = program_.at(id);
        return s.is(Keyword::kReturn) || s.is(Keyword::kEndsub) || s.kind == LineKind::kM99;
      });
      break;
    case HazardKind::kRepeatCount:
      hazard.detail = std::move(hazard.interpreter);
      hazard.interpreter.clear();
      break;
    case HazardKind::kWarned: warned_.insert(at.record); break;
    case HazardKind::kLookupCrash: trace_->terminate(at.record, next_key_++); break;
    case HazardKind::kCrash: trace_->terminate(at.record, next_key_++); break;
    default: break;
  }
  const auto [known, added] =
      hazards_.emplace(std::make_tuple(kind, hazard.statement, hazard.other, static_cast<uint32_t>(warned)), hazard);
  if (!added) known->second.unproven = known->second.unproven && hazard.unproven;
}

/// The call that led to a line: into its file if it is in a called one, else into its sub. None where many calls of that
/// have been joined: it may not be the first one's.
StatementId Analysis::call_of(ContextId context, StatementId at) const {
  StatementId call = kNoStatement;
  const uint32_t file = linked_.file_of(at);
  for (int depth = 0; depth <= kMaxCallDepth && !frames_[context].callers.empty(); ++depth) {
    const State& caller = frames_[context].callers.front().state;
    call = caller.position;
    if (file == 0 && frames_[context].joined_entry != nullptr) return kNoStatement;
    if (file == 0 || linked_.file_of(call) != file) break;
    context = caller.context;
  }
  return call;
}

/// Whether the calls that lead to `context` go through one sub twice, and that sub also returns: a recursion with an
/// exit, of which nobody knows here how deep it goes.
bool Analysis::recursion_comes_back(ContextId context) const {
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

/// Why a search for a sub from `call` on fails.
StopKind Analysis::why_not_found(NameId sub, StatementId call) const {
  const LinkedFile& file = linked_.files()[linked_.file_of(call)];
  const bool called_file = file.first != 0 || program_.sub_file;
  if (called_file && sub < program_.by_label.size()) {
    for (const StatementId id : program_.by_label[sub]) {
      if (!program_.at(id).opens_sub() || id < file.first || id >= file.last) continue;
      return id < call ? StopKind::kSubBeforeEntry : StopKind::kHelperRefused;
    }
  }
  return linked_.search_path().find_other_case(machine_.name(sub)) ? StopKind::kFileNameCase : StopKind::kSubNotFound;
}

/// A call that seeks its sub to the end of a file: if it does, the call is to blame.
void Analysis::not_found(ContextId context, const Caller& caller) {
  const Frame& frame = frames_[context];
  const NameId sub = frame.info.sub;
  const StatementId call = caller.state.position;
  const CallTarget target = machine_.target(sub);
  const bool has_file = target.file != CallTarget::kNotFound;
  const LinkedFile& file = linked_.files()[has_file ? target.file : linked_.file_of(call)];
  const std::vector<const Group*>& groups = seeking_[context];
  const bool at_end = std::ranges::any_of(groups, [&](const Group* g) { return g->position == file.last; });
  const bool percent = !at_end && program_.syntax.percent && std::ranges::any_of(groups, [&](const Group* g) {
    return g->position >= std::max(file.first, 1U) && g->position < file.last &&
        program_.at(g->position).kind == LineKind::kPercent;
  });
  if (!at_end && !percent) return;
  FlowStop stop;
  stop.statement = call;
  stop.call = call_of(caller.state.context, call);
  stop.detail = machine_.name(sub);
  const uint32_t from = has_file ? 0 : program_.at(call).line;
  const std::string sought(called_label(stop.detail, machine_.version()));
  stop.interpreter = percent ? "Failed to find sub 'O" + sought + "' before EOF"
                             : "EOF in file:" + file.program->source->path() + " seeking o-word: o<" + sought +
          "> from line: " + std::to_string(from);
  if (has_file) {
    stop.kind = percent ? StopKind::kFilePercent : StopKind::kFileLacksSub;
    stop.file = file.program.get();
  } else {
    stop.kind = why_not_found(sub, call);
    stop.unproven = machine_.may_be_elsewhere(sub);
  }
  stop.unproven = stop.unproven || caller.state.mixed;
  add_stop(caller.state.record, stop);
  const uint32_t key = stops_.at({stop.statement, stop.kind, stop.detail, 0}).key;
  for (const Group* group : groups) {
    for (const auto& [hash, record] : group->seen) trace_->terminate(record, key);
  }
}

void Analysis::blame_calls() {
  for (const Group& group : groups_) {
    if (group.seek) seeking_[group.context].push_back(&group);
  }
  for (ContextId context = 0; context < frames_.size(); ++context) {
    if (!seeking_.contains(context)) continue;
    for (const Caller& caller : frames_[context].callers) not_found(context, caller);
  }
}

void Analysis::finish() {
  blame_calls();
  trace_->finish(result_.executed);
  stuck_.assign(trace_->size(), false);
  idle_loops();
  // After a message of FEATURE 0x20 that leads round and round, no stop is that of every run.
  const bool hangs = std::ranges::any_of(hazards_, [](const auto& h) { return h.second.kind == HazardKind::kHang; });
  may_go_round_ = hangs;
  if (!hangs) {  // one mistake, one finding
    endless_loops();
    stuck_loops();
  }
  if (memory_of_calls_) learn_calls();
  ends_in_subs();
  // The lines of a `sub` within a called one run in its place: they read its arguments by mistake, and that is said there.
  std::map<RegionId, StatementId> inner;
  for (const auto& [key, hazard] : hazards_) {
    if (hazard.kind == HazardKind::kSubInCall)
      inner.try_emplace(program_.region_of[hazard.statement], hazard.statement);
  }
  std::optional<OptionalArguments> optional;
  for (const auto& [context, number, read] : not_passed_) {
    const auto within = inner.find(program_.region_of[read]);
    if (within != inner.end() && within->second < read) continue;
    if (!optional) optional.emplace(program_);
    if (optional->optional(read, number)) continue;
    for (const Caller& caller : frames_[context].callers) {
      const StatementId call = caller.state.position;
      if (program_.at(call).value_count >= number) continue;
      hazards_.emplace(
          std::make_tuple(HazardKind::kArgumentNotPassed, call, read, number),
          Hazard{HazardKind::kArgumentNotPassed, call, read, number, Reach::kMaybe, StopKind::kNone, "", {}, {}});
    }
  }
  for (const auto& [context, call] : deepest_) {
    if (!recursion_comes_back(context)) continue;
    for (auto& [key, info] : stops_) {
      if (key.kind == StopKind::kCallTooDeep && key.statement == call) info.stop.unproven = true;
    }
  }
  size_t paths = 0;
  for (auto& [key, info] : stops_) {
    FlowStop stop = std::move(info.stop);
    stop.reach = trace_->only_end(info.key) && !may_go_round_ ? Reach::kAlways : Reach::kMaybe;
    if (stop.reach == Reach::kMaybe && paths++ < limits_.paths) stop.path = trace_->path(info.record, info.key);
    // A global name may come from another program; a branch that is not followed exactly may go as one before it.
    if (key.kind == StopKind::kNameUndefined) {
      const bool proven = stop.reach == Reach::kAlways ||
          (!coarse() && !stop.path.empty() && followed(stop.path) && !assigned_in_most_cases(stop));
      // But nobody assigns what looks like an entry of the INI or is LinuxCNC's own in another version.
      const NameId name = program_.syntax.names.find(key.detail);
      const bool never = name != kNoName && may_be_predefined(key.detail) &&
          machine_.evaluator().kind(name) == NameKind::kGlobal && !machine_.evaluator().assigned(name);
      const bool from_elsewhere = is_global_name(key.detail) && !never;
      if (!proven || from_elsewhere) stop.unproven = true;
    }
    const size_t shown = std::min(stop.path.size(), limits_.shown_decisions);
    stop.path.erase(stop.path.begin(), stop.path.end() - static_cast<ptrdiff_t>(shown));
    result_.stops.push_back(std::move(stop));
  }
  result_.trace = trace_;
  for (auto& [key, hazard] : hazards_) {
    hazard.reach = trace_->reach(hazard.statement);
    if (hazard.kind == HazardKind::kHang && trace_->ends()) hazard.reach = Reach::kMaybe;
    if (hazard.kind == HazardKind::kCrash && may_go_round_ && hazard.reach == Reach::kAlways)
      hazard.reach = Reach::kMaybe;
    result_.hazards.push_back(std::move(hazard));
  }
}

/// Collects the calls whose outcome can be kept: one exit, and nothing on the way that is reported at the sub's lines.
void Analysis::learn_calls() {
  const std::vector<bool>& hanging = trace_->hanging();
  const auto leaves_nothing = [](const State& entry, const State& exit) {
    const auto same = [](const PersistentMap& a, const PersistentMap& b) { return a.hash() == b.hash(); };
    return same(entry.table, exit.table) && same(entry.parameters.globals, exit.parameters.globals) &&
        same(entry.parameters.global_facts, exit.parameters.global_facts) && entry.counts == exit.counts &&
        entry.flags.breaking == exit.flags.breaking && entry.flags.continuing == exit.flags.continuing &&
        entry.parameters.outside == exit.parameters.outside;
  };
  for (Frame& frame : frames_) {
    // In a program that never ends, all loops on the way are reported.
    if (frame.known && hanging[frame.exits.front().record]) trace_->miss_left_out();
    if (frame.watch == nullptr) continue;
    Watch& watch = *frame.watch;
    const Region& region = program_.regions[program_.region_of[watch.entry.position]];
    watch.lines.resize(region.end + 1 - region.opener);
    if (frame.exits.size() != 1 || frame.joined_exit != nullptr || frame.joined_entry != nullptr ||
        !leaves_nothing(watch.entry, frame.exits.front()))
      watch.disturbed = true;
  }
  for (const Group& group : groups_) {
    Watch* watch = frames_[group.context].watch.get();
    if (watch == nullptr || watch->disturbed) continue;
    for (const auto& [hash, record] : group.seen) {
      const StatementId line = group.position - watch->entry.position;  // wraps for lines before
      if (hanging[record] || stuck_[record] || line >= watch->lines.size())
        watch->disturbed = true;
      else if (trace_->at(record).executed)
        watch->lines[line] = true;
    }
  }
  result_.learned = std::make_shared<std::vector<LearnedCall>>();
  for (Frame& frame : frames_) {
    if (frame.watch == nullptr || frame.watch->disturbed) continue;
    const State& exit = frame.exits.front();
    result_.learned->push_back({std::move(frame.watch->key),
                                {exit.flags.executed, exit.flags.returned, exit.joined, exit.mixed,
                                 std::move(frame.watch->lines), frame.watch->steps},
                                frame.watch->entry.position});
  }
}

std::vector<FlowResult> by_file(const Linked& linked, FlowResult result) {
  const auto& files = linked.files();
  std::vector<FlowResult> out(files.size());
  if (files.size() == 1) {
    out[0] = std::move(result);
    return out;
  }
  for (size_t i = 0; i < files.size(); ++i) {
    const LinkedFile& file = files[i];
    out[i].first = file.first;
    out[i].trace = result.trace;
    out[i].ends = result.ends;
    out[i].executed.assign(result.executed.begin() + file.first, result.executed.begin() + file.last);
  }
  out[0].statistics = result.statistics;
  out[0].learned = std::move(result.learned);
  // Moves a statement number into its file, or out of it if that is another file than `home`.
  const auto localize = [&](uint32_t home, StatementId* id, Elsewhere* elsewhere) {
    if (*id == kNoStatement) return;
    const uint32_t file = linked.file_of(*id);
    const StatementId local = *id - files[file].first;
    *id = file == home ? local : kNoStatement;
    if (file != home) *elsewhere = {files[file].program.get(), local};
  };
  for (FlowStop& stop : result.stops) {
    const StatementId place = stop.statement != kNoStatement ? stop.statement : stop.end_of;
    const uint32_t home = place == kNoStatement ? 0 : linked.file_of(place);
    if (stop.statement != kNoStatement) stop.statement -= files[home].first;
    localize(home, &stop.other, &stop.other_elsewhere);
    localize(home, &stop.call, &stop.call_elsewhere);
    Elsewhere end;  // of a file that was called: nobody asks
    localize(home, &stop.end_of, &end);
    for (Decision& decision : stop.path) {
      const uint32_t file = linked.file_of(decision.statement);
      decision.statement -= files[file].first;
      if (file != home) decision.program = files[file].program.get();
    }
    out[home].stops.push_back(std::move(stop));
  }
  for (Hazard& hazard : result.hazards) {
    const uint32_t home = linked.file_of(hazard.statement);
    hazard.statement -= files[home].first;
    localize(home, &hazard.other, &hazard.other_elsewhere);
    out[home].hazards.push_back(std::move(hazard));
  }
  return out;
}

}  // namespace owlint::flow

namespace owlint {

bool remember(const FlowResult& result, flow::KnownCalls& known) {
  if (result.trace->missed()) {
    known.clear();
    return false;
  }
  if (result.learned == nullptr) return true;
  for (flow::LearnedCall& call : *result.learned) {
    // A call with a finding must be followed the next time, too.
    const auto end = call.opener + static_cast<StatementId>(call.outcome.lines.size());
    if (!result.trace->asked(call.opener + 1, end)) known.learn(std::move(call));
  }
  return true;
}

}  // namespace owlint
