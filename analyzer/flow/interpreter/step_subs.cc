// Transitions of `sub`, bare `O`, `endsub`, `return`, `call` and M98.
#include <algorithm>

#include "analyzer/flow/interpreter/step.h"

namespace owlint::flow {

/// Enters the sub's label in the table; false when it is there on every path.
bool AbstractMachine::Step::enter_sub() {
  const Definers::Set set = m.definers_.get(entry());
  take_apart(set);
  const std::string where = "File:" + m.linked_.source_of(here).path() + " line:" + std::to_string(s.line);
  const std::string& name = m.name(s.label_expr == kNoExpr ? s.label : m.label_of(label));
  for (const StatementId line : set.lines) {
    if (line == here) {
      stop(StopKind::kSubIllegalLocation, where + " sub: o|" + name + "| found in illegal location", line);
    } else {
      stop(StopKind::kSubRedefined,
           where + " redefining sub: o|" + name + "| already defined in file:" + m.linked_.source_of(line).path(),
           line);
    }
  }
  if (!set.undefined && !set.lines.empty()) return false;
  define_here();
  return true;
}

/// Whether the line's label is that of the sub that is being called.
bool AbstractMachine::Step::is_called_sub() const {
  return m.name(m.label_of(label)) == called_label(m.name(context.sub), m.profile_.version);
}

/// Whether the file of this line defines a sub itself.
bool AbstractMachine::Step::own_file_has(NameId sub) const {
  if (sub >= m.program_.by_label.size()) return false;
  const uint32_t file = m.linked_.file_of(here);
  return std::ranges::any_of(m.program_.by_label[sub], [&](StatementId id) {
    return m.program_.at(id).opens_sub() && m.linked_.file_of(id) == file;
  });
}

void AbstractMachine::Step::sub() {
  if (called() && context.fanuc) {
    return stop(StopKind::kStyleNeedsCall, "'O.... sub' subroutine must be called with 'O.... call'");
  }
  if (skipping) {
    if (!enter_sub()) return;
    state.skip = kNoLabel;
    state.seek = false;
  }
  if (called()) {
    if (m.profile_.version >= Version::k2_10 && m.label_of(label) != context.sub) {
      return stop(StopKind::kSubNestedInCall,
                  "Nested subroutine definition: 'O" + m.name(m.label_of(label)) +
                      " sub' found inside called subroutine 'O" + m.name(context.sub) + "'");
    }
    if (!is_called_sub()) hazard(HazardKind::kSubInCall);
    return next_line();
  }
  if (!enter_sub()) return;
  state.skip = label;
  state.defining = m.label_of(label);
  next_line();
}

void AbstractMachine::Step::bare() {
  if (called() && !context.fanuc)
    return stop(StopKind::kStyleNeedsM98, "Fanuc 'O....' subroutine must be called with 'M98'");
  if (skipping) {
    if (!enter_sub()) return;
    state.skip = kNoLabel;
    state.seek = false;
  } else if (called() && !is_called_sub()) {
    const auto calls = [&](const Call& call) {
      return call.callee == s.label && m.program_.at(call.statement).kind == LineKind::kM98;
    };
    if (std::ranges::any_of(m.program_.calls, calls)) hazard(HazardKind::kRunsIntoSub);
  }
  next_line();
}

void AbstractMachine::Step::come_back() {
  const bool never = s.label >= m.returns_value_.size() || !m.returns_value_[s.label];
  m.evaluator_.come_back(state.parameters, returned_value ? &*returned_value : nullptr, never);
}

void AbstractMachine::Step::leave_sub() {
  const bool endsub = s.keyword == Keyword::kEndsub;
  if (called()) {
    if (context.fanuc) return stop(StopKind::kStyleNeedsM99, "Fanuc 'O....' subroutine definition must end with 'M99'");
    if (endsub) {
      state.skip = kNoLabel;
      if (!is_called_sub()) hazard(HazardKind::kForeignEnd);
    }
    come_back();
    if (!restore_modes()) return;
    return out.leave(state);
  }
  if (defining()) {
    come_back();  // measured: skipping the definition is enough
    if (endsub) {
      state.skip = kNoLabel;
      state.defining = kNoName;
      state.flags.returned = kNo;
    }
    return next_line();
  }
  const uint8_t returned = state.flags.returned;
  if ((returned & kNo) != 0) {
    state.flags.returned = kNo;
    if (documented(StopKind::kReturnOutside, at_line("not in a subroutine definition: '" + line_text() + "'"))) {
      // Measured: `endsub` is still an error, `return` goes on.
      if (endsub) {
        stop(StopKind::kNotInDefinition, "Not in subroutine definition");
      } else {
        go(state, here + 1);
      }
    }
  }
  if ((returned & kYes) != 0) {
    state.flags.returned = kYes;
    if (endsub) return stop(StopKind::kNotInDefinition, "Not in subroutine definition");
    go(std::move(state), here + 1);
  }
}

/// Evaluates the arguments of a call. False where that stops every run.
bool AbstractMachine::Step::arguments(std::vector<ValueId>* values) {
  values->reserve(s.value_count);
  for (uint32_t i = 0; i < s.value_count; ++i) {  // none on a line of words
    const Evaluation e = evaluate(value(i));
    report_reads();
    if (!settle(e)) return false;
    values->push_back(e.value);
  }
  if (error() != nullptr) stop_error();
  return error() == nullptr;
}

/// A sub that owlint does not know runs and comes back. Where files have a sub of that label, too, all later calls run
/// the unknown one.
void AbstractMachine::Step::call_elsewhere(FullLabel sub) {
  State back = state;
  if (m.opens_somewhere(m.label_of(sub))) back.table.set(m.pool_, sub, Definers::kElsewhere);
  Evaluator::call_outside(back.parameters);
  back.flags.returned = kYes;
  go(std::move(back), here + 1);
}

void AbstractMachine::Step::call(int repeats, bool fanuc) {
  std::vector<ValueId> passed;
  if (!fanuc && !arguments(&passed)) return;
  if (context.depth >= kMaxCallDepth) return stop(StopKind::kCallTooDeep, "Too many subroutine levels");

  // Where no chain is too deep, calls at all depths are alike.
  const int depth = m.structure_.shallow_calls ? 1 : context.depth + 1;
  const Context callee{m.label_of(label),
                       depth,
                       fanuc,
                       fanuc ? 30 : static_cast<int>(passed.size()),
                       context.remaps,
                       context.built_in,
                       context.contour || s.kind == LineKind::kContour,
                       false};
  State enter = state;
  enter.looped = false;
  enter.branch = Branch::kNone;
  enter.parameters.local_outcomes = {};
  if (fanuc) {
    enter.parameters.locals = m.evaluator_.share_numbers({}, state.parameters.locals);
  } else {
    enter.parameters.locals = {};
    m.evaluator_.pass(enter.parameters, passed);
    const NameId count = m.program_.syntax.names.find("n_args");
    if (count != kNoName && m.profile_.setup != nullptr && m.profile_.setup->counts_arguments) {
      m.evaluator_.set_name(enter.parameters, count, m.values_.intern(static_cast<double>(passed.size())));
    }
  }
  m.modes_.begin_level(enter.parameters);
  if (repeats == 0 || repeats == kUnknownRepeats) {
    // Measured: with L0 the call is made and simply goes on with the next line, inside; M99 comes back to that line.
    State inside = enter;
    inside.position = here + 1;
    m.leave_modes(inside, here);
    out.call(state, std::move(inside), callee, 1);
    if (repeats == 0) return;
  }
  find_sub(std::move(enter), callee, repeats);
}

/// A sub that the file of the call has, but that LinuxCNC has not read yet: if there is a file of that name, it runs instead.
void AbstractMachine::Step::tell_file_before_own(NameId sub, CallTarget target) {
  const uint32_t file = m.linked_.file_of(here);
  if (target.file == CallTarget::kNotFound || target.file == file) return hazard(HazardKind::kOwnHelper);
  if (file == 0 && !m.program_.sub_file) return;  // told without the flow: the order of the lines says it
  for (const StatementId id : m.program_.by_label[sub]) {
    if (m.program_.at(id).opens_sub() && m.linked_.file_of(id) == target.file)
      return hazard(HazardKind::kOtherHelper, id);
  }
}

/// A call whose parameters are in place goes where its sub is.
void AbstractMachine::Step::find_sub(State enter, Context callee, int repeats) {
  // A name with a path means its last part in the label table, but is the called sub's name for its own labels.
  const NameId plain = m.intern(std::string(called_label(m.name(callee.sub), m.profile_.version)));
  const FullLabel defined = plain == callee.sub ? label : m.full_label(kGlobalScope, plain);
  const Definers::Set set = m.definers_.get(state.table.get(defined));
  take_apart(set);
  enter.mixed = state.mixed;
  const bool has_own = m.linked_.files().size() > 1 && own_file_has(plain);
  for (const StatementId line : set.lines) {
    if (has_own) {
      const bool own = m.linked_.file_of(line) == m.linked_.file_of(here);
      hazard(own ? HazardKind::kOwnHelper : HazardKind::kOtherHelper, line);
    }
    State known = enter;
    known.table.set(m.pool_, defined, Definers::one(line));
    known.position = line;  // the definition's line is read again (measured: text after it stops there)
    out.call(state, std::move(known), callee, repeats);
  }
  if (!set.undefined) {
    if (set.lines.empty()) call_elsewhere(defined);
    return;
  }
  const CallTarget target = m.target(callee.sub);
  if (has_own) tell_file_before_own(plain, target);
  enter.table.set(m.pool_, defined, 0);
  enter.skip = defined;
  enter.seek = true;
  if (target.file != CallTarget::kNotFound) {
    enter.position = m.linked_.files()[target.file].first;
    return out.call(state, std::move(enter), callee, repeats);
  }
  if (m.profile_.version >= Version::k2_9 && breaks_expansion(m.name(callee.sub))) {
    return hazard(HazardKind::kLookupCrash);
  }
  // Without the file of a remap LinuxCNC does not even start, which is said of the INI.
  const bool nowhere = s.kind == LineKind::kRemap && !m.linked_.search_path().find_other_case(m.name(callee.sub));
  if (nowhere) return call_elsewhere(defined);
  if (m.may_be_elsewhere(callee.sub)) {
    call_elsewhere(defined);  // or it stops
    if (m.profile_.may_be_python()) return;
  }
  if (m.profile_.version >= Version::k2_10 && called() && m.linked_.file_of(here) != 0) {
    return stop(StopKind::kSubNotFound,
                "Subroutine 'O" + m.name(callee.sub) + "' not found -- not in offset table and no file found",
                kNoStatement, m.name(callee.sub));
  }
  enter.position = here + 1;
  out.call(state, std::move(enter), callee, repeats);
}

}  // namespace owlint::flow
