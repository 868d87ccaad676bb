// One line of the O-word machine: what the interpreter does with it in a given state, for every member of the sets
// that the state holds. Follows the transition table, keyword by keyword.
#include <algorithm>
#include <cmath>

#include "analyzer/flow/machine.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {
namespace {

constexpr int kUnknownRepeats = -1;

enum class Truth : uint8_t { kFalse, kTrue, kUnknown };

}  // namespace

struct Machine::Step {
  Machine& m;
  State state;
  const Context& context;
  Listener& out;
  const Statement& s;
  StatementId here;
  bool skipping;
  FullLabel label = kNoLabel;
  Fact tested;  ///< the condition of this line, when its outcome can be remembered
  ReadLog reads;

  Step(Machine& machine, State start, const Context& ctx, Listener& listener)
      : m(machine), state(std::move(start)), context(ctx), out(listener), s(m.program_.at(state.position)),
        here(state.position), skipping(state.skip != kNoLabel) {}

  const LineError* error() const { return m.program_.syntax.error(s); }
  bool defining() const { return state.defining != kNoName; }
  bool called() const { return context.depth > 0; }
  bool warn_only() const { return m.profile_.warn_only(); }

  // --- leaving the line ---

  /// `branch`: 1 when this outcome needs a true condition, 2 a false one.
  void go(State next, StatementId position, uint8_t branch = 0) {
    if (branch != 0) m.evaluator_.learn(next.parameters, tested, branch == 1);
    next.position = position;
    next.branch = branch;
    next.looped = position <= here && m.program_.at(position).is(Keyword::kRepeat);
    out.successor(std::move(next));
  }
  void next_line() { go(std::move(state), here + 1); }

  void stop(StopKind kind, std::string message, StatementId other = kNoStatement, std::string detail = {}) {
    out.stop(state, kind, other, std::move(message), std::move(detail));
  }
  void stop_error() { stop(error()->kind, error()->message); }

  /// One of the eight documented errors: stops, or under FEATURE 0x20 becomes a message. True when it goes on.
  bool documented(StopKind kind, std::string message, StatementId other = kNoStatement) {
    if (!warn_only()) {
      stop(kind, std::move(message), other);
      return false;
    }
    out.hazard(state, HazardKind::kWarned, 0, kind, std::move(message));
    return true;
  }

  // --- evaluating ---

  /// False when evaluation stops the interpreter on every merged path.
  bool settle(const Evaluation& e, bool at_definition = false) {
    const StopKind kind = e.fails != StopKind::kNone ? e.fails : e.may_fail;
    if (kind != StopKind::kNone) {
      std::string message = e.message != nullptr ? e.message : "";
      std::string detail;
      if (e.name != kNoName) {
        detail = m.program_.name(e.name);
        message = kind == StopKind::kNameReadOnly ? "Cannot assign to read-only parameter #<" + detail + ">"
                                                  : "Named parameter #<" + detail + "> not defined";
      }
      if (at_definition) out.hazard(state, HazardKind::kValueAtDefinition, 0, kind, message);
      stop(kind, std::move(message), kNoStatement, std::move(detail));
    }
    return e.fails == StopKind::kNone;
  }

  Evaluation evaluate(ExprId id, bool zero_when_unassigned = false) {
    return m.evaluator_.evaluate(id, state.parameters, zero_when_unassigned, defining(), &reads);
  }

  void report_reads() {
    for (uint32_t n = 1; n <= 30; ++n) {
      if ((reads.not_passed >> n & 1) != 0) out.hazard(state, HazardKind::kArgumentNotPassed, n, StopKind::kNone, "");
    }
    reads.not_passed = 0;
  }

  ExprId value(uint32_t i) const { return m.program_.syntax.values[s.first_value + i]; }

