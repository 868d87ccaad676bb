#include "analyzer/syntax/modes_in_effect.h"

#include <algorithm>
#include <bit>

namespace owlint {
namespace {

Mode mode_at(size_t index) { return static_cast<Mode>(index); }

/// The only value of a mode, or kAny.
uint8_t value_of(const ModeSets& sets, Mode mode) {
  return std::has_single_bit(sets[mode]) ? static_cast<uint8_t>(std::countr_zero(sets[mode])) : ModeChange::kAny;
}

/// Whether a line probes or reads an input.
bool asks_inputs(const WordLine& words) {
  const GCode* const motion = words.code(GGroup::kMotion);
  const MCode* const input = words.code(MGroup::kInputsOutputs);
  return (motion != nullptr && motion->tenths >= code::kG38_2 && motion->tenths <= code::kG38_5) ||
      (input != nullptr && input->number == code::kM66);
}

bool stacks_modes(const WordLine& words) {
  const MCode* const code = words.code(MGroup::kSpindle);
  return code != nullptr && code->number >= code::kM70 && code->number <= code::kM73;
}

}  // namespace

std::span<const ModeChange> Syntax::changes_after(StatementId id) const {
  const auto first = std::ranges::lower_bound(mode_changes, id, {}, &ModeChange::after);
  const auto last = std::ranges::upper_bound(mode_changes, id, {}, &ModeChange::after);
  return {first, last};
}

std::span<const ModeNeed> Syntax::needs_after(StatementId id) const {
  const auto first = std::ranges::lower_bound(mode_needs, id, {}, &ModeNeed::after);
  const auto last = std::ranges::upper_bound(mode_needs, id, {}, &ModeNeed::after);
  return {first, last};
}

Statement question_about(const Statement& line, LineKind kind, uint32_t first) {
  Statement asks;
  asks.offset = line.offset;
  asks.length = line.length;
  asks.line = line.line;
  asks.kind = kind;
  asks.block_delete = line.block_delete;
  asks.first = first;
  return asks;
}

void ModesInEffect::note(Mode mode, uint8_t value, uint32_t line) {
  pending_[static_cast<size_t>(mode)] = {0, line, mode, value};
  changed_ |= mask_of(mode);
  settled_ |= mask_of(mode);
  note_set(mode, value, line);
}

/// Remembers what a mode is set to, until a line depends on it: if it is set again before, the first time was for nothing.
void ModesInEffect::note_set(Mode mode, uint8_t value, uint32_t line) {
  ModeChange& before = last_set_[static_cast<size_t>(mode)];
  const bool known = before.value != ModeChange::kAny && value != ModeChange::kAny;
  if ((unused_ & mask_of(mode)) != 0 && known && before.value != value && before.line != line)
    out_.unused_changes.push_back({before, line, value});
  const auto last = static_cast<StatementId>(out_.statements.empty() ? 0 : out_.statements.size() - 1);
  before = {last, line, mode, value};
  unused_ |= mask_of(mode);
}

void ModesInEffect::set(Mode mode, uint8_t value, uint32_t line) {
  ModeSets& now = state_.now;
  if (now[mode] == value_bit(value)) return;
  now[mode] = value_bit(value);
  now.open &= ~mask_of(mode);
  note(mode, value, line);
}

/// The first line since the last O-word that depends on a mode, if none before it has set the mode.
void ModesInEffect::need(Mode mode, uint32_t line) {
  unused_ &= ~mask_of(mode);
  if ((settled_ & mask_of(mode)) != 0) return;
  settled_ |= mask_of(mode);
  const bool first = out_.statements.empty();
  const auto last = static_cast<StatementId>(first ? 0 : out_.statements.size() - 1);
  (first ? out_.first_needs : out_.mode_needs).push_back({last, line, mode});
  if (!first) out_.statements.back().needs_modes = true;
}

/// What a line means depends on some modes, whether it stops or not.
void ModesInEffect::need_of(const WordLine& words, uint32_t line) {
  const MotionSet motions = words.depends_on_motion() ? state_.now[Mode::kMotion] : all_modes();
  const Motion motion = words.motion(static_cast<Motion>(std::countr_zero(motions)));
  if (motion == Motion::kNone || motion == Motion::kG80 || !words.has_axis_words()) return;
  need(Mode::kUnits, line);
  if (words.code(GGroup::kNonModal) == nullptr) {
    need(Mode::kDistance, line);
    need(Mode::kSystem, line);
  }
  if (motion == Motion::kG2 || motion == Motion::kG3) need(Mode::kPlane, line);
  if (motion != Motion::kG0) need(Mode::kFeedMode, line);
}

void ModesInEffect::pass(const PlainEffect& effect, uint32_t before, uint32_t last) {
  if (effect.moves) {
    for (const Mode mode : {Mode::kUnits, Mode::kDistance, Mode::kSystem}) need(mode, before + effect.first_move);
    if (effect.feeds) need(Mode::kFeedMode, before + effect.first_move);
    if (effect.first_arc != 0) need(Mode::kPlane, before + effect.first_arc);
  }
  if (effect.motion != Motion::kNone) set(Mode::kMotion, static_cast<uint8_t>(effect.motion), last);
  if (effect.feed) set(Mode::kFeed, modes::kFeedSet, last);
  if (effect.speed) set(Mode::kSpeed, modes::kSpeedSet, last);
  if (effect.straight) set(Mode::kStraightOwed, modes::kNotOwed, last);
  if (effect.moves) moved(last);
}

/// Whether a compensated path has begun depends on how far the lines move.
void ModesInEffect::moved(uint32_t line) {
  ModeSets& now = state_.now;
  if (now[Mode::kCompensation] == value_bit(modes::kG40) || now[Mode::kEntry] == value_bit(modes::kMade)) return;
  now[Mode::kEntry] = all_values(Mode::kEntry);
  now.open |= mask_of(Mode::kEntry);
  note(Mode::kEntry, ModeChange::kAny, line);
}

/// Writes down what the lines since the last statement have set.
void ModesInEffect::flush() {
  if (changed_ == 0) return;
  const bool first = out_.statements.empty();
  // What a line with block delete does itself is kept apart from what comes after it.
  if (!first && out_.statements.back().block_delete) {
    const Statement deleted = out_.statements.back();
    Statement after;
    after.offset = deleted.end();
    after.line = deleted.line;
    out_.statements.push_back(after);
  }
  for (; changed_ != 0; changed_ &= changed_ - 1) {
    ModeChange change = pending_[static_cast<size_t>(std::countr_zero(changed_))];
    change.after = first ? kNoStatement : static_cast<StatementId>(out_.statements.size() - 1);
    (first ? out_.first_changes : out_.mode_changes).push_back(change);
  }
  if (!first) out_.statements.back().changes_modes = true;
}

/// Whether the flow has to carry out the line: what it stops with or does depends on what is not known here.
bool ModesInEffect::asks(const WordLine& words, const ModeState& after) const {
  if (!faults_.empty() || stacks_modes(words) || words.has_unknown_code() || words.has_remapped_code()) return true;
  for (size_t i = 0; i < words.size(); ++i) {
    if (!words[i].known && (letter_set({&words[i].letter, 1}) & kPlaceLetters) == 0) return true;
  }
  for (size_t i = 0; i < kModes; ++i) {
    const Mode mode = mode_at(i);
    const bool changes = after.now[mode] != state_.now[mode] || (after.now.assigned & mask_of(mode)) != 0;
    if (changes && after.now.is_open(mode)) return true;
  }
  return false;
}

/// Takes over what a line without a question does.
void ModesInEffect::take(const ModeState& after, uint32_t line) {
  for (size_t i = 0; i < kModes; ++i) {
    const Mode mode = mode_at(i);
    if (after.now[mode] != state_.now[mode] || after.now.is_open(mode) != state_.now.is_open(mode))
      note(mode, value_of(after.now, mode), line);
    else if ((after.now.assigned & mask_of(mode)) != 0)
      note_set(mode, value_of(after.now, mode), line);
  }
  state_ = after;
  state_.now.assigned = 0;
}

bool ModesInEffect::judge(Statement& statement, bool keep) {
  faults_.clear();
  asks_ = false;
  const WordLine* words = parser_.words();
  if (words == nullptr || statement.has_error()) {
    if (const WordLine* of_call = parser_.words_of_call(); of_call != nullptr && !statement.has_error()) {
      ModeState after = state_;
      ModeRun(machine_, *of_call).check(&after, &faults_);
      asks_ = !faults_.empty();
    }
    // At O-words runs come from elsewhere, or go elsewhere and come back; behind a line that stops there is none.
    const bool stops = statement.kind == LineKind::kWords && statement.has_error();
    if (keep && !stops) {
      flush();
      state_ = ModeState::unknown();
      settled_ = unused_ = 0;
    }
    return keep;
  }
  if (asks_inputs(*words)) out_.input_lines.push_back(statement.line);
  ModeState after = state_;
  ModeRun(machine_, *words).run(&after, &faults_);
  if (faults_.size() == 1 && faults_.front().fault.certain) {
    statement.error = parser_.add_error(faults_.front().fault);
    return true;
  }
  asks_ = asks(*words, after);
  // With block delete on the line does nothing.
  if (statement.block_delete && (asks_ || after != state_)) {
    asks_ = true;
    after = ModeState::unknown();
  }
  if (!asks_) {
    take(after, statement.line);
    need_of(*words, statement.line);
    if (words->has_axis_words()) moved(statement.line);
    return keep;
  }
  flush();
  settled_ |= after.now.assigned;
  for (ModeMask set = after.now.assigned; set != 0; set &= set - 1) {
    const Mode mode = mode_at(static_cast<size_t>(std::countr_zero(set)));
    note_set(mode, after.now.is_open(mode) ? ModeChange::kAny : value_of(after.now, mode), statement.line);
  }
  need_of(*words, statement.line);
  state_ = after;
  state_.now.assigned = 0;
  return true;
}

void ModesInEffect::ask(const Statement& statement) {
  const WordLine& words = parser_.words() != nullptr ? *parser_.words() : *parser_.words_of_call();
  Statement asks = question_about(statement, LineKind::kModeLine, static_cast<uint32_t>(out_.mode_words.size()));
  asks.item_count = static_cast<uint8_t>(words.size());
  // Words that are computed have an item each, in the order of the line.
  const auto items = out_.items_of(statement);
  auto item = items.begin();
  for (size_t i = 0; i < words.size(); ++i) {
    const Word& word = words[i];
    ModeWord out{word.value, kNoExpr, word.letter, word.from, word.to, word.known};
    if (!word.known) {
      item = std::find_if(item, items.end(), [&](const Item& it) { return it.letter != 0; });
      if (item != items.end()) out.computed = (item++)->value;
    }
    out_.mode_words.push_back(out);
  }
  out_.statements.push_back(asks);
}

void ModesInEffect::push(const Statement& statement) {
  flush();
  if (asks_ && statement.kind != LineKind::kAbort) ask(statement);
  const bool own = statement.kind != LineKind::kWords || statement.item_count > 0 || statement.has_error();
  if (own || !asks_) out_.statements.push_back(statement);
}

}  // namespace owlint
