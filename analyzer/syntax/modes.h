// What is in effect before a line: the modes of the machine as the interpreter keeps them, each as the set of the values that it
// may have there. Lines change them and need them (mode_run.h). Source: measured with rs274, see docs/interpreter.md.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "analyzer/syntax/codes.h"

namespace owlint {

/// A mode. Its values are numbered from 0, and 0 is that of an interpreter that was just started, but for the motion, whose
/// values are those of Motion: there it is Motion::kNone.
enum class Mode : uint8_t {
  kMotion,
  kFeedMode,
  kFeed,
  kSpeed,
  kTurning,
  kSpindleMode,
  kPlane,
  kUnits,
  kDistance,
  kArcDistance,
  kDiameter,
  kSystem,
  kLoaded,  ///< whether a tool is in the spindle
  kToolOffset,
  kRetract,
  kPathControl,
  kCompensation,
  kRadius,  ///< of compensation
  kEntry,   ///< of compensation
  kStraightOwed,
  kNurbs,
  kNurbsOrder,
  kFeedOverride,
  kAdaptiveFeed,
  kFeedHold,
  kCoolant,
  kAxisOffsets,  ///< of G92 and G52
  kSaved,        ///< by M70 or M73, on this level of calls
};
inline constexpr size_t kModes = static_cast<size_t>(Mode::kSaved) + 1;

/// Names of the values.
namespace modes {
enum FeedMode : uint8_t { kG94, kG93, kG95 };
/// Small ones are those that M72 rounds to 0.
enum Feed : uint8_t { kNoFeed, kFeedSet, kSmallFeed };
enum Speed : uint8_t { kNoSpeed, kSpeedSet, kSmallSpeed };
enum Turning : uint8_t { kStopped, kClockwise, kCounterclockwise };
enum SpindleMode : uint8_t { kG97, kG96 };
enum Plane : uint8_t { kG17, kG18, kG19, kG17_1, kG18_1, kG19_1 };
enum Units : uint8_t { kG21, kG20 };
enum Distance : uint8_t { kG90, kG91 };
enum ArcDistance : uint8_t { kG91_1, kG90_1 };
enum Diameter : uint8_t { kG8, kG7 };
enum System : uint8_t { kG54, kG55, kG56, kG57, kG58, kG59, kG59_1, kG59_2, kG59_3 };
enum Loaded : uint8_t { kNoTool, kSomeTool };
enum ToolOffset : uint8_t { kG49, kOffsetOn };
enum Retract : uint8_t { kG99, kG98 };
enum PathControl : uint8_t { kG64, kG61, kG61_1, kG64Within };  ///< the last one with a tolerance
enum Compensation : uint8_t { kG40, kG41, kG42 };
enum Radius : uint8_t { kNoRadius, kRadiusSet };
enum Entry : uint8_t { kToCome, kMade };
enum StraightOwed : uint8_t { kNotOwed, kOwed };
/// Numbers: of the control points, and of the order above the least one. The last value also stands for all above it.
enum Nurbs : uint8_t { kNoPoints, kMostPoints = 62 };
enum NurbsOrder : uint8_t { kOrder3, kMostOrder = 59 };
inline constexpr uint8_t kLeastOrder = 3;
enum FeedOverride : uint8_t { kM48, kM49 };
enum AdaptiveFeed : uint8_t { kAdaptiveOff, kAdaptiveOn };
enum FeedHold : uint8_t { kHoldOn, kHoldOff };
enum Coolant : uint8_t { kNoCoolant, kMist, kFlood, kBoth };
enum AxisOffsets : uint8_t { kNotApplied, kApplied };
enum Saved : uint8_t { kNotSaved, kSavedByM70, kSavedByM73 };
}  // namespace modes

/// Values of one mode as the bits of a number.
using ValueSet = uint64_t;
/// Modes as the bits of a number.
using ModeMask = uint32_t;
constexpr ValueSet value_bit(uint8_t value) { return ValueSet{1} << value; }
constexpr ModeMask mask_of(Mode mode) { return ModeMask{1} << static_cast<int>(mode); }
inline constexpr ModeMask kAllModes = (mask_of(Mode::kSaved) << 1) - 1;

/// Whether it is one value. std::has_single_bit() counts the bits, which older processors need a function for.
constexpr bool is_single(ValueSet values) { return values != 0 && (values & (values - 1)) == 0; }

/// Modes that few programs leave. While they are as an interpreter starts, a G0, and a G1 with a feed, run whatever else is in
/// effect.
inline constexpr ModeMask kUsualModes = mask_of(Mode::kFeedMode) | mask_of(Mode::kSpindleMode) |
    mask_of(Mode::kArcDistance) | mask_of(Mode::kDiameter) | mask_of(Mode::kCompensation) | mask_of(Mode::kRadius) |
    mask_of(Mode::kEntry) | mask_of(Mode::kStraightOwed) | mask_of(Mode::kNurbs) | mask_of(Mode::kNurbsOrder) |
    mask_of(Mode::kSaved);

template <typename Do>
void for_values(ValueSet values, Do apply) {
  for (; values != 0; values &= values - 1) apply(static_cast<uint8_t>(std::countr_zero(values)));
}

/// All values that the mode has.
ValueSet all_values(Mode mode);
/// `feed mode`, as a reader understands it.
std::string_view mode_name(Mode mode);
/// `G93`, `stopped`.
std::string value_name(Mode mode, uint8_t value);

/// For every mode the values that may be in effect: never none. A mode that is not `open` has each of them on some run; of one
/// that is open it is only known that it has no other.
struct ModeSets {
  std::array<ValueSet, kModes> may{};
  ModeMask open = 0;
  /// Which feed and speed they are: the number, if it is known; below -1 that of a certain line; -1 if nothing is known.
  double feed_number = 0, speed_number = 0;
  ModeMask assigned = 0;  ///< modes that lines have set since this was 0, on some run

  ValueSet& operator[](Mode mode) { return may[static_cast<size_t>(mode)]; }
  ValueSet operator[](Mode mode) const { return may[static_cast<size_t>(mode)]; }
  bool is_open(Mode mode) const { return (open & mask_of(mode)) != 0; }
  bool operator==(const ModeSets&) const = default;

  /// Some runs have ended: of a mode that still has several values it is not known which are left.
  void lose_runs();

  static constexpr double kAnyNumber = -1;
  double* number(Mode mode) {
    return mode == Mode::kFeed ? &feed_number : mode == Mode::kSpeed ? &speed_number : nullptr;
  }

  static ModeSets started();  ///< those of an interpreter that was just started
  static ModeSets unknown();  ///< any, and all open
  static ModeSets usual();    ///< the same, but for kUsualModes, which are as an interpreter starts
};

/// What an interpreter remembers of modes between two lines.
struct ModeState {
  ModeSets now;
  ModeSets saved;  ///< what M72 restores, or the end of a sub behind M73

  bool operator==(const ModeState&) const = default;
  void lose_runs() {
    now.lose_runs();
    saved.lose_runs();
  }
  static ModeState started() { return {ModeSets::started(), ModeSets::started()}; }
  static ModeState unknown() { return {ModeSets::unknown(), ModeSets::unknown()}; }
  static ModeState usual() { return {ModeSets::usual(), ModeSets::unknown()}; }
};

/// The least sets that hold both.
ModeSets join(const ModeSets& a, const ModeSets& b);
ModeState join(const ModeState& a, const ModeState& b);

}  // namespace owlint
