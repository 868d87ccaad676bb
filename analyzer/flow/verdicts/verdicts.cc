#include "analyzer/flow/verdicts/verdicts.h"

#include <algorithm>
#include <optional>

#include "analyzer/flow/engine/reachability.h"
#include "analyzer/flow/interpreter/new_machine.h"
#include "analyzer/flow/summaries/optional_arguments.h"
#include "analyzer/flow/verdicts/endless_loops.h"
#include "analyzer/flow/verdicts/ends_in_subs.h"
#include "analyzer/flow/verdicts/missing_subs.h"
#include "analyzer/flow/verdicts/undefined_names.h"
#include "analyzer/machine/predefined.h"

namespace owlint::flow {

void Verdicts::end(const State& at) {
  trace_.terminate(at.record, kNormalEnd);
  ends_ = true;
}

void Verdicts::end_of_file(const State& at) {
  if (at.seek) return;  // reported for each call when all are known: see find_missing_subs()
  AbstractMachine& machine = analysis_.machine();
  const Context& context = analysis_.calls()[at.context].info;
  FlowStop stop;
  stop.kind = StopKind::kFileEnd;
  stop.end_of = at.position;
  stop.call = analysis_.calls().call_of(analysis_.linked(), at.context, at.position);
  stop.unproven = at.mixed;
  stop.on_new_machine = is_on_new_machine(at.parameters);
  if (stop.on_new_machine) stop.unset = analysis_.unset();
  const bool percent = program_.syntax.percent || program_.syntax.blank;
  stop.interpreter = percent ? "File ended with no percent sign" : "File ended with no percent sign or program end";
  const auto blame = [&](FullLabel label) {
    const Definers::Set set = machine.definers().get(machine.entry(at, label));
    if (!set.lines.empty()) stop.statement = set.lines.front();
    if (stop.statement == kNoStatement) return;
    const BlockId block = program_.block_of[stop.statement];
    if (block == kNoBlock || program_.blocks[block].end == kNoStatement ||
        program_.at(program_.blocks[block].end).refused)
      return;
    // The block is closed: what set the skip is a line with its label further on.
    const NameId name = machine.label_of(label);
    const StatementId last = trace_.nearest(at.record, [&](StatementId id) { return program_.at(id).label == name; });
    if (last != kNoStatement) stop.statement = last;
  };
  if (at.skip != kNoLabel) {
    blame(at.skip);
  } else if (context.depth > 0 && !context.fanuc) {
    blame(machine.full_label(kGlobalScope, context.sub));
  }
  stops_.add(at.record, std::move(stop));
}

void Verdicts::stop(const State& at, StopReport report) {
  AbstractMachine& machine = analysis_.machine();
  FlowStop stop;
  stop.statement = at.position;
  stop.kind = report.kind;
  stop.other = report.other;
  stop.interpreter = std::move(report.message);
  stop.detail = std::move(report.detail);
  stop.words = report.words;
  if (stop.words.decided_by != 0) {
    const ModeSetter setter = last_setter(analysis_, trace_.at(at.record).parent, at.position, stop.words.decided_by);
    stop.set_in = setter.file;
    stop.set_line = setter.line;
  }
  if (stop.kind == StopKind::kFileEnd) {  // `%` while lines are skipped: blame what is being skipped
    const Definers::Set set = machine.definers().get(machine.entry(at, at.skip));
    stop.statement = kNoStatement;
    stop.end_of = at.position;
    if (!set.lines.empty()) stop.statement = set.lines.front();
    if (at.seek) return;  // the seeking call: see find_missing_subs()
  }
  stop.call = analysis_.calls().call_of(analysis_.linked(), at.context, at.position);
  stop.unproven = at.mixed;
  stop.on_new_machine = is_on_new_machine(at.parameters);
  if (stop.on_new_machine) stop.unset = analysis_.unset();
  // A called file does not know whether the program that calls it is between `%` lines.
  if (stop.kind == StopKind::kBadCharacter && program_.sub_file && program_.at(at.position).kind == LineKind::kPercent)
    stop.unproven = true;
  if (stop.kind == StopKind::kCallTooDeep) deepest_.emplace_back(at.context, at.position);
  if (stop.kind == StopKind::kSubNotFound) {
    const NameId sub = machine.intern(stop.detail);
    stop.kind = why_not_found(analysis_, sub, at.position);
    stop.unproven = stop.unproven || machine.may_be_elsewhere(sub);
  }
  stops_.add(at.record, std::move(stop));
}

/// Looks for the line where the trouble began that shows at `at`. False if enough such places were looked for.
bool Verdicts::find_origin(const State& at, Hazard& hazard) {
  const auto jump = [this](Keyword keyword, Keyword loop) {
    return [this, keyword, loop](StatementId id) {
      if (!program_.at(id).is(keyword)) return false;
      const BlockId block = program_.block_of[id];
      return block != kNoBlock && program_.blocks[block].kind == loop;
    };
  };
  StatementId origin = kNoStatement;
  const bool of_value = hazard.kind == HazardKind::kValueNotReturned || hazard.kind == HazardKind::kValueCleared;
  const bool of_jump = hazard.kind == HazardKind::kStaleBreak || hazard.kind == HazardKind::kStaleContinue ||
      hazard.kind == HazardKind::kContinueMeetsBreak || hazard.kind == HazardKind::kStaleRepeatCount;
  if (!of_value && !of_jump) return true;
  if (++origins_[{hazard.kind, at.position}] > analysis_.limits().origins) return false;
  if (trace_.leaves_out()) trace_.miss_left_out();  // it may have begun there
  switch (hazard.kind) {
    case HazardKind::kStaleBreak: origin = trace_.nearest(at.record, jump(Keyword::kBreak, Keyword::kWhile)); break;
    case HazardKind::kStaleContinue:
    case HazardKind::kContinueMeetsBreak:
      origin = trace_.nearest(at.record, jump(Keyword::kContinue, Keyword::kDo));
      break;
    case HazardKind::kStaleRepeatCount:
      origin = trace_.nearest(at.record, [this](StatementId id) { return program_.at(id).is(Keyword::kReturn); });
      break;
    default:
      hazard.other = trace_.nearest(at.record, [this](StatementId id) {
        const Statement& s = program_.at(id);
        return s.is(Keyword::kReturn) || s.is(Keyword::kEndsub) || s.kind == LineKind::kM99;
      });
      return true;
  }
  if (origin != kNoStatement) {
    hazard.other = hazard.statement;
    hazard.statement = origin;
  }
  return true;
}

void Verdicts::hazard(const State& at, HazardReport report) {
  Hazard hazard = hazard_at(report.kind, at.position, report.other);
  hazard.number = report.number;
  hazard.warned = report.error;
  hazard.interpreter = as_printed(std::move(report.message));
  hazard.detail = std::move(report.detail);
  hazard.unproven = at.mixed;
  if (!find_origin(at, hazard)) return;
  switch (report.kind) {
    case HazardKind::kArgumentNotPassed: not_passed_.push_back({at.context, report.number, at.position}); return;
    case HazardKind::kRunsIntoSub:
      if (report.other != kNoStatement) {
        hazard.other = hazard.statement;
        hazard.statement = report.other;
      }
      break;
    case HazardKind::kOwnHelper: run_own_helper_.insert(at.position); return;
    case HazardKind::kKeepsValues: keep_values_.insert(at.record); return;
    case HazardKind::kWarned: warned_.insert(at.record); break;
    case HazardKind::kLookupCrash:
    case HazardKind::kCrash: stops_.end_otherwise(at.record); break;
    default: break;
  }
  hazards_.add(std::move(hazard), static_cast<uint32_t>(report.error));
}

/// Arguments that a sub reads and cannot do without, and the calls that do not pass them.
void Verdicts::find_arguments_not_passed() {
  // The lines of a `sub` within a called one run in its place: they read its arguments by mistake, and that is said there.
  std::map<RegionId, StatementId> inner;
  for (const auto& [key, hazard] : hazards_) {
    if (hazard.kind == HazardKind::kSubInCall)
      inner.try_emplace(program_.region_of[hazard.statement], hazard.statement);
  }
  std::optional<OptionalArguments> optional;
  for (const NotPassed& argument : not_passed_) {
    const auto within = inner.find(program_.region_of[argument.read]);
    if (within != inner.end() && within->second < argument.read) continue;
    if (!optional) optional.emplace(program_);
    if (optional->optional(argument.read, argument.number)) continue;
    for (const Caller& caller : analysis_.calls()[argument.context].callers) {
      const StatementId call = caller.state.position;
      if (program_.at(call).value_count >= argument.number) continue;
      Hazard hazard = hazard_at(HazardKind::kArgumentNotPassed, call, argument.read);
      hazard.number = argument.number;
      hazards_.add(std::move(hazard), argument.number);
    }
  }
}

/// Calls that are too deep only if a recursion, which has an exit, goes so deep.
void Verdicts::find_endless_recursions() {
  for (const auto& [context, call] : deepest_) {
    if (!analysis_.calls().recursion_comes_back(context)) continue;
    for (auto& [key, found] : stops_) {
      if (key.kind == StopKind::kCallTooDeep && key.statement == call) found.stop.unproven = true;
    }
  }
}

/// A global name may come from another program; a branch that is not followed exactly may go as one before it.
void Verdicts::doubt_undefined_name(FlowStop& stop) {
  const TrackedParameters& tracked = analysis_.machine().tracked();
  const bool proven = stop.reach == Reach::kAlways ||
      (!analysis_.precision().coarse() && !stop.path.empty() &&
       followed(program_, analysis_.machine().refinement(), stop.path) && !assigned_in_most_cases(program_, stop));
  // But nobody assigns what looks like an entry of the INI or is LinuxCNC's own in another version.
  const NameId name = program_.syntax.names.find(stop.detail);
  const bool never = name != kNoName && may_be_predefined(stop.detail) && tracked.kind(name) == NameKind::kGlobal &&
      !tracked.is_assigned(name);
  const bool from_elsewhere = is_global_name(stop.detail) && !never;
  if (!proven || from_elsewhere) stop.unproven = true;
}

/// `paths`: how many were worked out.
FlowStop Verdicts::finished(Stops::Found& found, size_t* paths) {
  const Limits& limits = analysis_.limits();
  FlowStop stop = std::move(found.stop);
  stop.reach = trace_.only_end(found.key) && !may_go_round_ ? Reach::kAlways : Reach::kMaybe;
  if (stop.reach == Reach::kMaybe && (*paths)++ < limits.paths) stop.path = trace_.path(found.record, found.key);
  if (stop.kind == StopKind::kNameUndefined) doubt_undefined_name(stop);
  const size_t shown = std::min(stop.path.size(), limits.shown_decisions);
  stop.path.erase(stop.path.begin(), stop.path.end() - static_cast<ptrdiff_t>(shown));
  return stop;
}

FlowResult Verdicts::finish() {
  FlowResult result;
  find_missing_subs(analysis_, stops_);
  trace_.finish();
  EndlessLoops loops(analysis_, warned_, keep_values_, hazards_);
  loops.find();
  may_go_round_ = loops.may_go_round();
  result.learned = analysis_.learned_calls(loops.stuck());
  find_ends_in_subs(analysis_, hazards_);
  find_arguments_not_passed();
  mode_hazards_.find(hazards_);
  limit_hazards_.find(hazards_);
  find_endless_recursions();
  result.reachability = std::make_shared<Reachability>(analysis_.trace(), analysis_.limits());
  size_t paths = 0;
  for (auto& [key, found] : stops_) result.stops.push_back(finished(found, &paths));
  for (auto& [key, hazard] : hazards_) {
    hazard.reach = result.reachability->reach(hazard.statement);
    const bool doubtful = hazard.kind == HazardKind::kHang
        ? trace_.ends()
        : hazard.kind == HazardKind::kCrash && may_go_round_ && hazard.reach == Reach::kAlways;
    const bool elsewhere_too = hazard.kind == HazardKind::kOtherHelper && run_own_helper_.contains(hazard.statement);
    hazard.not_always = hazard.not_always || elsewhere_too;
    if (doubtful || elsewhere_too) hazard.reach = Reach::kMaybe;
    result.hazards.push_back(std::move(hazard));
  }
  result.executed = trace_.executed();
  result.ends = ends_;
  result.statistics = analysis_.statistics();
  return result;
}

}  // namespace owlint::flow
