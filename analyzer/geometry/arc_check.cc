#include "analyzer/geometry/arc_check.h"

#include <cmath>

#include "analyzer/geometry/arc.h"

namespace owlint {
namespace {

Flat flat(PlanePoint point) { return {point.first, point.second}; }

std::string radii(PlanePoint start, const ArcUnits& units, const ArcEntry& arc, const CenterArc& found) {
  auto [first, second] = units.axes;
  return printed("start=(%c%.4f,%c%.4f) center=(%c%.4f,%c%.4f) end=(%c%.4f,%c%.4f) r1=%.4f r2=%.4f", first, start.first,
                 second, start.second, first, arc.center.first, second, arc.center.second, first, arc.end.first, second,
                 arc.end.second, found.start_radius, found.end_radius);
}

bool check_center(PlanePoint start, const ArcUnits& units, const ArcEntry& arc, PathStep& step) {
  const CenterArc found =
      arc_by_center(flat(start), flat(arc.center), flat(arc.end), arc_tolerance(units.inch, arc.spread));
  if (found.fault == ArcFault::kZeroRadius)
    return step.stop(PathFault::kZeroRadius, "Zero-radius arc: " + radii(start, units, arc, found));
  if (found.fault == ArcFault::kRadiiDiffer)
    return step.stop(PathFault::kRadiiDiffer,
                     "Radius to end of arc differs from radius to start: " + radii(start, units, arc, found) +
                         printed(" abs_err=%.4g rel_err=%.4f%%", found.difference, found.share * 100));
  return true;
}

bool find_center(PlanePoint start, const ArcUnits& units, ArcEntry& arc, PathStep& step) {
  const RadiusArc found = arc_by_radius(flat(start), flat(arc.end), arc.radius, arc_tolerance(units.inch, arc.spread));
  if (found.fault == ArcFault::kSamePoint)
    return step.stop(PathFault::kSamePoint, "Current point same as end point of arc");
  if (found.fault == ArcFault::kRadiusTooSmall)
    return step.stop(PathFault::kRadiusTooSmall, "Arc radius too small to reach end point");
  PlanePoint middle = {(arc.end.first + start.first) / 2, (arc.end.second + start.second) / 2};
  double half = found.least_radius;
  double radius = std::fabs(arc.radius);
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
