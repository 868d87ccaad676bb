#include "analyzer/geometry/arc_box.h"

#include <algorithm>
#include <cmath>

namespace owlint {
namespace {

double cross(Flat a, Flat b) { return a.first * b.second - a.second * b.first; }
Flat from_center(Flat point, Flat center) { return {point.first - center.first, point.second - center.second}; }

/// Whether a direction lies between two others, counterclockwise.
bool is_between(Flat direction, Flat from, Flat to) {
  const bool wide = cross(from, to) < 0;
  if (wide) return !(cross(to, direction) > 0 && cross(direction, from) > 0);
  return cross(from, direction) >= 0 && cross(direction, to) >= 0;
}

}  // namespace

Flat center_by_radius(Flat start, Flat end, double radius, bool clockwise) {
  const Flat way{end.first - start.first, end.second - start.second};
  const double half = std::hypot(way.first, way.second) / 2;
  const double height = std::sqrt(std::max(radius * radius - half * half, 0.0));
  // To the left of the way, for a counterclockwise arc of at most half a circle.
  const double left = (clockwise == (radius < 0) ? height : -height) / (2 * half);
  return {(start.first + end.first) / 2 - way.second * left, (start.second + end.second) / 2 + way.first * left};
}

ArcBox arc_box(Flat start, Flat center, Flat end, bool clockwise, int turns) {
  ArcBox box{{std::min(start.first, end.first), std::min(start.second, end.second)},
             {std::max(start.first, end.first), std::max(start.second, end.second)}};
  const Flat from = from_center(clockwise ? end : start, center), to = from_center(clockwise ? start : end, center);
  const double radius = std::hypot(from.first, from.second);
  const bool whole = turns > 1 || start == end;
  const auto passes = [&](Flat direction) { return whole || is_between(direction, from, to); };
  if (passes({1, 0})) box.greatest.first = std::max(box.greatest.first, center.first + radius);
  if (passes({0, 1})) box.greatest.second = std::max(box.greatest.second, center.second + radius);
  if (passes({-1, 0})) box.least.first = std::min(box.least.first, center.first - radius);
  if (passes({0, -1})) box.least.second = std::min(box.least.second, center.second - radius);
  return box;
}

}  // namespace owlint