  /// The condition of `if`, `elseif`, `while`; false when it stops.
  bool condition(Truth* truth, double* number = nullptr) {
    if (s.value_count == 0) {
      stop_error();
      return false;
    }
    const Evaluation e = evaluate(value(0));
    reads.not_passed = 0;  // testing an argument that was not passed is how optional arguments are written
    if (!settle(e)) return false;
    const bool known = m.constants_.is_constant(e.value);
    *truth = !known ? Truth::kUnknown : m.constants_.value(e.value) != 0 ? Truth::kTrue : Truth::kFalse;
    if (!known && !s.is(Keyword::kRepeat)) {
      tested = m.evaluator_.fact(value(0));
      const int before = Evaluator::known(state.parameters, tested);
      if (before != 0) *truth = before == 1 ? Truth::kTrue : Truth::kFalse;
    }
    if (number != nullptr && known) *number = m.constants_.value(e.value);
    return true;
  }

  // --- the table ---

  /// Structured blocks are in the table from their opener on, without being written there.
  bool structured() const {
    const BlockId block = m.program_.block_of[here];
    return block != kNoBlock && m.structured_[block];
  }
  uint32_t entry() const {
    if (!structured()) return state.table.get(label);
    const StatementId opener = m.program_.blocks[m.program_.block_of[here]].opener;
    return opener == here ? 0 : Definers::one(opener);
  }
  void set_entry(uint32_t packed) {
    if (!structured()) state.table.set(m.pool_, label, packed);
  }
  void define_here() { set_entry(Definers::one(here)); }
  Keyword kind_of(StatementId line) const { return m.program_.at(line).keyword; }
  uint32_t line_of(StatementId id) const { return m.program_.at(id).line; }
  std::string line_text() const {
    const std::string_view text = m.program_.source->slice({s.offset, s.end});
    const size_t first = text.find_first_not_of(" \t\r");
    const size_t last = text.find_last_not_of(" \t\r");
    return first == std::string_view::npos ? std::string() : std::string(text.substr(first, last - first + 1));
  }
  /// `N: ` as the interpreter begins its messages about labels.
  std::string at_line(const std::string& rest) const { return std::to_string(s.line) + ": " + rest; }

  void set_count(FullLabel of, int count) {
    auto& counts = state.counts;
    const auto found = std::ranges::lower_bound(counts, of, {}, &std::pair<FullLabel, uint8_t>::first);
    const bool present = found != counts.end() && found->first == of;
    if (count < 0) {
      if (present) counts.erase(found);
    } else if (present) {
      found->second = static_cast<uint8_t>(count);
    } else {
      counts.insert(found, {of, static_cast<uint8_t>(count)});
    }
  }
  int count() const {
    for (const auto& [of, count] : state.counts) {
      if (of == label) return count;
    }
    return -1;
  }

  // --- keywords ---

  void run();
  void plain();
  void o_word();
  bool resolve_label();
  void act(Truth truth, double number);
  bool enter_sub();
  void sub();
  void bare();
  void leave_sub();
  void call(int repeats, bool fanuc);
  void repeat(Truth truth, double number);
  void count_passes(Truth truth, double number);
  void while_(Truth truth);
  void if_(Truth truth);
  void else_(Truth truth);
  void endif();
  void jump();
  void end_loop();
  void end_loop_at(StatementId opener);

  /// Splits on "undefined": reports `kind` for that part; true when a defined part remains (then narrowed to it).
  bool require_defined(StopKind kind);
  void crash(StopKind kind, std::string message);
};

void Machine::step(State state, const Context& context, Listener& out) {
  Step step(*this, std::move(state), context, out);
  step.run();
}

void Machine::Step::run() {
  const LineError* e = error();
  if (e != nullptr && e->kind < StopKind::kKeywordUnknown && e->kind != StopKind::kLabelExpression) return stop_error();
  if (s.kind == LineKind::kOWord) return o_word();
  plain();
}

