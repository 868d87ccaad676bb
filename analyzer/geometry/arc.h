// Whether the numbers of an arc make one: by its center, both ends have to be as far from it; by its radius, the radius has
// to reach both ends. Source: measured with rs274, to the last bit.
#pragma once

#include <cstdint>

#include "analyzer/geometry/plane.h"

namespace owlint {

inline constexpr double kMillimetresInInch = 25.4;

enum class ArcFault : uint8_t {
  kNone,
  kZeroRadius,      ///< the center is one of the ends
  kRadiiDiffer,     ///< the ends are not as far from the center
  kSamePoint,       ///< by radius, and the ends are one point
  kRadiusTooSmall,  ///< the radius does not reach the end
};

struct ArcTolerance {
  double least_radius;  ///< also what a radius may lack to reach the ends
  double difference;    ///< of the radii; a hundredfold one if it is within a thousandth of them
};

/// Of the units in effect; `difference` is set by the machine.
constexpr ArcTolerance arc_tolerance(bool inch, double difference) {
  constexpr double kInches = 0.00005;
  return {inch ? kInches : kInches * kMillimetresInInch, difference};
}

struct CenterArc {
  ArcFault fault;
  double start_radius, end_radius;
  double difference;  ///< of the two
  double share;       ///< the same as a part of the greater one
  double allowed;     ///< the difference that would pass
};
CenterArc arc_by_center(Flat start, Flat center, Flat end, const ArcTolerance& tolerance);
/// Whether it has no fault, by more than what sums round: nearly every arc has none, and this is sooner found.
bool arc_surely_fits(Flat start, Flat center, Flat end, const ArcTolerance& tolerance);

struct RadiusArc {
  ArcFault fault;
  double least_radius;  ///< that reaches both ends: half the distance between them
};
RadiusArc arc_by_radius(Flat start, Flat end, double radius, const ArcTolerance& tolerance);

}  // namespace owlint
