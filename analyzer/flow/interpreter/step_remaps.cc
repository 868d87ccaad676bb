// Codes that the machine's INI remaps: the words that their subs get, the call, and what Python leaves behind.
#include <charconv>

#include <fmt/format.h>

#include "analyzer/flow/interpreter/step.h"

namespace owlint::flow {
namespace {

constexpr int kMaxRemapDepth = 9;

/// As the words of `@` are passed: with four decimals (measured).
double with_four_decimals(double value) {
  const std::string text = fmt::format("{:.4f}", value);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

}  // namespace

/// Python runs, of which nothing is known.
void AbstractMachine::Step::run_python() {
  Evaluator::call_outside(state.parameters);
  m.modes_.set(state.parameters, ModeState::unknown());
  if (m.mode_uses_.follows_place()) m.modes_.set_place(state.parameters, Place::unknown());
}

/// Before the rest of a line: what Python leaves behind the sub of its code.
void AbstractMachine::Step::come_back_from(const Statement& remap) {
  const RemappedCode* const code = m.remapped_codes_.code_at(m.program_.syntax, remap, context.built_in);
  if (code != nullptr && code->python_behind) run_python();
}

/// A value of the line as it was when the line was read.
ValueId AbstractMachine::Step::value_of(const ModeWord& word) const {
  if (word.known) return m.values_.intern(word.value);
  const Syntax& syntax = m.program_.syntax;
  for (StatementId id = here; id-- > 0 && syntax.statements[id].line == s.line;) {
    const Statement& before = syntax.statements[id];
    // Parameters that the line sets, or another sub of it, may be among those that it was computed from.
    if (before.kind == LineKind::kRemap || before.kind == LineKind::kFileEnd) return kUnknown;
    for (const Item& item : syntax.items_of(before)) {
      if (item.letter == 0) return kUnknown;
    }
  }
  if (word.computed == kNoExpr) return kUnknown;
  const ValueId value = m.evaluator_.evaluate(word.computed, state.parameters).value;
  return value < kFirstConstant ? kUnknown : value;
}

/// Whether the line has what the sub asks for, on some run.
bool AbstractMachine::Step::has_words(const RemappedCode& code) {
  std::string missing;
  const auto words = m.program_.syntax.words_of(s);
  for (const char letter : code.argspec) {
    const char small = static_cast<char>(letter - 'A' + 'a');
    // Measured: these three are not words that a line can lack.
    const bool no_word = letter == 'G' || letter == 'M' || letter == 'N';
    if (!is_capital(letter) || no_word || std::ranges::find(words, small, &ModeWord::letter) != words.end()) continue;
    missing += (missing.empty() ? " missing: " : ",") + std::string(1, letter);
  }
  const ModeState modes = m.modes_.state(state.parameters);
  // `maybe`: on some runs it is there.
  const auto wants = [&](char sign, Mode mode, ValueSet none, std::string_view what, bool* maybe) {
    if (code.argspec.find(sign) == std::string_view::npos) return std::string();
    *maybe = (modes.now[mode] & ~none) != 0;
    const bool lacks = (modes.now[mode] & none) != 0 && !(*maybe && modes.now.is_open(mode));
    return lacks ? std::string(what) : std::string();
  };
  bool fed = false, turned = false;
  const std::string feed = wants('>', Mode::kFeed, value_bit(modes::kNoFeed), "F>0,", &fed);
  const std::string speed = wants('^', Mode::kSpeed, value_bit(modes::kNoSpeed), "S>0,", &turned);
  if (missing.empty() && feed.empty() && speed.empty()) return true;
  const std::string message = fmt::format("user-defined {}:{}{}{}", code.name, missing, feed, speed);
  const bool certain = !missing.empty() || (!feed.empty() && !fed) || (!speed.empty() && !turned);
  if (certain) {
    stop(StopKind::kRemapWords, message);
    return false;
  }
  may_stop(StopKind::kRemapWords, message);
  return true;
}

/// The words as names of the sub, or in the order of `@`.
void AbstractMachine::Step::pass_words(const RemappedCode& code, Parameters& to, std::vector<ValueId>* positional) {
  const bool by_place = code.argspec.find('@') != std::string_view::npos;
  const Names& names = m.program_.syntax.names;
  const auto words = m.program_.syntax.words_of(s);
  const auto pass = [&](char letter, ValueId value) {
    if (by_place) {
      positional->push_back(value);
    } else if (const NameId name = names.find(std::string(1, letter)); name != kNoName) {
      m.evaluator_.set_name(to, name, value);
    }
  };
  if (by_place && code.argspec.find_first_of(">^nN") != std::string_view::npos) return;
  std::string passed;
  for (const char letter : code.argspec) {
    const char small = is_capital(letter) ? static_cast<char>(letter - 'A' + 'a') : letter;
    if (small == '@' || small == 'g' || small == 'm' || passed.find(small) != std::string::npos) continue;
    passed += small;
    if (small == '>') pass('f', kUnknown);
    if (small == '^') pass('s', kUnknown);
    if (small == 'n') pass('n', kUnknown);
    if (small == '>' || small == '^' || small == 'n') continue;
    const auto word = std::ranges::find(words, small, &ModeWord::letter);
    if (word == words.end()) continue;
    ValueId value = value_of(*word);
    if (by_place && KnownValues::is_constant(value))
      value = m.values_.intern(with_four_decimals(m.values_.value(value)));
    pass(small, value);
  }
}

void AbstractMachine::Step::enter_remap(const RemappedCode& code) {
  label = m.full_label(kGlobalScope, s.label);
  const int depth = m.structure_.shallow_calls ? 1 : context.depth + 1;
  Context callee{s.label,
                 depth,
                 false,
                 30,
                 static_cast<uint8_t>(context.remaps + 1),
                 static_cast<uint16_t>(context.built_in | m.remapped_codes_.own_bit(code)),
                 false,
                 true};
  State enter = state;
  enter.looped = false;
  enter.branch = Branch::kNone;
  enter.parameters.local_outcomes = {};
  enter.parameters.locals = {};
  // Measured: 0 unless `@` passes them. Where `>`, `^` and `n` are among them has not been measured.
  const bool by_place = code.argspec.find('@') != std::string::npos;
  const bool any = by_place && code.argspec.find_first_of(">^nN") != std::string::npos;
  const ValueId not_passed = any ? kUnknown : m.values_.intern(0.0);
  for (long n = 1; n <= 30; ++n) m.evaluator_.set_number(enter.parameters, n, not_passed);
  std::vector<ValueId> positional;
  pass_words(code, enter.parameters, &positional);
  long n = 0;
  for (const ValueId value : positional) m.evaluator_.set_number(enter.parameters, ++n, value);
  if (code.python_before) m.evaluator_.expect_from_prolog(enter.parameters);
  m.modes_.begin_level(enter.parameters);
  find_sub(std::move(enter), callee, 1);
}

/// A remapped code: measured, its words are looked at first, then how deep it is, then the sub is called.
void AbstractMachine::Step::remap() {
  if (context.contour) return next_line();
  const RemappedCode* const code = m.remapped_codes_.code_at(m.program_.syntax, s, context.built_in);
  if (code == nullptr) return next_line();  // the question behind it carries the code out
  if (!has_words(*code)) return;
  if (code->sub.empty() || code->python_before) run_python();
  if (code->sub.empty()) return next_line();
  if (context.remaps >= kMaxRemapDepth)
    return stop(StopKind::kRemapTooDeep, "maximum nesting of remapped blocks exceeded");
  enter_remap(*code);
}

}  // namespace owlint::flow
