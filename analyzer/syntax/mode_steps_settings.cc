// Codes that set a mode, and hardly more: plane, units, distances, coordinate system, path, retract, coolant, overrides.
#include <algorithm>

#include "analyzer/syntax/mode_place.h"

namespace owlint::steps {
namespace {

struct Setting {
  int16_t code;
  Mode mode;
  uint8_t value;
};

constexpr Setting kSettings[] = {
    {code::kG17, Mode::kPlane, modes::kG17},           {code::kG18, Mode::kPlane, modes::kG18},
    {code::kG19, Mode::kPlane, modes::kG19},           {code::kG17_1, Mode::kPlane, modes::kG17_1},
    {code::kG18_1, Mode::kPlane, modes::kG18_1},       {code::kG19_1, Mode::kPlane, modes::kG19_1},
    {code::kG20, Mode::kUnits, modes::kG20},           {code::kG21, Mode::kUnits, modes::kG21},
    {code::kG7, Mode::kDiameter, modes::kG7},          {code::kG8, Mode::kDiameter, modes::kG8},
    {code::kG54, Mode::kSystem, modes::kG54},          {code::kG55, Mode::kSystem, modes::kG55},
    {code::kG56, Mode::kSystem, modes::kG56},          {code::kG57, Mode::kSystem, modes::kG57},
    {code::kG58, Mode::kSystem, modes::kG58},          {code::kG59, Mode::kSystem, modes::kG59},
    {code::kG59_1, Mode::kSystem, modes::kG59_1},      {code::kG59_2, Mode::kSystem, modes::kG59_2},
    {code::kG59_3, Mode::kSystem, modes::kG59_3},      {code::kG61, Mode::kPathControl, modes::kG61},
    {code::kG61_1, Mode::kPathControl, modes::kG61_1}, {code::kG64, Mode::kPathControl, modes::kG64},
    {code::kG90, Mode::kDistance, modes::kG90},        {code::kG91, Mode::kDistance, modes::kG91},
    {code::kG90_1, Mode::kArcDistance, modes::kG90_1}, {code::kG91_1, Mode::kArcDistance, modes::kG91_1},
    {code::kG98, Mode::kRetract, modes::kG98},         {code::kG99, Mode::kRetract, modes::kG99},
};

const Setting* setting(const ModeLine& line, GGroup group) {
  const int code = line.code(group);
  if (code < 0) return nullptr;
  return std::ranges::find(kSettings, code, &Setting::code);
}

/// The line's code of the group sets its mode.
bool set(ModeLine& line, GGroup group) {
  if (const Setting* const set = setting(line, group)) line.set(set->mode, set->value);
  return false;
}

/// The same of a group whose codes compensation refuses.
bool set_without_compensation(ModeLine& line, GGroup group, std::string_view refusal) {
  if (line.code(group) < 0) return false;
  return line.refused_by_compensation(refusal, line.at(group)) || set(line, group);
}

/// P or Q of G64: missing or not above 0, it is no tolerance.
bool may_be_tolerance(const ModeLine& line, char letter) {
  const double* const value = line.value(letter);
  return line.has(letter) && (value == nullptr || *value > 0);
}

/// What a code of the group kOverrides does, as far as a line can need it: M51 is about the speed, which decides nothing.
struct Override {
  int16_t code;
  Mode mode;
  uint8_t on, off;
};
constexpr Override kOverrides[] = {
    {code::kM48, Mode::kFeedOverride, modes::kM48, modes::kM48},
    {code::kM49, Mode::kFeedOverride, modes::kM49, modes::kM49},
    {code::kM50, Mode::kFeedOverride, modes::kM48, modes::kM49},
    {code::kM52, Mode::kAdaptiveFeed, modes::kAdaptiveOn, modes::kAdaptiveOff},
    {code::kM53, Mode::kFeedHold, modes::kHoldOn, modes::kHoldOff},
};

/// Whether the code turns something on: M50 to M53 do so without P, or if it is not 0.
Answer turns_on(const ModeLine& line, int code) {
  if (code == code::kM48) return Answer::kYes;
  if (code == code::kM49) return Answer::kNo;
  if (line.lacks('p')) return Answer::kYes;
  const double* const p = line.value('p');
  return p == nullptr ? Answer::kMaybe : *p != 0 ? Answer::kYes : Answer::kNo;
}

bool set_override(ModeLine& line, const Override& override, Answer on) {
  if (on == Answer::kMaybe) {
    line.set_open(override.mode);
  } else {
    line.set(override.mode, on == Answer::kYes ? override.on : override.off);
  }
  return false;
}

}  // namespace

bool plane(ModeLine& line) {
  const Setting* const plane = setting(line, GGroup::kPlane);
  if (plane == nullptr) return false;
  // U, V and W planes are taken even then, though nothing moves there.
  const bool has_axes = plane->value <= modes::kG19;
  if (has_axes &&
      line.stop_in({kCompensationOn, {Mode::kPlane, all_but(plane->value)}}, StopKind::kCompensation,
                   "Cannot change planes with cutter radius compensation on", line.at(GGroup::kPlane)))
    return true;
  line.set(Mode::kPlane, plane->value);
  return false;
}

bool units(ModeLine& line) {
  const Setting* const units = setting(line, GGroup::kUnits);
  if (units == nullptr) return false;
  // The feed is read back from the machine, which has not got it yet if a compensated move waits.
  const BadMode waits{Mode::kEntry, value_bit(modes::kMade)};
  if (line.holds({kCompensationMoves, waits, {Mode::kUnits, all_but(units->value)}}) != Answer::kNo)
    line.set_open(Mode::kFeed);
  const Answer changes = line.holds({{Mode::kUnits, all_but(units->value)}});
  line.set(Mode::kUnits, units->value);
  places::change_units(line, changes);
  return false;
}

bool diameter(ModeLine& line) { return set(line, GGroup::kDiameter); }
bool distance(ModeLine& line) { return set(line, GGroup::kDistance) || set(line, GGroup::kArcDistance); }

bool system(ModeLine& line) {
  const Setting* const system = setting(line, GGroup::kCoordinateSystem);
  if (system == nullptr) return false;
  if (line.refused_by_compensation("Cannot change coordinate systems with cutter radius compensation on",
                                   line.at(GGroup::kCoordinateSystem)))
    return true;
  places::select_system(line, system->value);
  line.set(Mode::kSystem, system->value);
  return false;
}

bool retract(ModeLine& line) {
  return set_without_compensation(line, GGroup::kRetract,
                                  "Cannot change retract mode with cutter radius compensation on");
}

bool path_control(ModeLine& line) {
  if (set_without_compensation(line, GGroup::kPathControl,
                               "Cannot change control mode with cutter radius compensation on"))
    return true;
  if (line.code(GGroup::kPathControl) == code::kG64 && (may_be_tolerance(line, 'p') || may_be_tolerance(line, 'q')))
    line.set(Mode::kPathControl, modes::kG64Within);
  return false;
}

bool coolant(ModeLine& line) {
  const int code = line.code(MGroup::kCoolant);
  if (code < 0) return false;
  if (code == code::kM9) {
    line.set(Mode::kCoolant, modes::kNoCoolant);
    return false;
  }
  const uint8_t more = code == code::kM7 ? modes::kMist : modes::kFlood;
  ValueSet after = 0;
  for_values(line.now()[Mode::kCoolant], [&](uint8_t before) { after |= value_bit(before | more); });
  line.now()[Mode::kCoolant] = after;
  line.now().assigned |= mask_of(Mode::kCoolant);
  return false;
}

bool overrides(ModeLine& line) {
  const int code = line.code(MGroup::kOverrides);
  if (code < 0) return false;
  const uint8_t word = line.at(MGroup::kOverrides);
  if (code == code::kM51 && line.refuses_spindle(1, "Invalid spindle ($) number in M51 command", word)) return true;
  const Answer on = turns_on(line, code);
  constexpr const char* kEnable = "Cannot enable overrides with cutter radius compensation on";
  constexpr const char* kDisable = "Cannot disable overrides with cutter radius compensation on";
  if (on == Answer::kMaybe) {
    // It stops either way, but it is not known what with.
    if (line.holds({kCompensationOn}) != Answer::kNo)
      line.may_stop(StopKind::kCompensation, kEnable, word, line.at('p'));
  } else if (line.refused_by_compensation(on == Answer::kNo ? kDisable : kEnable, word)) {
    return true;
  }
  const auto* const override = std::ranges::find(kOverrides, code, &Override::code);
  return override != std::end(kOverrides) && set_override(line, *override, on);
}

}  // namespace owlint::steps
