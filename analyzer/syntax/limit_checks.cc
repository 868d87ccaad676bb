#include "analyzer/syntax/limit_checks.h"

#include <algorithm>
#include <cmath>

namespace owlint {
namespace {

using Trust = MachineWay::Trust;

/// What rounding may add on the way from a word to motion; LinuxCNC itself lets 1e-12 pass.
double slack(double at) {
  constexpr double kRounding = 1e-9;
  return kRounding * std::max(1.0, std::abs(at));
}

bool is_limited(const AxisLimits& limits) { return std::isfinite(limits.least) || std::isfinite(limits.greatest); }

/// Moves whose ends differ: they are not those of one line.
bool are_several(const Moves& moves) {
  return std::ranges::any_of(moves.ways, [](const Way& way) { return way.least_line != way.greatest_line; });
}

template <typename Do>
void for_limited(const MachineWords& machine, const Moves& moves, const Do& apply) {
  // Cutter compensation puts the tool beside the point.
  if (moves.compensated) return;
  for (size_t axis = 0; axis < kAxisCount; ++axis) {
    if ((moves.axes & axis_set(axis)) == 0 || !is_limited(machine.limits[axis])) continue;
    const MachineWay way = machine_way(moves, axis, machine.units_per_mm);
    if (way.trust != Trust::kNone) apply(axis, way);
  }
}

}  // namespace

std::optional<LimitFault> beyond_limit(const MachineWords& machine, const Moves& moves, size_t axis,
                                       const MachineWay& way, bool greatest) {
  if (way.trust < Trust::kOffsets) return std::nullopt;
  const double limit = greatest ? machine.limits[axis].greatest : machine.limits[axis].least;
  const double end = greatest ? way.greatest : way.least;
  if (!((greatest ? end - limit : limit - end) > slack(limit))) return std::nullopt;
  LimitFault fault;
  fault.line = fault.furthest_line = greatest ? way.greatest_line : way.least_line;
  fault.axis = static_cast<uint8_t>(axis);
  fault.greatest = greatest;
  fault.kind = moves.kind;
  fault.machine = moves.machine;
  fault.position = fault.furthest = end;
  fault.limit = limit;
  const Way& written = moves.ways[axis];
  fault.unit = is_length(axis) ? moves.unit * machine.units_per_mm : 1;
  fault.at_limit = (greatest ? written.greatest : written.least).value - (end - limit) / fault.unit;
  // The tool may be measured again before the program runs.
  const bool certain = way.trust == Trust::kCertain && (moves.machine || way.tool == 0);
  fault.needs = certain ? LimitFault::Needs::kNothing : LimitFault::Needs::kNoOffsets;
  return fault;
}

bool LimitChecks::is_known(const LimitFault& fault) const {
  return std::ranges::any_of(faults_, [&](const LimitFault& known) {
    return known.axis == fault.axis && known.greatest == fault.greatest && known.is_distance() == fault.is_distance() &&
        known.needs <= fault.needs;
  });
}

LimitChecks::Range LimitChecks::widened(size_t axis, const MachineWay& way) const {
  const auto known = std::ranges::find_if(ranges_, [&](const Range& range) {
    return range.axis == axis && std::abs(range.base - way.base) <= slack(way.base);
  });
  Range range{axis, way.base, way.least, way.greatest, way.tool, way.tool, way.least_line, way.greatest_line};
  if (known == ranges_.end()) return range;
  if (known->least <= range.least) {
    range.least = known->least;
    range.least_tool = known->least_tool;
    range.least_line = known->least_line;
  }
  if (known->greatest >= range.greatest) {
    range.greatest = known->greatest;
    range.greatest_tool = known->greatest_tool;
    range.greatest_line = known->greatest_line;
  }
  return range;
}

/// Whether the axis goes further than it can, wherever its zero is.
std::optional<LimitFault> LimitChecks::too_long(const Moves& moves, const Range& range) const {
  const auto room = [this](size_t axis) { return machine_.limits[axis].greatest - machine_.limits[axis].least; };
  const double length = range.greatest - range.least;
  const double most = room(range.axis);
  if (!(length > most + slack(most))) return std::nullopt;
  LimitFault fault;
  fault.line = std::max(range.least_line, range.greatest_line);
  fault.from_line = std::min(range.least_line, range.greatest_line);
  fault.furthest_line = fault.line;
  fault.axis = static_cast<uint8_t>(range.axis);
  fault.kind = moves.kind;
  fault.position = fault.furthest = length;
  fault.limit = most;
  constexpr size_t kZ = 2;
  const Coordinate rotation = moves.place->system.rotation;
  if (range.axis < kZ && !rotation.is_known() && !(length > std::hypot(room(0), room(1))))
    fault.needs = LimitFault::Needs::kNoRotation;
  if (range.least_tool != range.greatest_tool) fault.needs = LimitFault::Needs::kNoOffsets;
  return fault;
}

/// Whether moves go beyond something for the first time.
bool LimitChecks::is_new(const Moves& moves, size_t axis, const MachineWay& way) const {
  for (const bool greatest : {false, true}) {
    const std::optional<LimitFault> beyond = beyond_limit(machine_, moves, axis, way, greatest);
    if (beyond && !is_known(*beyond)) return true;
  }
  const std::optional<LimitFault> length = too_long(moves, widened(axis, way));
  return length && !is_known(*length);
}

void LimitChecks::add(const LimitFault& fault) {
  if (!is_known(fault)) {
    faults_.push_back(fault);
    return;
  }
  for (LimitFault& known : faults_) {
    const bool same =
        known.axis == fault.axis && known.greatest == fault.greatest && known.is_distance() == fault.is_distance();
    if (!same || std::abs(fault.furthest - known.limit) <= std::abs(known.furthest - known.limit)) continue;
    known.furthest = fault.furthest;
    known.furthest_line = fault.furthest_line;
  }
}

void LimitChecks::take(const Moves& moves, size_t axis, const MachineWay& way) {
  constexpr size_t kMostRanges = 64;
  for (const bool greatest : {false, true}) {
    if (const auto beyond = beyond_limit(machine_, moves, axis, way, greatest)) add(*beyond);
  }
  if (way.trust == Trust::kCertain) return;
  const Range range = widened(axis, way);
  const auto known = std::ranges::find_if(
      ranges_, [&](const Range& one) { return one.axis == axis && std::abs(one.base - way.base) <= slack(way.base); });
  if (known != ranges_.end()) {
    *known = range;
  } else if (ranges_.size() < kMostRanges) {
    ranges_.push_back(range);
  }
  if (const auto length = too_long(moves, range)) add(*length);
}

bool LimitChecks::visit(const Moves& moves) {
  bool found = false;
  if (are_several(moves))
    for_limited(machine_, moves,
                [&](size_t axis, const MachineWay& way) { found = found || is_new(moves, axis, way); });
  if (found) return true;
  for_limited(machine_, moves, [&](size_t axis, const MachineWay& way) { take(moves, axis, way); });
  return false;
}

}  // namespace owlint
