// One step of the O-word machine in progress: a line, and the state before it. Used only by the step_*.cc files,
// which have the transitions, keyword by keyword.
#pragma once

#include <algorithm>
#include <optional>

#include "analyzer/flow/interpreter/abstract_machine.h"

namespace owlint::flow {

enum class Truth : uint8_t { kFalse, kTrue, kOpen };  // open: both outcomes are followed

inline constexpr int kUnknownRepeats = -1;  // M98 with an L that is not known

struct AbstractMachine::Step {
  AbstractMachine& m;
  State state;
  const Context& context;
  Listener& out;
  const Statement& s;
  StatementId here;
  bool skipping;
  FullLabel label = kNoLabel;
  Range label_range;                      ///< of a computed label that is not known
  ExprId tested = kNoExpr;                ///< the condition of this line, if values do not decide it
  std::optional<ValueId> returned_value;  ///< the value on this `return` or `endsub`
  bool decided = false;                   ///< the condition has only one outcome here, so going on is not a branch
  ReadLog reads;

  Step(AbstractMachine& machine, State start, const Context& ctx, Listener& listener)
      : m(machine),
        state(std::move(start)),
        context(ctx),
        out(listener),
        s(m.program_.at(state.position)),
        here(state.position),
        skipping(state.skip != kNoLabel) {}

  const LineError* error() const { return m.program_.syntax.error(s); }
  bool defining() const { return state.defining != kNoName; }
  bool called() const { return context.depth > 0; }
  bool warn_only() const { return m.profile_.warn_only(); }

  // --- leaving the line ---

  /// `branch`: the outcome of the condition that this needs.
  void go(State next, StatementId position, Branch branch = Branch::kNone) {
    if (branch != Branch::kNone && (s.is(Keyword::kIf) || s.is(Keyword::kElseif) || s.is(Keyword::kWhile))) {
      if (tested != kNoExpr) m.remembered_.learn(next.parameters, tested, branch == Branch::kTrue);
      m.refinement_.refine(next.parameters, value(0), branch == Branch::kTrue);
      if (!m.modes_.learn(next.parameters, m.program_.syntax, value(0), branch == Branch::kTrue)) return;
    }
    next.position = position;
    next.branch = decided ? Branch::kNone : branch;
    const bool goes_on = position == here + 1 && next.skip == kNoLabel && next.defining == kNoName && !next.seek;
    if (goes_on && !context.contour) m.leave_modes(next, here);
    next.looped = position <= here && m.program_.at(position).is(Keyword::kRepeat);
    out.successor(std::move(next));
  }
  /// Numbers that the line sets may be the machine's positions and offsets.
  void write_offsets();
  void next_line() { go(std::move(state), here + 1); }

  void stop(StopKind kind, std::string message, StatementId other = kNoStatement, std::string detail = {}) {
    out.stop(state, {kind, other, std::move(message), std::move(detail), {}});
  }
  /// Stops on some of the runs that are followed here as one, or on some machines.
  void may_stop(StopKind kind, std::string message) {
    const bool mixed = state.mixed;
    state.mixed = true;
    stop(kind, std::move(message));
    state.mixed = mixed;
  }
  void hazard(HazardKind kind, StatementId other = kNoStatement) { out.hazard(state, HazardReport::of(kind, other)); }
  /// What is read before an error of the line may stop first. False if it stops every run.
  bool settle_before(const LineError& error) {
    for (ExprId id = error.read_from; id < error.read_to; ++id) {
      const Expr& expr = m.program_.syntax.exprs[id];
      if (expr.op == Operator::kNumber) continue;
      if (expr.target && expr.op == Operator::kNamed) {
        m.evaluator_.begin_name(expr.name(), state.parameters);
        continue;
      }
      const bool returned = s.is(Keyword::kEndsub) || s.is(Keyword::kReturn);  // read at a definition too
      const ExprId read = expr.target ? expr.left() : id;
      const Evaluation e = returned ? or_fresh(evaluate(read), read) : evaluate(read);
      if (!settle(e)) return false;
      int times = 0;
      if (s.kind == LineKind::kM98 && s.repeats && id == value(0) && !times_called(e, &times)) return false;
      long number = 0;
      if (expr.target && KnownValues::is_constant(e.value) &&
          !settle(m.evaluator_.target(m.values_.value(e.value), &number)))
        return false;
    }
    return true;
  }
  void stop_error() {
    const LineError& e = *error();
    if (!settle_before(e)) return;
    out.stop(state, {e.kind, kNoStatement, e.message, {}, {kNoWord, kNoWord, e.decided_by, false, nullptr}});
  }

