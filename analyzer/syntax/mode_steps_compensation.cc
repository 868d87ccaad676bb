// Cutter compensation on and off: G40 to G42.1.
#include <cmath>

#include "analyzer/syntax/mode_place.h"

namespace owlint::steps {
namespace {

constexpr int kFrontOrientation = 9;  ///< of a lathe tool; 0 is a mill's

bool is_right(int code) { return code == code::kG42 || code == code::kG42_1; }

/// A negative diameter is that of the other side.
bool switch_on(ModeLine& line, int code, const double* diameter) {
  const bool right = is_right(code);
  line.set(Mode::kEntry, modes::kToCome);
  if (diameter == nullptr) {
    line.set_open(Mode::kCompensation, all_but(modes::kG40) & all_values(Mode::kCompensation));
    line.set_open(Mode::kRadius);
    return false;
  }
  line.set(Mode::kCompensation, right == (*diameter >= 0) ? modes::kG42 : modes::kG41);
  line.set(Mode::kRadius, *diameter == 0 ? modes::kNoRadius : modes::kRadiusSet);
  return false;
}

/// A diameter of 0 is one that is not known, or makes no path.
void begin_path(ModeLine& line, int code, double diameter, int orientation) {
  places::begin_path(line, is_right(code), diameter / 2, orientation);
}

/// G41.1 and G42.1: D is the diameter, L the orientation.
bool by_diameter(ModeLine& line, int code) {
  const uint8_t word = line.at(GGroup::kCutterCompensation);
  if (!line.has('d')) return line.stop(StopKind::kCompensation, g_name(code) + " with no D word", word);
  constexpr BadMode kNotG18{Mode::kPlane, all_but(modes::kG18)};
  if (line.has('l') && line.holds({kNotG18}) != Answer::kNo &&
      line.stop_in({kNotG18}, StopKind::kCompensation, g_name(code) + " with L word, but plane is not G18",
                   line.at('l'), word))
    return true;
  const double* const diameter = line.value('d');
  const double* const orientation = line.value('l');
  const bool known = diameter != nullptr && (!line.has('l') || orientation != nullptr);
  begin_path(line, code, known ? *diameter : 0, orientation == nullptr ? 0 : nearest_integer(*orientation));
  return switch_on(line, code, diameter);
}

/// A tool that is oriented as those of a lathe cuts in XZ. `in_spindle`: which tool it is depends on lines before.
bool refuses_lathe_tool(ModeLine& line, int code, const Tool& tool, bool in_spindle) {
  constexpr BadMode kNotG18{Mode::kPlane, all_but(modes::kG18)};
  if (tool.orientation == 0 || tool.orientation == kFrontOrientation || line.holds({kNotG18}) == Answer::kNo)
    return false;
  const size_t before = line.faults()->size();
  const uint8_t word = line.at(GGroup::kCutterCompensation);
  const bool stops = line.stop_in({kNotG18}, StopKind::kCompensation,
                                  g_name(code) + " with lathe tool, but plane is not G18", line.at('d'), word);
  for (size_t i = before; i < line.faults()->size(); ++i) (*line.faults())[i].by_place = in_spindle;
  return stops;
}

/// G41 and G42: D is the number of a tool, without it that of the tool in the spindle.
bool by_tool(ModeLine& line, int code) {
  const uint8_t word = line.at(GGroup::kCutterCompensation);
  const double* const d = line.value('d');
  const double whole = d == nullptr ? 0 : std::trunc(*d + 0.5);
  if (d != nullptr && !(std::abs(*d - whole) < kWholeSlack))
    return line.stop(StopKind::kCompensation, g_name(code) + " requires D word to be a whole number", line.at('d'),
                     word);
  const int number = nearest_integer(whole);
  if (line.lacks_tool(number, line.at('d'), word)) return true;
  constexpr double kNothing = 0;
  if (number == 0 && line.holds({{Mode::kLoaded, value_bit(modes::kNoTool)}}) == Answer::kYes)
    return switch_on(line, code, &kNothing);
  // M6 on the line itself has not changed that tool yet.
  const bool in_spindle = number == 0 && line.code(MGroup::kToolChange) < 0;
  const Tool* const tool = in_spindle ? line.tool_in_spindle() : line.tool(number);
  if (tool == nullptr) return switch_on(line, code, nullptr);
  if (line.machine().tools_written) {
    begin_path(line, code, 0, 0);
    return switch_on(line, code, nullptr);
  }
  if (refuses_lathe_tool(line, code, *tool, in_spindle)) return true;
  // A caller may have given it another diameter.
  const bool changed = line.place() != nullptr && line.place()->tools_changed;
  const double diameter = from_machine(line, Coordinate::of(tool->diameter), 0).value;
  begin_path(line, code, changed || std::isnan(diameter) ? 0 : diameter, tool->orientation);
  return switch_on(line, code, &tool->diameter);
}

}  // namespace

void switch_compensation_off(ModeFaults& of) {
  const BadMode made{Mode::kEntry, value_bit(modes::kMade)};
  const Answer path = of.holds({kCompensationMoves, made});
  if (path == Answer::kYes) of.set(Mode::kStraightOwed, modes::kOwed);
  if (path == Answer::kMaybe) of.set_open(Mode::kStraightOwed);
  of.set(Mode::kCompensation, modes::kG40);
  of.set(Mode::kRadius, modes::kNoRadius);
  of.set(Mode::kEntry, modes::kToCome);
}

bool compensation(ModeLine& line) {
  const int code = line.code(GGroup::kCutterCompensation);
  if (code < 0) return false;
  if (code == code::kG40) {
    if (places::end_path(line)) return true;
    switch_compensation_off(line);
    return false;
  }
  const uint8_t word = line.at(GGroup::kCutterCompensation);
  constexpr ValueSet kFlat = value_bit(modes::kG17) | value_bit(modes::kG18);
  if (line.stop_in({{Mode::kPlane, ~kFlat}}, StopKind::kCompensation,
                   "Cutter radius compensation allowed only in XY, XZ planes", word))
    return true;
  if (line.refused_by_compensation("Cannot turn cutter radius comp on when on", word)) return true;
  const bool by_d = code == code::kG41_1 || code == code::kG42_1;
  return by_d ? by_diameter(line, code) : by_tool(line, code);
}

}  // namespace owlint::steps
