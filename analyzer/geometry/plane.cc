#include "analyzer/geometry/plane.h"

#include <cmath>
#include <numbers>

namespace owlint {
namespace {

Flat at_angle(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }
double from_origin(Flat point) { return std::hypot(point.second, point.first); }
double angle_of(Flat point) { return std::atan2(point.second, point.first); }

}  // namespace

double radians(double degrees) {
  constexpr double kPerDegree = std::numbers::pi / 180;
  return degrees * kPerDegree;
}

double distance(Flat a, Flat b) { return std::hypot(a.first - b.first, a.second - b.second); }

Flat turned(Flat point, double degrees) {
  const double angle = radians(degrees);
  const double c = std::cos(angle), s = std::sin(angle);
  return {point.first * c - point.second * s, point.first * s + point.second * c};
}

Flat polar(Flat point, const double* radius, const double* angle) {
  return at_angle(radius != nullptr ? *radius : from_origin(point),
                  angle != nullptr ? radians(*angle) : angle_of(point));
}

Flat further_out(Flat point, double by) { return at_angle(from_origin(point) + by, angle_of(point)); }

Flat further_around(Flat point, double by) { return at_angle(from_origin(point), angle_of(point) + radians(by)); }

}  // namespace owlint
