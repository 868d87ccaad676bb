#include "analyzer/geometry/arc_check.h"

#include <algorithm>
#include <cmath>

namespace owlint {
namespace {

std::string radii(PlanePoint start, const ArcUnits& units, const ArcEntry& arc, double from_start, double from_end) {
  auto [first, second] = units.axes;
  return printed("start=(%c%.4f,%c%.4f) center=(%c%.4f,%c%.4f) end=(%c%.4f,%c%.4f) r1=%.4f r2=%.4f", first, start.first,
                 second, start.second, first, arc.center.first, second, arc.center.second, first, arc.end.first, second,
                 arc.end.second, from_start, from_end);
}

bool check_center(PlanePoint start, const ArcUnits& units, const ArcEntry& arc, PathStep& step) {
  double from_start = length(arc.center - start);
  double from_end = length(arc.center - arc.end);
  if (from_start < units.least_radius() || from_end < units.least_radius())
    return step.stop(PathFault::kZeroRadius, "Zero-radius arc: " + radii(start, units, arc, from_start, from_end));
  double difference = std::fabs(from_start - from_end);
  double share = difference / std::max(from_start, from_end);
  if (difference > arc.spread * 100 || (share > 0.001 && difference > arc.spread))
    return step.stop(
        PathFault::kRadiiDiffer,
        "Radius to end of arc differs from radius to start: " + radii(start, units, arc, from_start, from_end) +
            printed(" abs_err=%.4g rel_err=%.4f%%", difference, share * 100));
  return true;
}

bool find_center(PlanePoint start, const ArcUnits& units, ArcEntry& arc, PathStep& step) {
  if (arc.end == start) return step.stop(PathFault::kSamePoint, "Current point same as end point of arc");
  PlanePoint middle = {(arc.end.first + start.first) / 2, (arc.end.second + start.second) / 2};
  double half = length(middle - arc.end);
  double radius = std::fabs(arc.radius);
  if (half - radius > units.least_radius())
    return step.stop(PathFault::kRadiusTooSmall, "Arc radius too small to reach end point");
  if (half / radius > 1 - 1e-12) half = radius;  // half a circle, but for rounding
  bool right = (arc.turns < 0) == (arc.radius > 0);
  double direction = angle(arc.end - start);
  direction = right ? rounded(direction - kHalfPi) : rounded(direction + kHalfPi);
  arc.center = around(middle, radius * std::cos(std::asin(half / radius)), direction);
  return true;
}

}  // namespace

bool arc_check(PlanePoint start, const ArcUnits& units, ArcEntry& arc, PathStep& step) {
  return arc.by_radius ? find_center(start, units, arc, step) : check_center(start, units, arc, step);
}

}  // namespace owlint