void Machine::Step::plain() {
  if (s.kind == LineKind::kPercent && m.program_.syntax.percent) {
    if (here == 0) return next_line();
    if (skipping) return stop(StopKind::kFileEnd, "Failed to find sub 'O" + m.full_text(state.skip) + "' before EOF");
    return out.end(state);
  }
  if (skipping) return next_line();
  if (s.kind == LineKind::kPercent) return stop(StopKind::kBadCharacter, "Bad character '%' used");
  if (s.kind == LineKind::kM98 || s.kind == LineKind::kM99) {
    if (error() != nullptr) return stop_error();
    if (s.kind == LineKind::kM98) {
      if (!resolve_label()) return;
      if (label == kNoLabel) return next_line();
      int repeats = 1;
      if (s.value_count > 0) {
        const Evaluation times = evaluate(value(0));
        if (!settle(times)) return;
        repeats = m.constants_.is_constant(times.value)
                      ? static_cast<int>(std::clamp(m.constants_.value(times.value), 0.0, 1e6))
                      : kUnknownRepeats;
      }
      return call(repeats, true);
    }
    if (!called()) return out.end(state);  // ends a run; the machine itself starts the program again
    if (!context.fanuc) {
      return stop(StopKind::kStyleNeedsEndsub, "'O.... endsub' or 'O.... return' must follow 'O.... sub' subroutine definition");
    }
    return out.leave(state);
  }
  const State before = state;
  const Evaluation e = m.evaluator_.assign(s, state.parameters, &reads);
  report_reads();
  if (e.fails != StopKind::kNone || e.may_fail != StopKind::kNone) {
    State after = std::move(state);
    state = before;
    if (!settle(e)) return;
    state = std::move(after);
  }
  if (error() != nullptr) return stop_error();
  if (s.kind == LineKind::kProgramEnd) return out.end(state);
  next_line();
}

/// Finds the full label. False when evaluating it stops; `label` stays none when it cannot be known.
bool Machine::Step::resolve_label() {
  NameId name = s.label;
  if (s.label_expr != kNoExpr) {
    const Evaluation e = m.evaluator_.evaluate(s.label_expr, state.parameters, false, defining(), &reads);
    report_reads();
    if (!settle(e)) return false;
    if (!m.constants_.is_constant(e.value)) return true;
    std::string text;
    if (!label_of_number(m.constants_.value(e.value), &text)) {
      stop(StopKind::kLabelNotInteger, "Non integer value for integer");
      return false;
    }
    name = m.program_.syntax.names.intern(text);
  }
  const bool global = s.kind == LineKind::kM98 || global_label(s.keyword);
  const NameId scope = global ? kGlobalScope : called() ? context.sub : state.defining;
  label = m.full_label(scope, name);
  return true;
}

