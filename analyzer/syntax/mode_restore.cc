#include "analyzer/syntax/mode_restore.h"

#include <algorithm>
#include <bit>

#include "analyzer/syntax/mode_line.h"

namespace owlint {
namespace {

constexpr Answer both(Answer a, Answer b) { return std::min(a, b); }
constexpr Answer opposite(Answer a) {
  return a == Answer::kYes ? Answer::kNo : a == Answer::kNo ? Answer::kYes : Answer::kMaybe;
}
constexpr Answer answer(bool is) { return is ? Answer::kYes : Answer::kNo; }

/// Words that the interpreter writes, by the saved value. Dots stand for a number that is not followed.
struct Written {
  Mode mode;
  std::array<std::string_view, 9> text;
};

/// The one line of F, S and G codes.
constexpr Written kLine[] = {
    {Mode::kFeed, {" F0.0", " F...", " F0.0"}},
    {Mode::kSpeed, {" S0", " S...", " S0"}},
    {Mode::kPlane, {" G17", " G18", " G19", " G17.1", " G18.1", " G19.1"}},
    {Mode::kCompensation, {" G40", " G41", " G42"}},
    {Mode::kDistance, {" G90", " G91"}},
    {Mode::kFeedMode, {" G94", " G93", " G95"}},
    {Mode::kSystem, {" G54", " G55", " G56", " G57", " G58", " G59", " G59.1", " G59.2", " G59.3"}},
    {Mode::kToolOffset, {" G49", " G43"}},
    {Mode::kRetract, {" G99", " G98"}},
    {Mode::kPathControl, {"", " G61", " G61.1"}},
    {Mode::kSpindleMode, {" G97", " G96"}},
    {Mode::kArcDistance, {" G91.1", " G90.1"}},
    {Mode::kDiameter, {" G8", " G7"}},
    {Mode::kAxisOffsets, {" G92.2", " G92.3"}},
    {Mode::kPathControl, {" G64 P0.000000 Q0.000000", "", "", " G64 P... Q..."}},
};
/// M codes: the first one stands on that line too, the others on lines of their own.
constexpr Written kCodes[] = {
    {Mode::kTurning, {"M5", "M3", "M4"}},  {Mode::kCoolant, {"M9", "M7", "M8", "M7"}},
    {Mode::kFeedOverride, {"M48", "M51"}}, {Mode::kAdaptiveFeed, {"", "M52"}},
    {Mode::kFeedHold, {"M53", ""}},
};

/// Modes that are set with compensation already on again.
struct Refused {
  Mode mode;
  const char* message;
};
constexpr Refused kRefused[] = {
    {Mode::kToolOffset, "Cannot change tool offset with cutter radius compensation on"},
    {Mode::kSystem, "Cannot change coordinate systems with cutter radius compensation on"},
    {Mode::kPathControl, "Cannot change control mode with cutter radius compensation on"},
    {Mode::kRetract, "Cannot change retract mode with cutter radius compensation on"},
};

Answer may(const ModeSets& sets, Mode mode, ValueSet values) {
  const ValueSet has = sets[mode] & values;
  return has == 0 ? Answer::kNo : has == sets[mode] ? Answer::kYes : Answer::kMaybe;
}

bool is_override(Mode mode) {
  return mode == Mode::kFeedOverride || mode == Mode::kAdaptiveFeed || mode == Mode::kFeedHold;
}

constexpr ModeMask masks(auto... modes) { return (mask_of(modes) | ...); }
/// Modes that are as they were saved.
constexpr ModeMask kAsSaved =
    masks(Mode::kSpeed, Mode::kTurning, Mode::kSpindleMode, Mode::kPlane, Mode::kUnits, Mode::kDistance,
          Mode::kArcDistance, Mode::kDiameter, Mode::kFeedMode, Mode::kSystem, Mode::kRetract, Mode::kPathControl);
/// Modes that the interpreter may leave on.
constexpr ModeMask kMixed = masks(Mode::kCoolant, Mode::kFeedOverride, Mode::kAdaptiveFeed, Mode::kFeedHold);
constexpr ModeMask kRestored =
    kAsSaved | kMixed | masks(Mode::kFeed, Mode::kCompensation, Mode::kToolOffset, Mode::kAxisOffsets);

constexpr ValueSet kWithMist = value_bit(modes::kMist) | value_bit(modes::kBoth);
constexpr ValueSet kPlanesOfAxes = value_bit(modes::kG17) | value_bit(modes::kG18) | value_bit(modes::kG19);
constexpr ValueSet kPlanesOfCompensation = value_bit(modes::kG17) | value_bit(modes::kG18);
constexpr const char* kNoOverrides = "Cannot enable overrides with cutter radius compensation on";

class Restoration {
 public:
  Restoration(const MachineWords& machine, const ModeSets& saved, uint8_t word, ModeFaults& line)
      : machine_(machine), saved_(saved), word_(word), line_(line), before_(line.now()) {
    for (size_t i = 0; i < kModes; ++i) writes_[i] = find_written(static_cast<Mode>(i));
    on_before_ = may(before_, Mode::kCompensation, kCompensationOn.values);
    on_behind_ = may(saved_, Mode::kCompensation, kCompensationOn.values);
  }

