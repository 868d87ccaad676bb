// A line of words in the modes that are in effect: what it stops with, and what it leaves in effect.
#include "analyzer/flow/interpreter/step.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/syntax/questions.h"
#include "analyzer/syntax/remaps.h"

namespace owlint::flow {

/// A code that the table does not have is a mistake in a program; in a file that a machine calls it may be that machine's own.
bool AbstractMachine::Step::is_mistake(StopKind kind, std::string_view message) const {
  const bool of_program = m.linked_.file_of(here) == 0 && !m.program_.sub_file;
  return kind == StopKind::kCodeUnknown && of_program && message.starts_with("Unknown");
}

/// The words with the values that they have here; false if reading them stops. Unless `computes`, these are not known any more.
bool AbstractMachine::Step::read_words(const Statement& asks, WordLine& words, bool computes) {
  if (asks_about_call(m.program_.syntax, static_cast<StatementId>(&asks - m.program_.syntax.statements.data())))
    words.begin_call();
  bool computed_code = false;
  for (const ModeWord& word : m.program_.syntax.words_of(asks)) {
    Word read{word.letter, word.known, word.value, word.from, word.to};
    if (word.computed != kNoExpr && computes) {
      const Evaluation e = m.evaluator_.evaluate(word.computed, state.parameters);
      const Range range = m.values_.range(e.value);
      read.known = KnownValues::is_constant(e.value);
      if (read.known) read.value = range.low;
      // Of a feed and a speed it only matters that they are not 0.
      if (!read.known && (word.letter == 'f' || word.letter == 's') && range.low >= 0 && !range.has(0)) {
        read.known = true;
        read.value = 1;
      }
    }
    const std::optional<Fault> of_letter = words.letter(word.letter);
    const std::optional<Fault> fault = words.add(read);
    // Of words that are not computed the line itself has said it, unless it is about a code that is.
    const bool said = word.computed == kNoExpr && !computed_code;
    computed_code = computed_code || (word.computed != kNoExpr && (word.letter == 'g' || word.letter == 'm'));
    if (said || !computes || !fault || of_letter) continue;
    ModeFault found{*fault, true, 0};
    found.fault.certain = fault->certain || is_mistake(fault->kind, fault->message);
    if (found.fault.certain) return take_faults({&found, 1});
  }
  return true;
}

/// What the values of this line, which are behind the question, stop with, if they do.
Evaluation AbstractMachine::Step::line_computes() const {
  const StatementId next = here + 1;
  if (next >= m.program_.size()) return {};
  const Statement& line = m.program_.at(next);
  if (!on_one_line(line, s) || !line.has_items()) return {};
  Parameters after = state.parameters;
  return m.evaluator_.assign(line, after, nullptr);
}

/// Whether values of this line are worked out behind the question.
bool AbstractMachine::Step::computes_later() const {
  for (StatementId id = here + 1; id < m.program_.size() && on_one_line(m.program_.at(id), s); ++id) {
    if (m.program_.at(id).item_count > 0) return true;
  }
  return false;
}

/// Reports what the words stop with. False if no run goes on.
bool AbstractMachine::Step::take_faults(std::span<const ModeFault> faults) {
  if (faults.empty()) return true;
  // A number that its word may not have is what the values of the line stop with; this finding knows the word.
  const Evaluation before = line_computes();
  if (before.fails != StopKind::kNone && before.fails != StopKind::kNumberOutOfRange) return true;
  for (const ModeFault& found : faults) {
    const Fault& fault = found.fault;
    if (!fault.certain && !found.believed) continue;
    if (const Statement* code = found.behind_user_code ? user_code_behind() : nullptr) {
      const UserCode known = known_of(code->first);
      if (known == UserCode::kMissing) return true;  // its own question stops every run
      if (known == UserCode::kUnknown && fault.certain) {
        state.position = here + 1;
        may_stop(StopKind::kUserCodeMissing, "Unknown m code used: M" + std::to_string(code->first));
        state.position = here;
      }
    }
    const bool mixed = state.mixed;
    state.mixed = mixed || !fault.certain || found.from_start;
    const auto arc = found.arc ? std::make_shared<const ArcNumbers>(*found.arc) : nullptr;
    out.stop(state,
             {fault.kind,
              kNoStatement,
              fault.message,
              {},
              {fault.word, fault.other, found.decided_by, found.from_start, arc}});
    state.mixed = mixed;
    if (!fault.certain) continue;
    if (before.may_fail != StopKind::kNone) {
      // Some of the joined runs have stopped before, for a value of the line.
      state.position = here + 1;
      settle(before);
    }
    return false;
  }
  return true;
}

void AbstractMachine::Step::write_offsets() {
  for (const Item& item : m.program_.syntax.items_of(s)) {
    if (item.target == kNoExpr) continue;
    double number = 0;
    const bool known = literal_value(m.program_.syntax.exprs, item.target, &number);
    if (known && !is_place_parameter(number)) continue;
    Place place = m.modes_.place(state.parameters);
    const ValueId value = m.evaluator_.evaluate(item.value, state.parameters).value;
    if (!known) {
      place.lose_parameters();
    } else {
      place.write_parameter(
          static_cast<int32_t>(number + 0.5),
          KnownValues::is_constant(value) ? Coordinate::of(m.values_.value(value)) : Coordinate::unknown());
    }
    m.modes_.set_place(state.parameters, place);
  }
}

/// A line of words. Of one with M98 this is asked when its values are known: see refuses_words(). Of one with remapped codes it
/// is asked for each part.
void AbstractMachine::Step::modes() {
  if (context.contour || asks_about_call(m.program_.syntax, here)) return next_line();
  const bool goes = m.mode_uses_.follows_place(here);
  if (s.for_place && !goes) return next_line();
  const RemapsAround around = remaps_around(m.program_.syntax, here);
  if (around.before != nullptr) come_back_from(*around.before);
  const MachineWords& machine = m.remapped_codes_.words_within(context.built_in);
  WordLine words(machine);
  if (!read_words(s, words, around.before == nullptr)) return;
  const ModeRun run(machine, words);
  ModeState after = m.modes_.state(state.parameters);
  std::vector<ModeFault> faults;
  if (around.before == nullptr) {
    run.check(&after, &faults);
    // Of a line whose modes are known these are none of its faults.
    if (s.for_place) faults.clear();
    if (!take_faults(faults)) return;
    // Then the line sets its parameters: a name that it may not set comes first.
    if (line_computes().read_only != kNoName) return next_line();
    faults.clear();
  }
  const std::optional<bool> loses_end = can_lose_end() ? run.loses_rest(after) : false;
  std::optional<Place> place;
  MoveWatch watch;
  if (goes) {
    place = m.modes_.place(state.parameters);
    watch = {m.place_watch_, s.line};
    if (watch.visitor != nullptr) m.place_watch_->begin(state, here);
  }
  if (goes && m.program_.syntax.reads_place && computes_later()) m.modes_.begin_line(state.parameters);
  Place* const at = place ? &*place : nullptr;
  if (around.before != nullptr || around.next != nullptr) {
    const auto code_of = [&](const Statement* remap) {
      return remap == nullptr ? nullptr : m.remapped_codes_.code_at(m.program_.syntax, *remap, 0);
    };
    LinePart part{code_of(around.before), code_of(around.next)};
    if (around.before == nullptr) {
      m.modes_.keep_motion(state.parameters, after);
    } else {
      const ModeValues motion = m.modes_.kept_motion(state.parameters);
      part.motion = motion.may;
      part.motion_open = motion.open;
    }
    run.act_part(part, &after, &faults, at, watch);
    if (around.next == nullptr) m.modes_.drop_motion(state.parameters);
  } else {
    if (words.has_remapped_code()) Evaluator::call_outside(state.parameters);
    const std::optional<ContourSub> contour = contour_sub();
    run.act(&after, &faults, at, watch, contour ? &*contour : nullptr);
  }
  if (s.for_place) std::erase_if(faults, [](const ModeFault& fault) { return !fault.by_place; });
  if (!take_faults(faults)) return;
  if (!s.for_place) m.modes_.set(state.parameters, after);
  if (place) m.modes_.set_place(state.parameters, *place);
  if (!loses_end) state.mixed = true;
  if (loses_end.value_or(true)) pass_over_end();
  if (!loses_end.value_or(false)) next_line();
}

/// Whether the program ends on the line of this question.
bool AbstractMachine::Step::can_lose_end() const {
  const StatementId next = here + 1;
  if (context.contour || next >= m.program_.size()) return false;
  const Statement& line = m.program_.at(next);
  return on_one_line(line, s) && ends_program(line) && line.item_count == 0;
}

/// What M72 has restored makes it lose the end of the program.
void AbstractMachine::Step::pass_over_end() {
  State next = state;
  next.position = here + 2;
  next.branch = Branch::kNone;
  next.looped = false;
  if (next.defining == kNoName && !next.seek) m.leave_modes(next, here + 1);
  out.successor(std::move(next));
}

/// Whether the words of a line that calls stop every run. Nothing of them is carried out.
bool AbstractMachine::Step::refuses_words(const Statement& asks) {
  if (context.contour) return false;
  const MachineWords& machine = m.remapped_codes_.words_within(context.built_in);
  WordLine words(machine);
  if (!read_words(asks, words)) return true;
  ModeState after = m.modes_.state(state.parameters);
  std::vector<ModeFault> faults;
  ModeRun(machine, words).check(&after, &faults);
  return !take_faults(faults);
}

/// A call ends: what M73 has saved in it is restored. False if no run comes back.
bool AbstractMachine::Step::restore_modes() {
  if (!m.modes_.restores(state.parameters)) return true;
  ModeState modes = m.modes_.state(state.parameters);
  std::vector<ModeFault> faults;
  std::optional<Place> place;
  if (m.mode_uses_.follows_place()) place = m.modes_.place(state.parameters);
  owlint::restore_modes(m.machine_words_.words, &modes, &faults, place ? &*place : nullptr);
  if (!take_faults(faults)) return false;
  if (place) m.modes_.set_place(state.parameters, *place);
  m.modes_.set(state.parameters, modes);
  return true;
}

}  // namespace owlint::flow
