#include "analyzer/syntax/mode_place.h"

#include <algorithm>
#include <cmath>

#include "analyzer/geometry/arc.h"

namespace owlint {
namespace {

/// What the numbers of the axes are multiplied with; nothing if the units are not known.
std::optional<double> units(const ModeLine& line) {
  const std::optional<uint8_t> units = line.only(Mode::kUnits);
  if (!units) return std::nullopt;
  return *units == modes::kG20 ? kMillimetresInInch : 1;
}

}  // namespace

CheckOutcome places::outcome_of(bool stops, bool other_stops, bool agree, bool unknown) {
  if (agree && stops && other_stops) return CheckOutcome::kStops;
  if (unknown && (!agree || stops != other_stops)) return CheckOutcome::kUnsure;
  return stops ? CheckOutcome::kFromStart : CheckOutcome::kPasses;
}

bool places::agree(double a, double b) {
  constexpr double kRounding = 1e-9;
  return std::abs(a - b) <= kRounding * std::max({1.0, std::abs(a), std::abs(b)});
}

double places::here(Coordinate coordinate) { return coordinate.is_unknown() ? coordinate.other : coordinate.value; }

double places::elsewhere(Coordinate coordinate, size_t axis) {
  constexpr double kFar = 1234.5678;
  constexpr double kFurther = 217.3951;
  if (!coordinate.is_unknown()) return coordinate.other;
  return coordinate.other + kFar + kFurther * static_cast<double>(axis * axis);
}

bool stop_by(ModeLine& line, CheckOutcome outcome, StopKind kind, std::string message, uint8_t word, uint8_t other,
             ModeMask decided_by, std::optional<ArcNumbers> arc) {
  if (outcome == CheckOutcome::kPasses) return false;
  const bool stops = outcome != CheckOutcome::kUnsure;
  if (stops) {
    line.stop(kind, std::move(message), word, other, decided_by);
  } else {
    line.may_stop(kind, std::move(message), word, other, decided_by);
  }
  ModeFault& fault = line.faults()->back();
  fault.by_place = true;
  fault.from_start = outcome == CheckOutcome::kFromStart;
  fault.arc = arc;
  return stops;
}

/// Whether the point is the origin, from where a polar word alone leads nowhere.
CheckOutcome places::at_origin(Coordinate x, Coordinate y) {
  CheckOutcome outcome = CheckOutcome::kStops;
  for (const Coordinate c : {x, y}) {
    if (c.is_unknown()) {
      outcome = std::min(outcome, CheckOutcome::kUnsure);
    } else if (c.value != 0) {
      return CheckOutcome::kPasses;
    } else if (!c.is_known()) {
      outcome = std::min(outcome, CheckOutcome::kFromStart);
    }
  }
  return outcome;
}

/// X is a diameter in G7, also where the line itself sets that.
std::optional<Coordinate> axis_word(const ModeLine& line, size_t axis) {
  const char letter = kAxisOrder[axis];
  if (!line.has(letter)) return std::nullopt;
  const double* const value = line.value(letter);
  if (value == nullptr) return Coordinate::unknown();
  const Answer halved = letter == 'x' ? line.holds({{Mode::kDiameter, value_bit(modes::kG7)}}) : Answer::kNo;
  if (halved == Answer::kMaybe) return Coordinate::unknown();
  return Coordinate::of(halved == Answer::kYes ? *value / 2 : *value);
}

Coordinate from_machine(const ModeLine& line, Coordinate value, size_t axis) {
  if (!is_length(axis)) return value;
  const std::optional<double> unit = units(line);
  return unit ? value / line.machine().units_per_mm / *unit : Coordinate::unknown();
}

Coordinate to_machine(const ModeLine& line, Coordinate value, size_t axis) {
  if (!is_length(axis)) return value;
  const std::optional<double> unit = units(line);
  return unit ? value * *unit * line.machine().units_per_mm : Coordinate::unknown();
}

Point from_machine(const ModeLine& line, const Point& point) {
  Point converted;
  for (size_t i = 0; i < kAxisCount; ++i) converted[i] = from_machine(line, point[i], i);
  return converted;
}

}  // namespace owlint
