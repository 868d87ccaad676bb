#include "analyzer/syntax/moves.h"

#include <bit>
#include <cmath>
#include <limits>

#include "analyzer/geometry/arc.h"
#include "analyzer/syntax/mode_place.h"

namespace owlint {
namespace {

constexpr size_t kTurned = 2;  // axes that a rotation about Z turns

/// One axis of the point on the machine, turned if it has to be; of the machine that was just started, and of the other.
Coordinate on_machine(const Moves& moves, size_t axis, const Coordinate Way::*end) {
  const Place& place = *moves.place;
  const auto with_offset = [&](size_t i) { return moves.ways[i].*end + place.offset[i]; };
  Coordinate at = with_offset(axis);
  const Coordinate rotation = place.system.rotation;
  if (axis < kTurned && !(rotation.value == 0 && rotation.other == 0)) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const bool point = moves.ways[0].is_point() && moves.ways[1].is_point();
    const Coordinate x = with_offset(0), y = with_offset(1);
    const auto turn = [&](double first, double second, double degrees) {
      const Flat there = turned({first, second}, degrees);
      return axis == 0 ? there.first : there.second;
    };
    if (rotation.value != 0) at.value = point ? turn(x.value, y.value, rotation.value) : kNone;
    if (rotation.other != 0) at.other = point ? turn(x.other, y.other, rotation.other) : kNone;
  }
  return at + place.system.origin[axis] + place.tool[axis];
}

/// Whether the program has set all offsets that it does not leave at what a machine without any has.
bool has_own_offsets(const Moves& moves, size_t axis) {
  const Place& place = *moves.place;
  const bool g92 = place.offset[axis].is_known() || !place.has_offset.is_known();
  const bool tool = place.tool[axis].is_known() || place.tool[axis].value == 0;
  const bool turned = axis >= kTurned || place.system.rotation.is_known() || place.system.rotation.value == 0;
  return moves.ways[axis].least.is_known() && moves.ways[axis].greatest.is_known() &&
      place.system.origin[axis].is_known() && g92 && tool && turned;
}

/// Of a move of G53 along a rotary axis, whose words leave the tool offset out.
bool has_no_tool(const Moves& moves, size_t axis) {
  const Place& place = *moves.place;
  const Coordinate without = moves.ways[axis].least + place.offset[axis] + place.system.origin[axis];
  return !is_length(axis) && place.tool[axis].value == 0 && places::agree(without.value, without.other);
}

}  // namespace

double unit_in_effect(const ModeSets& modes) {
  if (!is_single(modes[Mode::kUnits])) return std::numeric_limits<double>::quiet_NaN();
  return modes[Mode::kUnits] == value_bit(modes::kG20) ? kMillimetresInInch : 1;
}

MachineWay machine_way(const Moves& moves, size_t axis, double units_per_mm) {
  MachineWay way;
  const Coordinate least = on_machine(moves, axis, &Way::least), greatest = on_machine(moves, axis, &Way::greatest);
  const double unit = is_length(axis) ? moves.unit * units_per_mm : 1;
  if (least.is_unknown() || greatest.is_unknown() || std::isnan(unit)) return way;
  const Place& place = *moves.place;
  way.least = least.value * unit;
  way.greatest = greatest.value * unit;
  way.least_line = moves.ways[axis].least_line;
  way.greatest_line = moves.ways[axis].greatest_line;
  way.tool = place.tool[axis].value * unit;
  // Without a turn, which is the same for all of them.
  const Coordinate straight =
      moves.ways[axis].least + place.offset[axis] + place.system.origin[axis] + place.tool[axis];
  way.base = (straight.other - straight.value) * unit;
  if (places::agree(least.value, least.other) && places::agree(greatest.value, greatest.other)) {
    way.trust = MachineWay::Trust::kCertain;
  } else if (has_own_offsets(moves, axis) || (moves.machine && has_no_tool(moves, axis))) {
    way.trust = MachineWay::Trust::kOffsets;
  } else if (!std::isnan(way.base)) {
    way.trust = MachineWay::Trust::kDistance;
  }
  return way;
}

}  // namespace owlint
