#include "analyzer/syntax/place.h"

#include <cmath>

#include "analyzer/geometry/plane.h"

namespace owlint {
namespace {

/// Numbers of the other machine: none has a relation to another.
class Odd {
 public:
  Coordinate next() {
    constexpr double kStep = 37.4142135623;
    constexpr double kTurn = 971.0344;
    last_ += kStep;
    if (last_ > kTurn) last_ -= kTurn;
    return {0, last_};
  }
  Point point() {
    Point odd;
    for (Coordinate& axis : odd.axes) axis = next();
    return odd;
  }

 private:
  double last_ = 11.7320508;
};

Coordinate join(Coordinate a, Coordinate b) { return a == b ? a : Coordinate::unknown(); }

Point join(const Point& a, const Point& b) {
  Point both;
  for (size_t i = 0; i < kAxisCount; ++i) both[i] = join(a[i], b[i]);
  return both;
}

CoordinateSystem join(const CoordinateSystem& a, const CoordinateSystem& b) {
  return {join(a.origin, b.origin), join(a.rotation, b.rotation)};
}

/// What is not turned, or is the origin, stays there, though another number is unknown.
Flat turned_by(double x, double y, double degrees) {
  const bool unknown = std::isnan(x) || std::isnan(y) || std::isnan(degrees);
  if (unknown && (degrees == 0 || (x == 0 && y == 0))) return {x, y};
  return turned({x, y}, degrees);
}

Point in_millimetres(Point point, double units_per_mm) {
  for (size_t i = 0; i < kAxisCount; ++i) {
    if (is_length(i)) point[i] = point[i] / units_per_mm;
  }
  return point;
}

void settle_one(Coordinate& coordinate) {
  if (coordinate.is_unknown() && std::isnan(coordinate.other)) coordinate.other = 0;
}

}  // namespace

Point Point::turned(Coordinate degrees) const {
  const Coordinate x = (*this)[Axis::kX], y = (*this)[Axis::kY];
  const Flat here = turned_by(x.value, y.value, degrees.value);
  const Flat there = turned_by(x.other, y.other, degrees.other);
  Point point = *this;
  point[Axis::kX] = {here.first, there.first};
  point[Axis::kY] = {here.second, there.second};
  return point;
}

Point Point::unknown() {
  Point point;
  point.axes.fill(Coordinate::unknown());
  return point;
}

Point operator+(const Point& a, const Point& b) {
  Point sum;
  for (size_t i = 0; i < kAxisCount; ++i) sum[i] = a[i] + b[i];
  return sum;
}

Point operator-(const Point& a, const Point& b) {
  Point difference;
  for (size_t i = 0; i < kAxisCount; ++i) difference[i] = a[i] - b[i];
  return difference;
}

void Place::ask_machine(bool may_move) {
  Odd odd;
  const bool turned = system.rotation.value != 0;  // also where that is unknown
  for (size_t i = 0; i < kAxisCount; ++i) {
    at[i].value += tool[i].value;
    if (turned && i <= static_cast<size_t>(Axis::kY)) at[i].value = Coordinate::unknown().value;
    if (may_move) at[i].other += odd.next().other;
  }
  lose_path();
  settle();
}

void Place::lose_point() {
  at = Point::unknown();
  lose_path();
  settle();
}

void Place::lose_offsets() {
  system = {Point::unknown(), Coordinate::unknown()};
  offset = tool = Point::unknown();
  lose_point();
}

void Place::write_parameter(int32_t number, Coordinate value) {
  constexpr int32_t kHome = 5161, kHome30 = 5181, kHasOffset = 5210, kOffset = 5211, kFirstSystem = 5221;
  constexpr int32_t kPerSystem = 20;
  const auto write = [&](Point& point, int32_t first) {
    const int32_t axis = number - first;
    if (axis >= 0 && axis < static_cast<int32_t>(kAxisCount)) point[static_cast<size_t>(axis)] = value;
  };
  write(home, kHome);
  write(home30, kHome30);
  write(stored_offset, kOffset);
  if (number == kHasOffset)
    has_offset = value.is_known() ? Coordinate::of(value.value != 0 ? 1 : 0) : Coordinate::unknown();
  for (size_t i = 0; i < kSystemCount; ++i) {
    const int32_t first = kFirstSystem + kPerSystem * static_cast<int32_t>(i);
    write(systems[i].origin, first);
    if (number == first + static_cast<int32_t>(kAxisCount)) systems[i].rotation = value;
  }
}

void Place::lose_parameters() {
  systems.fill({Point::unknown(), Coordinate::unknown()});
  stored_offset = home = home30 = Point::unknown();
  has_offset = Coordinate::unknown();
}

void Place::settle() {
  for (Coordinate& axis : at.axes) settle_one(axis);
  settle_one(height);
}

Place Place::started(double units_per_mm) {
  Odd odd;
  Place place;
  place.at = odd.point();
  place.stored_offset = odd.point();
  place.offset = in_millimetres(place.stored_offset, units_per_mm);
  place.tool = odd.point();
  for (CoordinateSystem& system : place.systems) system = {odd.point(), odd.next()};
  place.system = {in_millimetres(place.systems.front().origin, units_per_mm), place.systems.front().rotation};
  place.has_offset.other = 1;
  place.home = odd.point();
  place.home30 = odd.point();
  return place;
}

Place Place::unknown() {
  Place place;
  place.lose_offsets();
  place.lose_parameters();
  place.clearance = place.bottom = place.height = Coordinate::unknown();
  place.curve_x = place.curve_y = Coordinate::unknown();
  place.keeps_height = place.tools_changed = true;
  place.settle();
  return place;
}

Place join(const Place& a, const Place& b) {
  Place both;
  both.at = join(a.at, b.at);
  both.system = join(a.system, b.system);
  both.offset = join(a.offset, b.offset);
  both.tool = join(a.tool, b.tool);
  for (size_t i = 0; i < kSystemCount; ++i) both.systems[i] = join(a.systems[i], b.systems[i]);
  both.stored_offset = join(a.stored_offset, b.stored_offset);
  both.has_offset = join(a.has_offset, b.has_offset);
  both.home = join(a.home, b.home);
  both.home30 = join(a.home30, b.home30);
  both.clearance = join(a.clearance, b.clearance);
  both.bottom = join(a.bottom, b.bottom);
  both.keeps_height = a.keeps_height || b.keeps_height;
  both.height = a.keeps_height == b.keeps_height ? join(a.height, b.height) : Coordinate::unknown();
  both.tools_changed = a.tools_changed || b.tools_changed;
  if (a.chosen_tool == b.chosen_tool) both.chosen_tool = a.chosen_tool;
  if (a.loaded_tool == b.loaded_tool) both.loaded_tool = a.loaded_tool;
  both.curve_x = join(a.curve_x, b.curve_x);
  both.curve_y = join(a.curve_y, b.curve_y);
  if (a.path == b.path) both.path = a.path;
  both.path_from_start = a.path_from_start || b.path_from_start;
  both.settle();
  return both;
}

}  // namespace owlint
