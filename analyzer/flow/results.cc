// From the analysis to its results: what each stop and each hazard is due to, and how it is reached.
#include <algorithm>

#include "analyzer/flow/analysis.h"

namespace owlint::flow {

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

/// Loops that no run leaves: their lines are in records from which no end can be reached.
void Analysis::endless_loops() {
  const std::vector<bool>& hanging = trace_->hanging();
  std::vector<StatementId> loops;
  const auto back = [&](RecordId from, RecordId to) {
    if (!hanging[from] || !hanging[to]) return;
    const StatementId target = trace_->at(to).statement;
    const StatementId source = trace_->at(from).statement;
    if (target != kNoStatement && source != kNoStatement && target <= source) loops.push_back(target);
  };
  for (const auto& [from, to, branch] : trace_->links()) back(from, to);
  for (RecordId id = 0; id < trace_->size(); ++id) {
    if (trace_->at(id).parent != kNoRecord) back(trace_->at(id).parent, id);
  }
  std::ranges::sort(loops);
  loops.erase(std::unique(loops.begin(), loops.end()), loops.end());
  for (const StatementId loop : loops) {
    Hazard hazard{HazardKind::kEndlessLoop, loop, kNoStatement, 0, Reach::kMaybe, StopKind::kNone, ""};
    hazards_.emplace(std::make_tuple(hazard.kind, loop, kNoStatement, 0U), std::move(hazard));
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
                     Hazard{HazardKind::kHang, loop.warned, loop.first, 0, Reach::kMaybe, StopKind::kNone, ""});
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
  idle_loops();
  const bool hangs = std::ranges::any_of(hazards_, [](const auto& h) { return h.second.kind == HazardKind::kHang; });
  if (!hangs) endless_loops();  // one mistake, one finding
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
    if (hazard.kind == HazardKind::kHang && trace_->ends()) hazard.reach = Reach::kMaybe;
    result_.hazards.push_back(std::move(hazard));
  }
}

}  // namespace owlint::flow
