// Feed and spindle: G93 to G97, F, S, M3 to M5, M19, and what the motions need of them.
#include <algorithm>

#include "analyzer/syntax/mode_line.h"

namespace owlint::steps {
namespace {

constexpr ValueSet kPerMinute = value_bit(modes::kG94);
constexpr ValueSet kPerTurn = value_bit(modes::kG95);
constexpr ValueSet kOfMove = value_bit(modes::kG93);
constexpr BadMode kZeroFeed{Mode::kFeed, value_bit(modes::kNoFeed)};
constexpr BadMode kZeroSpeed{Mode::kSpeed, value_bit(modes::kNoSpeed)};
constexpr double kLeastKeptFeed = 0.05;  // M72 writes F with one decimal
constexpr double kMostLostSpeed = 0.5;   // and S with none

constexpr MotionSet sets(auto... motions) { return (set_of(motions) | ...); }
constexpr MotionSet kArcs = sets(Motion::kG2, Motion::kG3);

struct FeedCheck {
  enum Needs : uint8_t { kFeed, kSpeed, kF, kOtherMode };

  MotionSet motions;
  ValueSet in;  ///< the feed modes in which it is checked
  Needs needs;
  const char* message;
};

/// In the order in which each motion checks them.
constexpr FeedCheck kFeedChecks[] = {
    {sets(Motion::kG1), kPerMinute | kPerTurn, FeedCheck::kFeed, "Cannot do g1 with zero feed rate"},
    {kArcs, kPerMinute | kPerTurn, FeedCheck::kFeed, "Cannot make arc with zero feed rate"},
    {kSplines, kPerMinute, FeedCheck::kFeed, "Cannot make arc with zero feed rate"},
    {sets(Motion::kG5_2), kPerMinute, FeedCheck::kFeed, "Cannot make a NURBS with 0 feedrate"},
    {sets(Motion::kG6_2), kPerMinute, FeedCheck::kFeed, "Cannot make a nurbs with 0 feedrate"},
    {kProbes, ~ValueSet{0}, FeedCheck::kFeed, "Cannot probe with zero feed rate"},
    {kCycles, ~ValueSet{0}, FeedCheck::kFeed, "Cannot feed with zero feed rate"},
    {kArcs | sets(Motion::kG1), kPerTurn, FeedCheck::kSpeed,
     "Cannot feed with zero spindle speed in feed per rev mode"},
    {sets(Motion::kG1), kOfMove, FeedCheck::kF, "F word missing with inverse time g1 move"},
    {kArcs | kSplines, kOfMove, FeedCheck::kF, "F word missing with inverse time arc move"},
    {kProbes, kPerTurn, FeedCheck::kOtherMode, "Cannot probe with feed per rev mode"},
    {kCycles, kOfMove, FeedCheck::kOtherMode, "Cannot use inverse time feed with canned cycles"},
};

bool fails(ModeLine& line, const FeedCheck& check) {
  BadMode in{Mode::kFeedMode, check.in};
  // In G94 and G95 the F of the line itself is the feed.
  const double* const f = line.value('f');
  if (check.needs == FeedCheck::kFeed && f != nullptr && *f > 0) in.values &= kOfMove;
  const uint8_t word = line.mover();
  switch (check.needs) {
    case FeedCheck::kFeed: return line.stop_in({in, kZeroFeed}, StopKind::kFeedMissing, check.message, word);
    case FeedCheck::kSpeed: return line.stop_in({in, kZeroSpeed}, StopKind::kSpindleStopped, check.message, word);
    case FeedCheck::kF: return !line.has('f') && line.stop_in({in}, StopKind::kFeedMode, check.message, word);
    case FeedCheck::kOtherMode: return line.stop_in({in}, StopKind::kFeedMode, check.message, word);
  }
  return false;
}

struct TurningCheck {
  Motion motion;
  modes::Turning turning;
  const char* message;
};
constexpr TurningCheck kTurningChecks[] = {
    {Motion::kG74, modes::kStopped, "Spindle not turning in G74"},
    {Motion::kG74, modes::kClockwise, "Spindle turning clockwise in G74"},
    {Motion::kG84, modes::kStopped, "Spindle not turning in G84"},
    {Motion::kG84, modes::kCounterclockwise, "Spindle turning counterclockwise in G84"},
    {Motion::kG86, modes::kStopped, "Spindle not turning in g86"},
    {Motion::kG87, modes::kStopped, "Spindle not turning in g87"},
    {Motion::kG88, modes::kStopped, "Spindle not turning in g88"},
};

modes::Feed size_of_feed(double value) {
  return value == 0 ? modes::kNoFeed : value < kLeastKeptFeed ? modes::kSmallFeed : modes::kFeedSet;
}

modes::Speed size_of_speed(double value) {
  return value == 0 ? modes::kNoSpeed : value <= kMostLostSpeed ? modes::kSmallSpeed : modes::kSpeedSet;
}

/// M19.
bool orient(ModeLine& line, uint8_t word) {
  line.set(Mode::kTurning, modes::kStopped);
  if (line.refuses_spindle(0, "Spindle ($) number out of range in M19 Command", word)) return true;
  const double* const wait = line.value('q');
  return wait != nullptr && *wait <= 0 &&
      line.stop(StopKind::kModeConflict, "Q word with M19 requires a value > 0", line.at('q'), word);
}

}  // namespace

bool spindle_mode(ModeLine& line) {
  const int code = line.code(GGroup::kSpindleMode);
  if (code < 0) return false;
  line.set(Mode::kSpindleMode, code == code::kG96 ? modes::kG96 : modes::kG97);
  return line.choose_spindle("Invalid spindle ($) number in Spindle Mode command", line.at(GGroup::kSpindleMode));
}

bool feed_mode(ModeLine& line) {
  const int code = line.code(GGroup::kFeedMode);
  if (code < 0) return false;
  line.set(Mode::kFeedMode, code == code::kG93 ? modes::kG93 : code == code::kG94 ? modes::kG94 : modes::kG95);
  if (code != code::kG93) line.set(Mode::kFeed, modes::kNoFeed);
  return line.choose_spindle("Invalid spindle ($) number in Spindle Feed command", line.at(GGroup::kFeedMode));
}

bool feed(ModeLine& line) {
  if (!line.has('f')) return false;
  // In G93 it belongs to the line's own move.
  const Answer taken = line.holds({{Mode::kFeedMode, kPerMinute | kPerTurn}});
  if (taken == Answer::kNo) return false;
  const double* const value = line.value('f');
  if (taken == Answer::kYes && value != nullptr) {
    line.set(Mode::kFeed, size_of_feed(*value));
    line.now().feed_number = *value;
  } else {
    line.set_open(Mode::kFeed);
  }
  return false;
}

bool speed(ModeLine& line) {
  if (!line.has('s')) return false;
  const double* const value = line.value('s');
  if (value != nullptr) {
    line.set_spindle(Mode::kSpeed, size_of_speed(*value));
    const bool only_one = line.machine().spindles <= 1 && line.is_for_spindle() == Answer::kYes;
    if (only_one) line.now().speed_number = *value;
  } else if (line.is_for_spindle() != Answer::kNo) {
    line.set_open(Mode::kSpeed);
  }
  return line.refuses_spindle(-1, "Invalid spindle ($) number in Spindle speed command", line.at('s'));
}

bool spindle(ModeLine& line) {
  const uint8_t word = line.at(MGroup::kSpindle);
  switch (line.code(MGroup::kSpindle)) {
    case code::kM3:
      line.set_spindle(Mode::kTurning, modes::kClockwise);
      return line.refuses_spindle(-1, "Spindle ($) number out of range in M3 Command", word);
    case code::kM4:
      line.set_spindle(Mode::kTurning, modes::kCounterclockwise);
      return line.refuses_spindle(-1, "Spindle ($) number out of range in M4 Command", word);
    case code::kM5:
      line.set_spindle(Mode::kTurning, modes::kStopped);
      return line.refuses_spindle(-1, "Spindle ($) number out of range in M5 Command", word);
    case code::kM19: return orient(line, word);
    default: return false;
  }
}

bool feed_of(ModeLine& line, Motion motion) {
  return std::ranges::any_of(
      kFeedChecks, [&](const FeedCheck& check) { return contains(check.motions, motion) && fails(line, check); });
}

bool turning(ModeLine& line, Motion motion) {
  return std::ranges::any_of(kTurningChecks, [&](const TurningCheck& check) {
    return check.motion == motion &&
        line.stop_in({{Mode::kTurning, value_bit(check.turning)}}, StopKind::kSpindleStopped, check.message,
                     line.mover());
  });
}

}  // namespace owlint::steps