  /// One of the eight documented errors: stops, or under FEATURE 0x20 prints a message. True if the run goes on.
  bool documented(StopKind kind, std::string message, StatementId other = kNoStatement) {
    if (!warn_only()) {
      stop(kind, std::move(message), other);
      return false;
    }
    out.hazard(state, HazardReport::of_error(HazardKind::kWarned, kind, std::move(message)));
    return true;
  }

  // --- evaluating ---

  /// False if evaluation stops the interpreter on every joined path.
  bool settle(const Evaluation& e, bool at_definition = false) {
    const StopKind kind = e.fails != StopKind::kNone ? e.fails : e.may_fail;
    if (kind != StopKind::kNone) {
      std::string message = e.message != nullptr ? e.message : "";
      std::string detail;
      if (e.name != kNoName) {
        detail = m.name(e.name);
        message = "Named parameter #<" + detail + "> not defined";
      }
      if (at_definition) out.hazard(state, HazardReport::of_error(HazardKind::kValueAtDefinition, kind, message));
      const bool on_some_paths = e.fails == StopKind::kNone;
      const bool mixed = state.mixed;
      // It is not known on which of the joined paths, nor whether one of them gets here.
      state.mixed = mixed || (kind == StopKind::kNameUndefined && (on_some_paths || state.joined));
      out.stop(state,
               {kind, kNoStatement, std::move(message), std::move(detail), {e.item, kNoWord, 0, false, nullptr}});
      state.mixed = mixed;
      if (on_some_paths && kind == StopKind::kNameUndefined) m.evaluator_.assume_there(e.name, state.parameters);
    }
    return e.fails == StopKind::kNone;
  }

  Evaluation evaluate(ExprId id, Unset unset = Unset::kAny) {
    const Reading how{unset, defining() ? Undefined::kPasses : Undefined::kStops, &reads};
    for (;;) {
      const Evaluation e = m.evaluator_.evaluate(id, state.parameters, how);
      if (e.may_fail != StopKind::kNameUndefined) return e;
      settle(e);  // and on the other paths the name is there
    }
  }

  /// A parameter that the program never set reads 0 in a freshly started interpreter: then it may fail.
  Evaluation or_fresh(Evaluation e, ExprId id) {
    if (e.fails != StopKind::kNone || e.may_fail != StopKind::kNone) return e;
    const Evaluation fresh = evaluate(id, Unset::kZero);
    e.may_fail = fresh.fails;
    e.message = fresh.message;
    return e;
  }

  void report_reads() {
    for (uint32_t n = 1; n <= 30; ++n) {
      if ((reads.not_passed >> n & 1) != 0)
        out.hazard(state, HazardReport::of_argument(HazardKind::kArgumentNotPassed, n));
    }
    reads.not_passed = 0;
    report_value_reads();
  }
  void report_value_reads() {
    if (reads.no_value == kUnassigned) return;
    // After paths were joined, the outcomes of `#<_value_returned>` are joined too.
    const bool guarded =
        reads.no_value == kMaybeNotReturned && m.program_.syntax.names.find("_value_returned") != kNoName;
    if (!guarded) hazard(reads.no_value == kCleared ? HazardKind::kValueCleared : HazardKind::kValueNotReturned);
    reads.no_value = kUnassigned;
  }

  ExprId value(uint32_t i) const { return m.program_.syntax.values_of(s)[i]; }

