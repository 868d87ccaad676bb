// What the interpreter does with one line in a given state: reading it, its label, its values; then its keyword acts.
#include <algorithm>
#include <cmath>

#include "analyzer/flow/interpreter/kept_values.h"
#include "analyzer/flow/interpreter/step.h"
#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/syntax/questions.h"

namespace owlint::flow {

void AbstractMachine::step(State state, const Context& context, Listener& out) {
  Step step(*this, std::move(state), context, out);
  step.run();
}

void AbstractMachine::Step::run() {
  const LineError* e = error();
  const bool anywhere = e != nullptr &&
      ((e->kind < StopKind::kKeywordUnknown && e->kind != StopKind::kLabelExpression) || s.kind == LineKind::kM98);
  if (anywhere) {
    if (e->first_value == kNoExpr) return stop_error();
    if (settle_before(*e)) repeated_word(*e);
    return;
  }
  // Measured: `O…` and M98 stop where they are read, also where lines are skipped; M99 only where it would return.
  if (m.refuses_fanuc(s) || (m.no_fanuc_ && s.kind == LineKind::kM99 && called() && !skipping)) {
    return stop(StopKind::kFanucDisabled,
                s.kind == LineKind::kOWord     ? "DISABLE_FANUC_STYLE_SUB disabled in INI file, but found bare O-word"
                    : s.kind == LineKind::kM98 ? "DISABLE_FANUC_STYLE_SUB set in INI file, but found m98"
                                               : "DISABLE_FANUC_STYLE_SUB set in INI file, but found m99");
  }
  if (s.kind == LineKind::kOWord) return o_word();
  plain();
}

void AbstractMachine::Step::plain() {
  if (s.kind == LineKind::kPercent && m.program_.syntax.percent) {
    if (here == 0) return next_line();
    if (skipping) return stop(StopKind::kFileEnd, "Failed to find sub 'O" + m.full_text(state.skip) + "' before EOF");
    return out.end(state);
  }
  if (s.kind == LineKind::kM98) return m98();
  if (s.kind == LineKind::kMachineCheck && asks_about_call(m.program_.syntax, here)) return machine_check();
  if (skipping) return next_line();
  if (s.kind == LineKind::kModeLine) return modes();
  if (s.kind == LineKind::kRemap) return remap();
  if (s.kind == LineKind::kUserCode) return user_code();
  if (s.kind == LineKind::kMachineCheck) return machine_check();
  if (s.kind == LineKind::kAbort) return context.contour ? next_line() : out.end(state);
  if (s.kind == LineKind::kPercent) return stop(StopKind::kBadCharacter, "Bad character '%' used");
  if (s.kind == LineKind::kM99 && called()) return m99();
  Parameters after = state.parameters;
  Evaluation e = m.evaluator_.assign(s, after, &reads);
  while (e.may_fail == StopKind::kNameUndefined) {
    settle(e);  // and on the other paths the name is there
    after = state.parameters;
    e = m.evaluator_.assign(s, after, &reads);
  }
  report_reads();
  if (!settle(e)) return;
  if (keeps_values(m.program_.syntax, s, state.parameters, m.evaluator_)) hazard(HazardKind::kKeepsValues);
  state.parameters = std::move(after);
  if (m.program_.syntax.reads_place) m.modes_.end_line(state.parameters);
  if (m.mode_uses_.follows_place(here)) write_offsets();
  if (may_end(s)) out.end(state);
  if (context.contour && error() != nullptr && passes_in_contour(*error())) return next_line();
  if (e.read_only != kNoName && (error() == nullptr || is_carried_out(*error()))) {
    const std::string& name = m.name(e.read_only);
    return stop(StopKind::kNameReadOnly, "Cannot assign to read-only parameter #<" + name + ">", kNoStatement, name);
  }
  if (error() != nullptr) return stop_error();
  if (s.kind == LineKind::kM99Behind && called() && !context.contour)
    return stop(StopKind::kM99Behind, "Bug:  Reached convert_stop() from M99 as subprogram return");
  if (s.has_m99()) {
    const StatementId opener = m.program_.regions[m.program_.region_of[here]].opener;
    if (opener != kNoStatement && m.program_.at(opener).is(Keyword::kBare)) hazard(HazardKind::kRunsIntoSub, opener);
    return out.end(state);  // of a run of the main program; the machine itself starts it again
  }
  if (s.kind == LineKind::kProgramEnd && !context.contour) return out.end(state);
  if (s.kind == LineKind::kContour && m.profile_.version >= Version::k2_9) {
    if (!resolve_label()) return;
    if (label != kNoLabel) return call(1, false);
    Evaluator::call_outside(state.parameters);
  }
  next_line();
}

/// Whether a line stops with this when it acts, for which its parameters have been set.
bool AbstractMachine::Step::is_carried_out(const LineError& error) {
  return is_of_modes_or_place(error.kind) && error.message != kPolarOutsideG17 && error.message != kIncrementalG53;
}

/// What no line of a contour stops with: nothing of it is executed, and some axes may be named that the machine does not have.
bool AbstractMachine::Step::passes_in_contour(const LineError& error) {
  if (is_of_modes_or_place(error.kind)) return true;
  return error.message == "Bad character 'u' used" || error.message == "Bad character 'w' used";
}

/// Whether the line has an M code that is computed: it may be M2.
bool AbstractMachine::Step::may_end(const Statement& line) const {
  if (line.kind != LineKind::kWords) return false;
  return std::ranges::any_of(m.program_.syntax.items_of(line), [](const Item& item) { return item.letter == 'm'; });
}

/// A second P or Q behind one whose value is computed: where that is -1 or less, it counts as none.
void AbstractMachine::Step::repeated_word(const LineError& repeated) {
  const ValueId first = evaluate(repeated.first_value).value;
  const Range range = m.values_.range(first);
  if (range.low > -1) return stop(repeated.kind, repeated.message);
  if (range.high > -1) may_stop(repeated.kind, repeated.message);
  next_line();
}

/// Without the machine's INI it is not known which codes it has.
UserCode AbstractMachine::Step::known_of(uint32_t user_code) const {
  return m.profile_.setup == nullptr ? UserCode::kUnknown : m.profile_.setup->user_code(static_cast<int>(user_code));
}

void AbstractMachine::Step::user_code() {
  const std::string message = "Unknown m code used: M" + std::to_string(s.first);
  const UserCode known = known_of(s.first);
  if (known == UserCode::kMissing) return stop(StopKind::kUserCodeMissing, message);
  if (known == UserCode::kUnknown) may_stop(StopKind::kUserCodeMissing, message);
  next_line();
}

/// The question about such a code of this line, if it is behind this one.
const Statement* AbstractMachine::Step::user_code_behind() const {
  const StatementId next = here + 1;
  if (next >= m.program_.size()) return nullptr;
  const Statement& line = m.program_.at(next);
  return line.kind == LineKind::kUserCode && on_one_line(line, s) ? &line : nullptr;
}

void AbstractMachine::Step::machine_check() {
  const LineError& what = m.program_.syntax.errors[s.first];
  if (context.contour && passes_in_contour(what)) return next_line();
  if (what.first_value != kNoExpr) {
    if (settle_before(what)) repeated_word(what);
    return;
  }
  if (is_mistake(what.kind, what.message)) return stop(what.kind, what.message);
  may_stop(what.kind, what.message);
  next_line();
}

/// Measured: M98 is read with all its values wherever it stands, and stops there; where lines are skipped it only does
/// not call.
void AbstractMachine::Step::m98() {
  const auto computable = [&](const Evaluation& found, ExprId id) {
    report_reads();
    return settle(skipping ? or_fresh(found, id) : found);
  };
  int repeats = 1;
  for (uint32_t i = 0; i < s.value_count; ++i) {
    const Evaluation e = evaluate(value(i));
    if (!computable(e, value(i))) return;
    if (i > 0 || !s.repeats) continue;
    if (!times_called(e, &repeats)) return;
  }
  if (!resolve_label()) return;
  if (!skipping) {
    if (const Statement* asks = mode_line_of(m.program_.syntax, here); asks != nullptr && refuses_words(*asks)) return;
  }
  if (skipping || label == kNoLabel) return next_line();
  call(repeats, true);
}

/// How often the L of M98 calls. False where no call can be made of it.
bool AbstractMachine::Step::times_called(const Evaluation& of_l, int* times) {
  *times = kUnknownRepeats;
  const bool known = m.values_.is_constant(of_l.value);
  // What the program never set reads 0 in a freshly started interpreter: then it may be refused.
  const ValueId count = known ? of_l.value : evaluate(value(0), Unset::kZero).value;
  if (!m.values_.is_constant(count)) return true;
  long whole = 0;
  const bool odd = !to_integer(m.values_.value(count), &whole);
  if (odd || whole < 0) {
    const bool mixed = state.mixed;
    state.mixed = mixed || !known;
    stop(StopKind::kM98Words, odd ? "Non integer value for integer" : "Negative l word used");
    state.mixed = mixed;
    return !known;
  }
  if (known) *times = static_cast<int>(std::min(whole, 1'000'000L));
  return true;
}

/// M99 as the first word, in a sub.
void AbstractMachine::Step::m99() {
  if (s.rest_to > s.rest_from) return stop(StopKind::kM99Rest, "Unexpected character after O-word");
  if (!context.fanuc && !context.remap) {
    return stop(StopKind::kStyleNeedsEndsub,
                "'O.... endsub' or 'O.... return' must follow 'O.... sub' subroutine definition");
  }
  m.evaluator_.come_back(state.parameters, nullptr, true);
  if (restore_modes()) out.leave(state);
}

/// Finds the full label. False when evaluating it stops; `label` stays none when it cannot be known.
bool AbstractMachine::Step::resolve_label() {
  NameId name = s.label;
  if (s.label_expr != kNoExpr) {
    const Evaluation e = evaluate(s.label_expr);
    report_reads();
    if (!settle(e)) return false;
    if (!m.values_.is_constant(e.value)) {
      label_range = m.values_.range(e.value);
      return true;
    }
    std::string text;
    if (!label_of_number(m.values_.value(e.value), &text)) {
      stop(StopKind::kLabelNotInteger, "Non integer value for integer");
      return false;
    }
    name = m.intern(text);
    if (s.calls()) m.computed_calls_.insert(name);
  }
  const bool global = s.kind != LineKind::kOWord || global_label(s.keyword);
  const NameId scope = global ? kGlobalScope : called() ? context.sub : state.defining;
  label = m.full_label(scope, name);
  return true;
}

void AbstractMachine::Step::o_word() {
  if (s.refused) {  // only read as an O-word by us, to understand the rest
    if (skipping) return next_line();
    return stop_error();
  }
  if (error() != nullptr && error()->kind == StopKind::kLabelExpression) return stop_error();
  if (!resolve_label()) return;
  const Keyword k = s.keyword;
  if (k == Keyword::kUnknown) {
    if (defining()) return next_line();
    return stop_error();
  }
  if ((k == Keyword::kSub || k == Keyword::kBare) && defining()) {
    return stop(StopKind::kSubNested, "Nested subroutine definition");
  }
  if (label == kNoLabel) {
    // The label is computed from something unknown: no claim, on either side. A call comes back, having done
    // whatever it likes to the global parameters.
    if (k == Keyword::kCall && !skipping && !defining() && !call_any()) return;
    return next_line();
  }
  Truth truth = Truth::kOpen;
  double number = NAN;
  const bool target = state.skip == label;
  if (k == Keyword::kEndsub || k == Keyword::kReturn) {
    if (!skipping || target) {
      if (s.value_count > 0) {
        Evaluation e = evaluate(value(0));
        report_reads();
        e = or_fresh(e, value(0));
        if (!settle(e, defining())) return;
        returned_value = e.value;
      } else if (s.has_bracket) {
        return stop_error();
      }
    }
  } else if (defining()) {
    return next_line();
  } else if (k == Keyword::kCall) {
    if (skipping) return next_line();
  } else if (k == Keyword::kIf || k == Keyword::kElseif || k == Keyword::kWhile || k == Keyword::kRepeat) {
    if ((!skipping || target) && !condition(&truth, &number)) return;
  }
  if (!skipping && error() != nullptr && error()->kind == StopKind::kTrailingText) return stop_error();
  if (skipping && !target) return next_line();
  if (state.seek && k != Keyword::kSub && k != Keyword::kBare) return next_line();
  act(truth, number);
}

/// A call whose label is computed from something that is not known: any sub with a number in question may run, and what it does
/// with the arguments is not proven; or another one, of which nothing is known. False where the arguments stop every run.
bool AbstractMachine::Step::call_any() {
  std::vector<ValueId> passed;
  if (!arguments(&passed)) return false;
  const auto first =
      std::ranges::lower_bound(m.numbered_subs_, label_range.low, {}, [](const auto& sub) { return sub.first; });
  const auto last =
      std::ranges::upper_bound(m.numbered_subs_, label_range.high, {}, [](const auto& sub) { return sub.first; });
  if (static_cast<size_t>(last - first) <= m.limits_.computed_candidates && context.depth < m.limits_.computed_depth) {
    for (auto sub = first; sub != last; ++sub) {
      const auto& [number, name] = *sub;
      if (name == context.sub || !label_range.has(number)) continue;
      Step one(m, state, context, out);
      one.state.mixed = true;
      one.label = m.full_label(kGlobalScope, name);
      one.call(1, false);
    }
  }
  Evaluator::call_outside(state.parameters);
  return true;
}

void AbstractMachine::Step::act(Truth truth, double number) {
  switch (s.keyword) {
    case Keyword::kSub: return sub();
    case Keyword::kBare: return bare();
    case Keyword::kEndsub:
    case Keyword::kReturn: return leave_sub();
    case Keyword::kCall: return call(1, false);
    case Keyword::kDo:
      state.skip = kNoLabel;
      if (entry() == 0) {
        define_here();
      } else if (m.definers_.get(entry()).undefined) {
        set_entry(m.definers_.without_undefined(m.definers_.join(entry(), Definers::one(here))));
      }
      return next_line();
    case Keyword::kRepeat: return repeat(truth, number);
    case Keyword::kWhile: return while_(truth);
    case Keyword::kIf: return if_(truth);
    case Keyword::kElseif:
    case Keyword::kElse: return else_(truth);
    case Keyword::kEndif: return endif();
    case Keyword::kBreak:
    case Keyword::kContinue: return jump();
    case Keyword::kEndwhile:
    case Keyword::kEndrepeat: return end_loop();
    case Keyword::kUnknown: return next_line();
  }
}

}  // namespace owlint::flow