void Machine::Step::o_word() {
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
    if (k == Keyword::kCall && !skipping && !defining()) Evaluator::call_outside(state.parameters);
    return next_line();
  }
  Truth truth = Truth::kUnknown;
  double number = NAN;
  const bool target = state.skip == label;
  if (k == Keyword::kEndsub || k == Keyword::kReturn) {
    if (!skipping || target) {
      if (s.value_count > 0) {
        Evaluation e = evaluate(value(0));
        report_reads();
        if (e.fails == StopKind::kNone && e.may_fail == StopKind::kNone) {
          // A parameter that the program never set reads 0 in a freshly started interpreter: then it may fail.
          const Evaluation fresh = evaluate(value(0), true);
          e.may_fail = fresh.fails;
          e.message = fresh.message;
        }
        if (!settle(e, defining())) return;
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

void Machine::Step::act(Truth truth, double number) {
  switch (s.keyword) {
    case Keyword::kSub: return sub();
    case Keyword::kBare: return bare();
    case Keyword::kEndsub: case Keyword::kReturn: return leave_sub();
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
    case Keyword::kElseif: case Keyword::kElse: return else_(truth);
    case Keyword::kEndif: return endif();
    case Keyword::kBreak: case Keyword::kContinue: return jump();
    case Keyword::kEndwhile: case Keyword::kEndrepeat: return end_loop();
    case Keyword::kUnknown: return next_line();
  }
}

// --- subs ---

/// Enters the sub's label in the table; false when it is there on every path.
bool Machine::Step::enter_sub() {
  const Definers::Set set = m.definers_.get(entry());
  const std::string& path = m.program_.source->path();
  const std::string where = "File:" + path + " line:" + std::to_string(s.line);
  const std::string& name = m.program_.name(s.label_expr == kNoExpr ? s.label : m.label_of(label));
  for (const StatementId line : set.lines) {
    if (line == here) {
      stop(StopKind::kSubIllegalLocation, where + " sub: o|" + name + "| found in illegal location", line);
    } else {
      stop(StopKind::kSubRedefined, where + " redefining sub: o|" + name + "| already defined in file:" + path, line);
    }
  }
  if (!set.undefined) return false;
  define_here();
  return true;
}

void Machine::Step::sub() {
  if (called() && context.fanuc) {
    return stop(StopKind::kStyleNeedsCall, "'O.... sub' subroutine must be called with 'O.... call'");
  }
  if (skipping) {
    if (!enter_sub()) return;
    state.skip = kNoLabel;
    state.seek = false;
  }
  if (called()) return next_line();
  if (!enter_sub()) return;
  state.skip = label;
  state.defining = m.label_of(label);
  next_line();
}

void Machine::Step::bare() {
  if (called() && !context.fanuc) return stop(StopKind::kStyleNeedsM98, "Fanuc 'O....' subroutine must be called with 'M98'");
  if (skipping) {
    if (!enter_sub()) return;
    state.skip = kNoLabel;
    state.seek = false;
  }
  next_line();
}

void Machine::Step::leave_sub() {
  const bool endsub = s.keyword == Keyword::kEndsub;
  if (called()) {
    if (context.fanuc) return stop(StopKind::kStyleNeedsM99, "Fanuc 'O....' subroutine definition must end with 'M99'");
    if (endsub) state.skip = kNoLabel;
    return out.leave(state);
  }
  if (defining()) {
    if (endsub) {
      state.skip = kNoLabel;
      state.defining = kNoName;
      state.returned = kNo;
    }
    return next_line();
  }
  const uint8_t returned = state.returned;
  if ((returned & kNo) != 0) {
    state.returned = kNo;
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
    state.returned = kYes;
    if (endsub) return stop(StopKind::kNotInDefinition, "Not in subroutine definition");
    go(std::move(state), here + 1);
  }
}

void Machine::Step::call(int repeats, bool fanuc) {
  std::vector<ValueId> arguments;
  if (!fanuc) {
    for (uint32_t i = 0; i < s.value_count; ++i) {
      const Evaluation e = evaluate(value(i));
      report_reads();
      if (!settle(e)) return;
      arguments.push_back(e.value);
    }
    if (error() != nullptr) return stop_error();
  }
  if (context.depth >= kMaxCallDepth) return stop(StopKind::kCallTooDeep, "Too many subroutine levels");

  // Where no chain is too deep, calls at all depths are alike.
  const int depth = m.depth_matters_ ? context.depth + 1 : 1;
  const Context callee{m.label_of(label), depth, fanuc, fanuc ? 30 : static_cast<int>(arguments.size())};
  State enter = state;
  enter.looped = false;
  enter.branch = 0;
  enter.parameters.local_facts = {};
  if (fanuc) {
    enter.parameters.locals = m.evaluator_.share_numbers({}, state.parameters.locals);
  } else {
    enter.parameters.locals = {};
    for (long n = 1; n < kFirstGlobalNumber; ++n) {
      const bool passed = n <= static_cast<long>(arguments.size());
      m.evaluator_.set_number(enter.parameters, n, passed ? arguments[n - 1] : kNotPassed);
    }
  }
  if (repeats == 0 || repeats == kUnknownRepeats) {
    // Measured: with L0 the call is made and simply goes on with the next line, inside; M99 comes back to that line.
    State inside = enter;
    inside.position = here + 1;
    out.call(state, std::move(inside), callee, 1);
    if (repeats == 0) return;
  }
  const Definers::Set set = m.definers_.get(entry());
  for (const StatementId line : set.lines) {
    State known = enter;
    known.table.set(m.pool_, label, Definers::one(line));
    known.position = line;  // the definition's line is read again (measured: text behind it stops there)
    out.call(state, std::move(known), callee, repeats);
  }
  if (!set.undefined) return;
  if (m.program_.outside_subs.contains(callee.sub)) {
    // Found in another file: it is taken to come back.
    Evaluator::call_outside(state.parameters);
    state.returned = kYes;
    return next_line();
  }
  if (m.may_be_elsewhere(callee.sub)) {
    // A named sub that the file does not define, and no INI that says where else to look: it stops, or a file on the
    // machine's search path has it and it comes back.
    State back = state;
    Evaluator::call_outside(back.parameters);
    back.returned = kYes;
    go(std::move(back), here + 1);
  }
  enter.table.set(m.pool_, label, 0);
  enter.position = here + 1;
  enter.skip = label;
  enter.seek = true;
  out.call(state, std::move(enter), callee, repeats);
}

// --- loops ---

void Machine::Step::repeat(Truth truth, double number) {
  const Definers::Set set = m.definers_.get(entry());
  const State before = state;
  bool own = set.undefined;
  for (const StatementId line : set.lines) {
    if (line == here) {
      own = true;
      continue;
    }
    state = before;
    if (!documented(StopKind::kDuplicateLoop, at_line("duplicate O-word label: '" + line_text() + "' - defined in line " + std::to_string(line_of(line))), line)) continue;
    set_entry(Definers::one(line));
    state.skip = kNoLabel;
    if (kind_of(line) == Keyword::kRepeat) {
      count_passes(truth, number);  // both use the first one's count
    } else {
      go(state, here + 1);  // measured: the count that other blocks have never runs out
    }
  }
  if (!own) return;
  state = before;
  define_here();
  state.skip = kNoLabel;
  count_passes(truth, number);
}

/// Decides on the next pass of a `repeat` whose entry is in the table.
void Machine::Step::count_passes(Truth truth, double number) {
  const int left = count();
  if (left >= 0 && !state.looped) out.hazard(state, HazardKind::kStaleRepeatCount, 0, StopKind::kNone, "");
  const auto enter = [&](int remaining) {
    State in = state;
    in.skip = kNoLabel;
    std::swap(state, in);
    set_count(label, remaining);
    std::swap(state, in);
    go(std::move(in), here + 1, 1);
  };
  const auto pass_by = [&] {
    State after = state;
    std::swap(state, after);
    set_count(label, -1);
    state.skip = label;
    std::swap(state, after);
    go(std::move(after), here + 1, 2);
  };
  const bool fresh = left < 0 || left == kAnyCount;
  if (fresh) {
    if (truth == Truth::kUnknown) {
      enter(kManyLeft);
      pass_by();
    } else {
      const double times = std::round(number);
      if (times > 0) {
        enter(times - 1 <= kLargestExactCount ? static_cast<int>(times) - 1 : kManyLeft);
      } else {
        pass_by();
      }
    }
  }
  if (left < 0) return;
  if (left == kManyLeft || left == kAnyCount) {
    if (!fresh || truth != Truth::kUnknown) {
      enter(kManyLeft);
      pass_by();
    }
  } else if (left > 0) {
    enter(left - 1);
  } else {
    pass_by();
  }
}

void Machine::Step::while_(Truth truth) {
  const State before = state;
  const Definers::Set set = m.definers_.get(entry());
  const auto as = [&](uint32_t packed, StatementId opener) {
    state = before;
    set_entry(packed);
    state.skip = kNoLabel;
    const bool pre_test = opener == here || kind_of(opener) == Keyword::kWhile;
    if (pre_test) {
      if (truth != Truth::kFalse) go(state, here + 1, 1);
      if (truth != Truth::kTrue) {
        state.skip = label;
        go(state, here + 1, 2);
      }
      return;
    }
    const uint8_t breaking = state.breaking;
    if (truth != Truth::kFalse && (breaking & kNo) != 0) {
      State again = state;
      again.breaking = kNo;
      go(std::move(again), opener, 1);
    }
    if ((breaking & kStale) != 0 && truth != Truth::kFalse) out.hazard(before, HazardKind::kStaleBreak, 0, StopKind::kNone, "");
    if ((breaking & (kYes | kStale)) != 0) {  // ends whatever the condition
      State out_of_loop = state;
      out_of_loop.breaking = kNo;
      go(std::move(out_of_loop), here + 1);
    }
    if (truth != Truth::kTrue && (breaking & kNo) != 0) {
      state.breaking = kNo;
      go(state, here + 1, 2);
    }
  };
  if (set.undefined) as(Definers::one(here), here);
  for (const StatementId line : set.lines) {
    state = before;
    if (line != here && kind_of(line) != Keyword::kDo) {
      if (!documented(StopKind::kDuplicateLoop, at_line("duplicate O-word label: '" + line_text() + "' - defined in line " + std::to_string(line_of(line))), line)) continue;
    }
    as(Definers::one(line), line);
  }
}

/// `endwhile`, `endrepeat`.
void Machine::Step::end_loop() {
  const Keyword opener = opener_of(s.keyword);
  if (!require_defined(StopKind::kWrongEnd)) return;
  const State before = state;
  for (const StatementId line : m.definers_.get(entry()).lines) {
    state = before;
    set_entry(Definers::one(line));
    if (kind_of(line) != opener) {
      if (!documented(StopKind::kWrongEnd, at_line("no matching label: '" + line_text() + "' (found '" + std::string(spelling(kind_of(line))) + "' in line " + std::to_string(line_of(line)) + ")"), line)) continue;
    }
    end_loop_at(line);
  }
}

void Machine::Step::end_loop_at(StatementId opener) {
  if (!skipping) return go(std::move(state), opener);
  state.skip = kNoLabel;
  const uint8_t continuing = state.continuing;
  if ((continuing & kNo) != 0) {
    State after = state;
    after.continuing = kNo;
    go(std::move(after), here + 1);
  }
  if ((continuing & kStale) != 0) out.hazard(state, HazardKind::kStaleContinue, 0, StopKind::kNone, "");
  if ((continuing & (kYes | kStale)) != 0) {
    state.continuing = kNo;
    go(std::move(state), opener);
  }
}

/// `break`, `continue`.
void Machine::Step::jump() {
  if (!require_defined(StopKind::kNotALoop)) return;
  const State before = state;
  const bool is_break = s.keyword == Keyword::kBreak;
  for (const StatementId line : m.definers_.get(entry()).lines) {
    state = before;
    set_entry(Definers::one(line));
    const Keyword kind = kind_of(line);
    if (kind != Keyword::kWhile && kind != Keyword::kDo) {
      if (!documented(StopKind::kNotALoop, at_line("no matching while/do label: '" + line_text() + "' (found '" + std::string(spelling(kind)) + "' in line " + std::to_string(line_of(line)) + ")"), line)) continue;
    }
    if (is_break) {
      if (skipping && kind == Keyword::kDo && (state.continuing & (kYes | kStale)) != 0) {
        out.hazard(state, HazardKind::kContinueMeetsBreak, 0, StopKind::kNone, "");
      }
      // The `while` that closes a `do` clears the flag; `endwhile` leaves it behind.
      if (m.has_do_) state.breaking = kind == Keyword::kDo ? kYes : kStale;
    } else if (!skipping) {
      state.continuing = kind == Keyword::kDo ? kStale : kYes;
    }
    state.skip = label;
    go(state, here + 1);
  }
}

// --- if ---

void Machine::Step::if_(Truth truth) {
  const State before = state;
  const Definers::Set set = m.definers_.get(entry());
  const auto as = [&](uint32_t packed) {
    state = before;
    set_entry(packed);
    set_count(label, -1);  // the entry is made anew at every `if`
    if (truth != Truth::kFalse) {
      State in = state;
      in.executed = kYes;
      in.skip = kNoLabel;
      go(std::move(in), here + 1, 1);
    }
    if (truth != Truth::kTrue) {
      state.executed = kNo;
      state.skip = label;
      go(state, here + 1, 2);
    }
  };
  const bool own = set.undefined || std::ranges::find(set.lines, here) != set.lines.end();
  if (own) as(Definers::one(here));
  for (const StatementId line : set.lines) {
    if (line == here) continue;
    state = before;
    if (documented(StopKind::kDuplicateIf, at_line("duplicate O-word label - already defined in line " + std::to_string(line_of(line)) + ": '" + line_text() + "'"), line)) {
      as(Definers::one(line));
    }
  }
}

void Machine::Step::else_(Truth truth) {
  if (!require_defined(StopKind::kNotAnIf)) return;
  const State before = state;
  for (const StatementId line : m.definers_.get(entry()).lines) {
    state = before;
    set_entry(Definers::one(line));
    if (kind_of(line) != Keyword::kIf) {
      if (!documented(StopKind::kNotAnIf, at_line("no matching 'if' label: '" + line_text() + "' (found '" + std::string(spelling(kind_of(line))) + "' in line " + std::to_string(line_of(line)) + ")"), line)) continue;
    }
    const uint8_t executed = state.executed;
    if ((executed & kYes) != 0) {
      State past = state;
      past.executed = kYes;
      past.skip = label;
      go(std::move(past), here + 1);
    }
    if ((executed & kNo) == 0) continue;
    state.executed = kNo;
    if (s.keyword == Keyword::kElse) {
      if (skipping) {
        state.executed = kYes;
        state.skip = kNoLabel;
      }
      go(state, here + 1);
      continue;
    }
    if (truth != Truth::kTrue) go(state, here + 1, 2);
    if (truth != Truth::kFalse) {
      state.executed = kYes;
      state.skip = kNoLabel;
      go(state, here + 1, 1);
    }
  }
}

void Machine::Step::endif() {
  if (!require_defined(StopKind::kNotAnIf)) return;
  const State before = state;
  for (const StatementId line : m.definers_.get(entry()).lines) {
    state = before;
    set_entry(Definers::one(line));
    if (kind_of(line) != Keyword::kIf) {
      if (!documented(StopKind::kNotAnIf, at_line("no matching label: '" + std::string("#") + m.program_.name(m.label_of(label)) + "' (found '" + std::string(spelling(kind_of(line))) + "' in line " + std::to_string(line_of(line)) + "): '" + line_text() + "'"), line)) continue;
    }
    state.skip = kNoLabel;
    state.executed = kYes;
    go(state, here + 1);
  }
}

bool Machine::Step::require_defined(StopKind) {
  const Definers::Set set = m.definers_.get(entry());
  if (set.undefined) {
    const std::string message = at_line("undefined O-word label: '" + line_text() + "'");
    if (documented(StopKind::kLabelUndefined, message)) crash(StopKind::kLabelUndefined, message);
  }
  if (set.lines.empty()) return false;
  set_entry(m.definers_.without_undefined(entry()));
  return true;
}

/// Under FEATURE 0x20 the interpreter goes on with a label that it does not have, and crashes.
void Machine::Step::crash(StopKind kind, std::string message) {
  out.hazard(state, HazardKind::kCrash, 0, kind, std::move(message));
}

}  // namespace owlint::flow