  /// The condition of `if`, `elseif`, `while`; false if it stops.
  bool condition(Truth* truth, double* number = nullptr) {
    if (s.value_count == 0) {
      stop_error();
      return false;
    }
    const Evaluation e = evaluate(value(0));
    reads.not_passed = 0;  // optional arguments are written like this: the sub tests an argument that was not passed
    report_value_reads();
    if (!settle(e)) return false;
    const bool constant = KnownValues::is_constant(e.value);
    const Range range = m.values_.range(e.value);
    const bool known = constant || !range.has(0);
    *truth = !known ? Truth::kOpen : range.has(0) ? Truth::kFalse : Truth::kTrue;
    if (!known && !s.is(Keyword::kRepeat)) {
      tested = value(0);
      const Outcome before = m.remembered_.known(state.parameters, tested);
      if (before != Outcome::kNotKnown) *truth = before == Outcome::kTrue ? Truth::kTrue : Truth::kFalse;
    }
    decided = *truth != Truth::kOpen;
    if (number != nullptr && constant) *number = m.values_.value(e.value);
    return true;
  }

  // --- the table ---

  /// Follows the members of a set one by one: in a joined state some of them may not fit the rest of the state.
  /// `own`: this line, which counts the same as "undefined".
  void take_apart(const Definers::Set& set, StatementId own = kNoStatement) {
    if (!state.joined) return;
    size_t outcomes = set.undefined ? 1 : 0;
    for (const StatementId line : set.lines) outcomes += line == own && set.undefined ? 0 : 1;
    if (outcomes > 1) state.mixed = true;
  }

  /// Structured blocks count as entered from their first line on, without an entry in the table.
  bool structured() const {
    const BlockId block = m.program_.block_of[here];
    return block != kNoBlock && m.structure_.structured[block] &&
        m.structure_.structured_for(m.program_, m.program_.blocks[block].region, called() ? context.sub : kNoName);
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
    std::string_view text = m.linked_.source_of(here).slice(s.whole());
    text = text.substr(0, text.find('\0'));  // a line ends there for the interpreter
    return std::string(text.substr(0, text.find_last_not_of(" \t\r\v\f") + 1));
  }
  /// `N: `, the beginning of the interpreter's messages about labels.
  std::string at_line(const std::string& rest) const { return std::to_string(s.line) + ": " + rest; }

  // --- keywords ---

  void run();
  void plain();
  void m98();
  void modes();
  void remap();
  bool has_words(const RemappedCode& code);
  void pass_words(const RemappedCode& code, Parameters& to, std::vector<ValueId>* positional);
  ValueId value_of(const ModeWord& word) const;
  void enter_remap(const RemappedCode& code);
  void run_python();
  void come_back_from(const Statement& remap);
  std::optional<ContourSub> contour_sub() const;
  bool contour_line(std::string_view text, std::pair<StatementId, StatementId> statements, Parameters& inside,
                    ContourSub* sub) const;
  StatementId contour_opener(NameId sub) const;
  bool refuses_words(const Statement& asks);
  bool is_mistake(StopKind kind, std::string_view message) const;
  bool read_words(const Statement& asks, WordLine& words, bool computes = true);
  Evaluation line_computes() const;
  bool computes_later() const;
  bool take_faults(std::span<const ModeFault> faults);
  bool restore_modes();
  bool can_lose_end() const;
  void pass_over_end();
  void user_code();
  UserCode known_of(uint32_t user_code) const;
  const Statement* user_code_behind() const;
  void machine_check();
  void repeated_word(const LineError& repeated);
  bool may_end(const Statement& line) const;
  static bool passes_in_contour(const LineError& error);
  static bool is_carried_out(const LineError& error);
  void call_elsewhere(FullLabel sub);
  void find_sub(State enter, Context callee, int repeats);
  bool times_called(const Evaluation& of_l, int* times);
  void m99();
  void o_word();
  bool resolve_label();
  bool call_any();
  bool arguments(std::vector<ValueId>* values);
  void act(Truth truth, double number);
  bool enter_sub();
  bool is_called_sub() const;
  bool own_file_has(NameId sub) const;
  void tell_file_before_own(NameId sub, CallTarget target);
  void sub();
  void bare();
  void leave_sub();
  void come_back();
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

}  // namespace owlint::flow
