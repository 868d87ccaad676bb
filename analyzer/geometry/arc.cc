#include "analyzer/geometry/arc.h"

#include <algorithm>
#include <cmath>

namespace owlint {
namespace {

constexpr double kHundredfold = 100;
constexpr double kThousandth = 0.001;

}  // namespace

CenterArc arc_by_center(Flat start, Flat center, Flat end, const ArcTolerance& tolerance) {
  CenterArc arc{};
  arc.start_radius = distance(center, start);
  arc.end_radius = distance(center, end);
  const double greater = std::max(arc.start_radius, arc.end_radius);
  arc.difference = std::abs(arc.start_radius - arc.end_radius);
  arc.share = arc.difference / greater;
  arc.allowed = std::clamp(kThousandth * greater, tolerance.difference, kHundredfold * tolerance.difference);
  if (arc.start_radius < tolerance.least_radius || arc.end_radius < tolerance.least_radius) {
    arc.fault = ArcFault::kZeroRadius;
  } else if (arc.difference > kHundredfold * tolerance.difference ||
             (arc.share > kThousandth && arc.difference > tolerance.difference)) {
    arc.fault = ArcFault::kRadiiDiffer;
  }
  return arc;
}

bool arc_surely_fits(Flat start, Flat center, Flat end, const ArcTolerance& tolerance) {
  constexpr double kRounding = 1e-12, kWell = 0.99;
  const auto radius_to = [&](Flat point) {
    const double first = center.first - point.first, second = center.second - point.second;
    return std::sqrt(first * first + second * second);
  };
  const double from = radius_to(start), to = radius_to(end);
  return kWell * std::min(from, to) > tolerance.least_radius &&
      std::abs(from - to) + kRounding * (from + to) < kWell * tolerance.difference;
}

RadiusArc arc_by_radius(Flat start, Flat end, double radius, const ArcTolerance& tolerance) {
  const Flat middle{(end.first + start.first) / 2, (end.second + start.second) / 2};
  RadiusArc arc{ArcFault::kNone, distance(middle, end)};
  if (start == end) {
    arc.fault = ArcFault::kSamePoint;
  } else if (arc.least_radius - std::abs(radius) > tolerance.least_radius) {
    arc.fault = ArcFault::kRadiusTooSmall;
  }
  return arc;
}

}  // namespace owlint
