#include "analyzer/syntax/modes_in_effect.h"

#include <algorithm>
#include <bit>

#include "analyzer/syntax/mode_line.h"
#include "analyzer/syntax/remaps.h"

namespace owlint {
namespace {

Mode mode_at(size_t index) { return static_cast<Mode>(index); }

/// The only value of a mode, or kAny.
uint8_t value_of(const ModeSets& sets, Mode mode) {
  return is_single(sets[mode]) ? static_cast<uint8_t>(std::countr_zero(sets[mode])) : ModeChange::kAny;
}

/// Whether a line probes or reads an input.
bool asks_inputs(const WordLine& words) {
  const GCode* const motion = words.code(GGroup::kMotion);
  const MCode* const input = words.code(MGroup::kInputsOutputs);
  if (input != nullptr && input->number == code::kM66) return true;
  return motion != nullptr && motion->tenths >= code::kG38_2 && motion->tenths <= code::kG38_5;
}

/// G10 L1, L10 and L11, or one of which that is not known.
bool writes_tools(const WordLine& words) {
  const GCode* const code = words.code(GGroup::kNonModal);
  if (code == nullptr || code->tenths != code::kG10) return false;
  const uint8_t l = words.find('l');
  if (l == kNoWord || !words[l].known) return true;
  const double what = words[l].value;
  return what == 1 || what == 10 || what == 11;
}

bool may_set_g91(const WordLine& words) {
  const GCode* const distance = words.code(GGroup::kDistance);
  if (distance != nullptr && distance->tenths != code::kG90) return true;
  return words.has_unknown_code() || words.has_remapped_code();
}

/// See moved().
constexpr ModeMask of_moves(bool alone) {
  return mask_of(Mode::kEntry) |
      (alone ? mask_of(Mode::kStraightOwed) | mask_of(Mode::kNurbs) | mask_of(Mode::kNurbsOrder) : 0);
}

/// A feed and a speed that are not 0 refuse nothing.
ModeMask better(const ModeSets& sets) {
  ModeMask mask = 0;
  if (sets[Mode::kFeed] == value_bit(modes::kFeedSet)) mask |= mask_of(Mode::kFeed);
  if (sets[Mode::kSpeed] == value_bit(modes::kSpeedSet)) mask |= mask_of(Mode::kSpeed);
  return mask;
}

/// Whether a mode that is taken for granted may not be so any more.
bool leaves_usual(const ModeSets& usual, const ModeSets& after) {
  for (ModeMask set = after.assigned & ~usual.open; set != 0; set &= set - 1) {
    const Mode mode = mode_at(static_cast<size_t>(std::countr_zero(set)));
    if (after[mode] != usual[mode] || after.is_open(mode)) return true;
  }
  return false;
}

bool stacks_modes(const WordLine& words) {
  const MCode* const code = words.code(MGroup::kSpindle);
  return code != nullptr && code->number >= code::kM70 && code->number <= code::kM73;
}

}  // namespace

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

double ModesInEffect::number_of(Mode mode) {
  const double* const number = state_.now.number(mode);
  return number == nullptr ? ModeSets::kAnyNumber : *number;
}

void ModesInEffect::note(Mode mode, uint8_t value, uint32_t line) {
  pending_[static_cast<size_t>(mode)] = {0, line, mode, value, number_of(mode), false};
  changed_ |= mask_of(mode);
  settled_ |= mask_of(mode);
  note_set(mode, value, line);
}

/// Remembers what a mode is set to, until a line depends on it: if it is set again before, the first time was for nothing.
void ModesInEffect::note_set(Mode mode, uint8_t value, uint32_t line) {
  // Of other modes nobody asks (OW855), and they are set often: the motion on each line.
  constexpr ModeMask kAsked = mask_of(Mode::kUnits) | mask_of(Mode::kDistance) | mask_of(Mode::kPlane);
  if ((kAsked & mask_of(mode)) == 0) return;
  ModeChange& before = last_set_[static_cast<size_t>(mode)];
  const bool known = before.value != ModeChange::kAny && value != ModeChange::kAny;
  if ((unused_ & mask_of(mode)) != 0 && known && before.value != value && before.line != line)
    out_.unused_changes.push_back({before, line, value});
  const auto last = static_cast<StatementId>(out_.statements.empty() ? 0 : out_.statements.size() - 1);
  before = {last, line, mode, value, ModeSets::kAnyNumber, false};
  unused_ |= mask_of(mode);
}

void ModesInEffect::set(Mode mode, uint8_t value, uint32_t line) {
  ModeSets& now = state_.now;
  const bool same = now[mode] == value_bit(value) && !now.is_open(mode);
  double* const number = now.number(mode);  // of feeds and speeds there are many
  if (number == nullptr && same) return;
  if (number != nullptr) *number = ModeSets::kAnyNumber;
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

void ModesInEffect::need_of(const WordLine& words, uint32_t line) {
  const MotionSet motions = words.depends_on_motion() ? state_.now[Mode::kMotion] : all_modes();
  const Motion motion = words.motion(static_cast<Motion>(std::countr_zero(motions)));
  if (motion == Motion::kNone || motion == Motion::kG80 || !words.has_axis_words()) return;
  if (words.depends_on_motion()) need(Mode::kMotion, line);
  need(Mode::kUnits, line);
  if (words.code(GGroup::kNonModal) == nullptr) {
    need(Mode::kDistance, line);
    need(Mode::kSystem, line);
  }
  if (words.has('x')) need(Mode::kDiameter, line);
  if (contains(kPlainMotions, motion)) need(Mode::kCompensation, line);
  if (contains(kCycles, motion)) need(Mode::kRetract, line);
  if (motion == Motion::kG2 || motion == Motion::kG3) need(Mode::kPlane, line);
  if (motion != Motion::kG0) need(Mode::kFeedMode, line);
}

void ModesInEffect::pass(const PlainEffect& effect, uint32_t before, uint32_t last) {
  if (stopped_) return;
  feeds_ = feeds_ || effect.feeds || effect.alone;
  if (effect.alone) need(Mode::kMotion, before + effect.first_move);
  if (effect.moves) {
    for (const Mode mode : {Mode::kUnits, Mode::kDistance, Mode::kSystem, Mode::kCompensation})
      need(mode, before + effect.first_move);
    if ((effect.axes & letter_set("x")) != 0) need(Mode::kDiameter, before + effect.first_move);
    if (effect.feeds) need(Mode::kFeedMode, before + effect.first_move);
    if (effect.first_arc != 0) need(Mode::kPlane, before + effect.first_arc);
  }
  if (effect.motion != Motion::kNone) drop_curve(effect.first_move == 0 ? last : before + effect.first_move);
  if (effect.moves) moved(effect.alone && !is_single(state_.now[Mode::kMotion]), last);
  if (effect.motion != Motion::kNone) set(Mode::kMotion, static_cast<uint8_t>(effect.motion), last);
  const bool inverse = state_.now[Mode::kFeedMode] == value_bit(modes::kG93);
  if (effect.feed && (!inverse || effect.feeds)) set(Mode::kFeed, modes::kFeedSet, last);
  if (effect.speed) set(Mode::kSpeed, modes::kSpeedSet, last);
  if (effect.straight) set(Mode::kStraightOwed, modes::kNotOwed, last);
}

/// Moves do to some modes what is not worth a question: whether a compensated path has begun depends on how far they go, and by a
/// motion that is not known (`alone`) anything may be added to a curve.
void ModesInEffect::moved(bool alone, uint32_t line) {
  ModeSets& now = state_.now;
  const auto forget = [&](Mode mode) {
    now[mode] = all_values(mode);
    now.open |= mask_of(mode);
    note(mode, ModeChange::kAny, line);
    std::erase_if(asked_, [mode](const ModeFault& fault) { return (fault.decided_by & mask_of(mode)) != 0; });
  };
  if (now[Mode::kCompensation] != value_bit(modes::kG40) && now[Mode::kEntry] != value_bit(modes::kMade))
    forget(Mode::kEntry);
  if (!alone) return;
  for (const Mode mode : {Mode::kStraightOwed, Mode::kNurbs, Mode::kNurbsOrder}) forget(mode);
}

/// Writes down what the lines since the last statement have set.
void ModesInEffect::flush() {
  if (changed_ == 0 && !places_.has_moved()) return;
  const bool first = out_.statements.empty();
  // What a line with block delete does itself is kept apart from what comes after it.
  if (!first && out_.statements.back().block_delete) {
    const Statement deleted = out_.statements.back();
    Statement after;
    after.offset = deleted.end();
    after.line = deleted.line;
    out_.statements.push_back(after);
  }
  places_.flush();
  if (changed_ == 0) return;
  for (; changed_ != 0; changed_ &= changed_ - 1) {
    ModeChange change = pending_[static_cast<size_t>(std::countr_zero(changed_))];
    change.moves = feeds_;
    change.after = first ? kNoStatement : static_cast<StatementId>(out_.statements.size() - 1);
    (first ? out_.first_changes : out_.mode_changes).push_back(change);
  }
  feeds_ = false;
  if (!first) out_.statements.back().changes_modes = true;
}

/// Whether the flow has to carry out the line: what it stops with or does depends on what is not known here.
bool ModesInEffect::asks(const WordLine& words, const ModeState& after, bool alone) const {
  if (!faults_.empty() || stacks_modes(words) || cuts_contour(words) || words.has_unknown_code() ||
      words.has_remapped_code())
    return true;
  for (size_t i = 0; i < words.size(); ++i) {
    if (!words[i].known && (letter_set({&words[i].letter, 1}) & kPlaceLetters & ~machine_.wrapped) == 0) return true;
  }
  return (after.now.assigned & after.now.open & ~of_moves(alone)) != 0;
}

/// Takes over what a line without a question does.
void ModesInEffect::take(const ModeState& after, bool alone, uint32_t line) {
  const ModeSets before = state_.now;
  state_ = after;
  for (ModeMask set = after.now.assigned & ~(of_moves(alone) & after.now.open); set != 0; set &= set - 1) {
    const Mode mode = mode_at(static_cast<size_t>(std::countr_zero(set)));
    if (after.now[mode] != before[mode] || before.is_open(mode) || mode == Mode::kFeed || mode == Mode::kSpeed)
      note(mode, value_of(after.now, mode), line);
    else
      note_set(mode, value_of(after.now, mode), line);
  }
  state_.now.assigned = 0;
}

/// Leaves out what a line before has asked: a run that goes on behind it does not stop for the same in the same modes.
void ModesInEffect::leave_out_asked(ModeMask assigned) {
  std::erase_if(faults_, [&](const ModeFault& fault) {
    const auto same = [&](const ModeFault& before) {
      // A message belongs to one motion, or to all alike; but of a motion that was not known only some runs had it.
      constexpr ModeMask kMotion = mask_of(Mode::kMotion);
      return (before.decided_by | kMotion) == (fault.decided_by | kMotion) &&
          (before.decided_by & kMotion) <= (fault.decided_by & kMotion) && before.fault.message == fault.fault.message;
    };
    // A spindle that the line itself stops has not been asked about.
    const bool own = (fault.decided_by & assigned & mask_of(Mode::kTurning)) != 0;
    return !own && !fault.fault.certain && fault.decided_by != 0 && std::ranges::any_of(asked_, same);
  });
}

/// A feed that is not 0 is taken for set, whatever the feed mode: what that does in inverse time mode the flow knows. Where that
/// is surely in effect, F is only for the line's own move.
void ModesInEffect::set_feed(const WordLine& words, ModeSets* after) {
  constexpr double kSmallFeed = 0.05;
  const uint8_t f = words.find('f');
  const bool open = (after->assigned & after->open & mask_of(Mode::kFeed)) != 0;
  if (!open || f == kNoWord || !words[f].known || words[f].value < kSmallFeed) return;
  const bool moves = words.has_axis_words() || words.has_polar_words();
  if (!moves && (*after)[Mode::kFeedMode] == value_bit(modes::kG93)) return;
  (*after)[Mode::kFeed] = value_bit(modes::kFeedSet);
  after->open &= ~mask_of(Mode::kFeed);
}

/// Runs come from elsewhere.
void ModesInEffect::forget() {
  state_ = anything_;
  settled_ = unused_ = 0;
  asked_.clear();
  stopped_ = false;
  curve_ = {};
}

/// Whether the line sets a number that may be one of the machine's positions and offsets.
bool ModesInEffect::writes_offsets(const Statement& statement) const {
  return std::ranges::any_of(out_.items_of(statement), [this](const Item& item) {
    double number = 0;
    return item.target != kNoExpr && (!literal_value(out_.exprs, item.target, &number) || is_place_parameter(number));
  });
}

/// Whether the line moves at the rapid rate, if it moves.
bool ModesInEffect::stays_rapid(const WordLine& words) const {
  return words.motion(static_cast<Motion>(std::countr_zero(state_.now[Mode::kMotion]))) == Motion::kG0;
}

/// A line that no run gets to because one before it stops: only what stops it in any mode is a mistake of its own.
bool ModesInEffect::judge_behind(Statement& statement, const WordLine& words) {
  ModeState any = anything_;
  ModeRun(machine_, words).run(&any, &faults_);
  if (faults_.size() != 1 || !faults_.front().fault.certain) return false;
  statement.error = parser_.add_error(faults_.front().fault, faults_.front().decided_by);
  return true;
}

bool ModesInEffect::judge(Statement& statement, bool keep) {
  faults_.clear();
  remaps_.clear();
  asks_ = asks_place_ = false;
  if (statement.item_count > 0 && writes_offsets(statement)) places_.leave_writing();
  if (parser_.reads_place()) {
    flush();
    places_.leave_reading();
  }
  const WordLine* words = parser_.words();
  if (words == nullptr || statement.has_error()) {
    if (const WordLine* of_call = parser_.words_of_call(); of_call != nullptr && !statement.has_error()) {
      ModeState after = state_;
      ModeRun(machine_, *of_call).check(&after, &faults_);
      asks_ = !faults_.empty();
    }
    // The first one may begin the program, the next one ends it.
    if (statement.kind == LineKind::kPercent && ++percents_ > (out_.percent ? 1 : 0)) {
      places_.end();
      drop_curve(statement.line);
    }
    // At O-words runs come from elsewhere, or go elsewhere and come back; behind a line that stops there is none.
    const bool stops = statement.kind == LineKind::kWords && statement.has_error();
    if (keep && (!stops || statement.block_delete)) {
      flush();
      forget();
      if (!stops && statement.kind != LineKind::kPercent) places_.leave();
    } else if (stops) {
      places_.stop(statement.line);
      stopped_ = true;
    }
    return keep;
  }
  out_.may_set_g91 = out_.may_set_g91 || may_set_g91(*words);
  if (asks_inputs(*words)) {
    out_.input_lines.push_back(statement.line);
    if (!out_.statements.empty()) out_.statements.back().asks_inputs = true;
  }
  if (writes_tools(*words)) machine_.tools_written = out_.writes_tools = true;
  if (stopped_) return judge_behind(statement, *words) || keep;
  const bool alone = words->depends_on_motion() && !is_single(state_.now[Mode::kMotion]);
  ModeState after = state_;
  stopped_ = !ModeRun(machine_, *words).run(&after, &faults_);
  set_feed(*words, &after.now);
  out_.unusual = out_.unusual || leaves_usual(anything_.now, after.now);
  leave_out_asked(after.now.assigned);
  // What M72 writes depends on modes that only the flow knows.
  const bool quotes_all = !faults_.empty() && faults_.front().fault.kind == StopKind::kSavedModes;
  const bool stops = faults_.size() == 1 && faults_.front().fault.certain;
  if (stops && !quotes_all && !faults_.front().behind_user_code) {
    statement.error = parser_.add_error(faults_.front().fault, faults_.front().decided_by);
    if (statement.block_delete) {
      forget();
    } else {
      places_.stop(statement.line);
    }
    return true;
  }
  asks_ = asks(*words, after, alone);
  const bool asks_place = !stopped_ && places_.judge(*words, state_.now, statement, asks_);
  // M72 may lose the end.
  if (ends_program(statement) && !statement.block_delete && !stacks_modes(*words)) places_.end();
  const ModeMask worse = after.now.assigned & ~better(after.now);
  std::erase_if(asked_, [&](const ModeFault& fault) { return (fault.decided_by & worse) != 0; });
  // What has been asked in a mode that the line itself sets: `G17` with compensation says nothing of `G18`.
  const ModeMask by_line = worse & ~of_moves(true);
  for (const ModeFault& fault : faults_) {
    if (asks_ && (fault.decided_by & by_line) == 0) asked_.push_back(fault);
  }
  // With block delete on the line does nothing.
  if (statement.block_delete && (asks_ || after != state_)) {
    asks_ = true;
    stopped_ = false;
    asked_.clear();
    after = anything_;
  }
  follow_curve(*words, after.now, statement);
  if (!asks_) {
    if (asks_place) flush();  // what the line itself sets comes behind it
    asks_ = asks_place_ = asks_place;
    take(after, alone, statement.line);
    need_of(*words, statement.line);
    feeds_ = feeds_ || ((words->has_axis_words() || words->has_polar_words()) && (alone || !stays_rapid(*words)));
    if (words->has_axis_words()) moved(alone, statement.line);
    return keep || asks_place;
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
  if (follows_remaps(statement, *words)) {
    remaps_ = words->remapped_words();
    forget();
  }
  return true;
}

}  // namespace owlint