  Restored run() {
    const Answer something = *std::ranges::max_element(writes_);
    if (something == Answer::kNo) return {false, something};
    if (line_fails() || codes_fail()) return {true, something};
    take_back();
    return {false, something};
  }

 private:
  Answer writes(Mode mode) const { return writes_[static_cast<size_t>(mode)]; }
  Answer find_written(Mode mode) const;
  Answer is_written(Mode mode, uint8_t saved, uint8_t now) const;
  Answer other_number(Mode mode) const;
  std::string text_of(const Written& row) const;
  std::string codes_text() const;
  std::string line_text() const;
  Answer is_first(const Written& code) const;

  bool stops(Answer whether, const std::string& text, std::string_view message, Mode mode);
  bool line_fails();
  bool codes_fail();

  void take_back();
  void take_back(Mode mode);
  void mix(Mode mode);
  void take_back_feed();
  ValueSet feeds(uint8_t saved, uint8_t now) const;
  void take_back_speed();
  void take_back_compensation();
  void take_back_offsets();

  const MachineWords& machine_;
  const ModeSets& saved_;
  const uint8_t word_;
  ModeFaults& line_;
  const ModeSets before_;
  std::array<Answer, kModes> writes_{};
  Answer on_before_{}, on_behind_{};  ///< compensation
};

/// Whether the interpreter writes a word to get from the value that is in effect to the saved one. Two feeds, speeds or
/// tolerances may be different numbers.
Answer Restoration::is_written(Mode mode, uint8_t saved, uint8_t now) const {
  const bool always = machine_.release >= Release::k2_10;
  switch (mode) {
    case Mode::kFeed:
    case Mode::kSpeed:
      if (always) return Answer::kYes;
      return saved != now ? Answer::kYes : saved == modes::kNoFeed ? Answer::kNo : other_number(mode);
    case Mode::kPathControl:
      if (always && (saved == modes::kG64 || saved == modes::kG64Within)) return Answer::kYes;
      return saved == now && saved == modes::kG64Within ? Answer::kMaybe : answer(saved != now);
    // What was off is not switched off again.
    case Mode::kAdaptiveFeed: return answer(saved == modes::kAdaptiveOn && now == modes::kAdaptiveOff);
    case Mode::kFeedHold: return answer(saved == modes::kHoldOn && now == modes::kHoldOff);
    case Mode::kCoolant: return answer(saved == modes::kNoCoolant ? now != saved : (saved & ~now) != 0);
    default: return answer(saved != now);
  }
}

/// Whether two feeds or speeds, neither of which is 0 or both are, are different numbers.
Answer Restoration::other_number(Mode mode) const {
  const double saved = mode == Mode::kFeed ? saved_.feed_number : saved_.speed_number;
  const double now = mode == Mode::kFeed ? before_.feed_number : before_.speed_number;
  if (saved != ModeSets::kAnyNumber && saved == now) return Answer::kNo;
  return saved >= 0 && now >= 0 ? Answer::kYes : Answer::kMaybe;
}

Answer Restoration::find_written(Mode mode) const {
  if ((mask_of(mode) & kRestored) == 0) return Answer::kNo;
  bool some = false, all = true;
  for_values(saved_[mode], [&](uint8_t saved) {
    for_values(before_[mode], [&](uint8_t now) {
      const Answer written = is_written(mode, saved, now);
      some = some || written != Answer::kNo;
      all = all && written == Answer::kYes;
    });
  });
  return all ? Answer::kYes : some ? Answer::kMaybe : Answer::kNo;
}

/// Without its number, a word that may be there or not counts as written.
std::string Restoration::text_of(const Written& row) const {
  if (writes(row.mode) == Answer::kNo) return "";
  const auto saved = static_cast<uint8_t>(std::countr_zero(saved_[row.mode]));
  // Mist and flood are two codes, and mist is written first.
  if (row.mode == Mode::kCoolant && saved == modes::kBoth && may(before_, row.mode, kWithMist) == Answer::kYes)
    return "M8";
  return std::string(row.text[saved]);
}

/// The line of F, S and G codes.
std::string Restoration::codes_text() const {
  std::string text;
  for (const Written& row : kLine) text += text_of(row);
  return text;
}

/// The same with the first M code behind it.
std::string Restoration::line_text() const {
  std::string text = codes_text();
  const auto* const code =
      std::ranges::find_if(kCodes, [&](const Written& row) { return writes(row.mode) != Answer::kNo; });
  return code == std::end(kCodes) ? text : text + text_of(*code);
}

/// Whether the M code stands on that line, if it is written.
Answer Restoration::is_first(const Written& code) const {
  Answer first = Answer::kYes;
  for (const Written* row = kCodes; row != &code; ++row) first = both(first, opposite(writes(row->mode)));
  return first;
}

bool Restoration::stops(Answer whether, const std::string& text, std::string_view message, Mode mode) {
  if (whether == Answer::kNo) return false;
  std::string whole = "M7x: restore_settings failed executing: '" + text + "': ";
  whole += message;
  const ModeMask decided_by = mask_of(mode) | mask_of(Mode::kCompensation);
  if (whether == Answer::kYes) return line_.stop(StopKind::kSavedModes, std::move(whole), word_, kNoWord, decided_by);
  line_.may_stop(StopKind::kSavedModes, std::move(whole), word_, kNoWord, decided_by);
  return false;
}

/// What that line stops with, in the order in which its words act.
bool Restoration::line_fails() {
  const std::string text = line_text();
  const Answer g96 = both(writes(Mode::kSpindleMode), may(saved_, Mode::kSpindleMode, value_bit(modes::kG96)));
  if (stops(both(g96, opposite(writes(Mode::kSpeed))), text, "S word missing with G96", Mode::kSpindleMode))
    return true;
  for (const Written& code : kCodes) {
    const Answer refused = both(on_before_, writes(code.mode));
    if (is_override(code.mode) &&
        stops(both(refused, is_first(code)), codes_text() + text_of(code), kNoOverrides, code.mode))
      return true;
  }
  const Answer plane = both(writes(Mode::kPlane), may(saved_, Mode::kPlane, kPlanesOfAxes));
  if (stops(both(on_before_, plane), text, "Cannot change planes with cutter radius compensation on", Mode::kPlane))
    return true;
  const Answer on = both(writes(Mode::kCompensation), on_behind_);
  if (stops(both(on, opposite(may(saved_, Mode::kPlane, kPlanesOfCompensation))), text,
            "Cutter radius compensation allowed only in XY, XZ planes", Mode::kPlane) ||
      stops(both(on, on_before_), text, "Cannot turn cutter radius comp on when on", Mode::kCompensation))
    return true;
  return std::ranges::any_of(kRefused, [&](const Refused& row) {
    return stops(both(writes(row.mode), on_behind_), text, row.message, row.mode);
  });
}

/// What a further M code stops with, on its own line.
bool Restoration::codes_fail() {
  return std::ranges::any_of(kCodes, [&](const Written& code) {
    const Answer refused = both(on_behind_, writes(code.mode));
    return is_override(code.mode) &&
        stops(both(refused, opposite(is_first(code))), text_of(code), kNoOverrides, code.mode);
  });
}

/// The feed behind the line: F is no feed in G93, and G94 and G95 make it 0 where F is not written.
ValueSet Restoration::feeds(uint8_t saved, uint8_t now) const {
  ValueSet after = 0;
  const Answer written = is_written(Mode::kFeed, saved, now);
  const ValueSet given = value_bit(saved == modes::kFeedSet ? modes::kFeedSet : modes::kNoFeed);
  for_values(saved_[Mode::kFeedMode], [&](uint8_t mode) {
    const bool keeps = mode == modes::kG93;
    if (written != Answer::kNo) after |= keeps ? value_bit(now) : given;
    if (written == Answer::kYes) return;
    const Answer differs = may(before_, Mode::kFeedMode, all_but(mode));
    if (keeps || differs != Answer::kYes) after |= value_bit(now);
    if (!keeps && differs != Answer::kNo) after |= value_bit(modes::kNoFeed);
  });
  return after;
}

void Restoration::take_back_feed() {
  ValueSet after = 0;
  for_values(saved_[Mode::kFeed], [&](uint8_t saved) {
    for_values(before_[Mode::kFeed], [&](uint8_t now) { after |= feeds(saved, now); });
  });
  // Units read the feed back from the machine, which has not got it yet if a compensated move waits.
  const bool waits = line_.holds({kCompensationMoves, {Mode::kEntry, value_bit(modes::kMade)}}) != Answer::kNo;
  if (waits && writes(Mode::kUnits) != Answer::kNo) {
    line_.set_open(Mode::kFeed);
  } else if (is_single(after)) {
    line_.set_known(Mode::kFeed, after);
    if (after == value_bit(modes::kFeedSet) && writes(Mode::kFeed) == Answer::kNo)
      line_.now().feed_number = before_.feed_number;
  } else {
    line_.set_open(Mode::kFeed, after);
  }
}

/// With what the saved modes had on, compensation has the radius of the tool in the spindle.
void Restoration::take_back_compensation() {
  const Answer written = writes(Mode::kCompensation);
  if (written == Answer::kNo) return;
  if (written == Answer::kMaybe || on_behind_ == Answer::kMaybe) {
    for (const Mode mode : {Mode::kRadius, Mode::kEntry, Mode::kStraightOwed}) line_.set_open(mode);
    take_back(Mode::kCompensation);
  } else if (on_behind_ == Answer::kNo) {
    steps::switch_compensation_off(line_);
  } else {
    take_back(Mode::kCompensation);
    line_.set_open(Mode::kRadius);
    line_.set(Mode::kEntry, modes::kToCome);
  }
}

void Restoration::take_back_speed() {
  constexpr ValueSet kSmall = value_bit(modes::kSmallSpeed);
  take_back(Mode::kSpeed);
  const ValueSet speed = line_.now()[Mode::kSpeed];
  if (writes(Mode::kSpeed) == Answer::kNo) line_.now().speed_number = before_.speed_number;
  if ((speed & kSmall) == 0) return;
  const ValueSet rounded = (speed & ~kSmall) | value_bit(modes::kNoSpeed);
  if (writes(Mode::kSpeed) == Answer::kYes) line_.set_known(Mode::kSpeed, rounded);
  if (writes(Mode::kSpeed) == Answer::kMaybe) line_.set_open(Mode::kSpeed, speed | rounded);
}

/// G43 is that of the tool in the spindle, and G92.2 and G92.3 do nothing with compensation on.
void Restoration::take_back_offsets() {
  if (writes(Mode::kToolOffset) != Answer::kNo) {
    if (may(saved_, Mode::kToolOffset, value_bit(modes::kOffsetOn)) == Answer::kNo) {
      take_back(Mode::kToolOffset);
    } else {
      line_.set_open(Mode::kToolOffset);
    }
  }
  if (on_behind_ == Answer::kNo) take_back(Mode::kAxisOffsets);
  if (on_behind_ == Answer::kMaybe) line_.set_open(Mode::kAxisOffsets);
}

void Restoration::take_back(Mode mode) {
  line_.set_known(mode, saved_[mode]);
  line_.now().open |= saved_.open & mask_of(mode);
}

/// What was off is only switched off with all coolant, or not at all.
void Restoration::mix(Mode mode) {
  ValueSet after = 0;
  for_values(saved_[mode], [&](uint8_t saved) {
    for_values(before_[mode], [&](uint8_t now) {
      const bool written = is_written(mode, saved, now) == Answer::kYes;
      if (mode == Mode::kCoolant) {
        after |= value_bit(saved == modes::kNoCoolant ? saved : saved | now);
      } else {
        after |= value_bit(written && !(mode == Mode::kFeedOverride && saved == modes::kM49) ? saved : now);
      }
    });
  });
  line_.now()[mode] = after;
  line_.now().open |= saved_.open & mask_of(mode);
}

/// The modes behind the restoration.
void Restoration::take_back() {
  take_back_feed();
  take_back_compensation();
  take_back_offsets();
  for (size_t i = 0; i < kModes; ++i) {
    const auto mode = static_cast<Mode>(i);
    if ((mask_of(mode) & kAsSaved) != 0) take_back(mode);
    if ((mask_of(mode) & kMixed) != 0) mix(mode);
  }
  take_back_speed();
}

}  // namespace

bool steps::save(ModeLine& line) {
  switch (line.code(MGroup::kSpindle)) {
    case code::kM70: line.save(modes::kSavedByM70); break;
    case code::kM73: line.save(modes::kSavedByM73); break;
    case code::kM71: line.set(Mode::kSaved, modes::kNotSaved); break;
    default: break;
  }
  return false;
}

Restored restore(const MachineWords& machine, const ModeSets& saved, uint8_t word, ModeFaults& line) {
  return Restoration(machine, saved, word, line).run();
}

}  // namespace owlint
