// Points of the plane of arcs, and the interpreter's own arithmetic with angles. The verdict on a corner may hang on the last bit
// of a sum, so the order of operations and their precision are those that were measured, here and in all files of this room.
#pragma once

#include <cmath>
#include <numbers>

namespace owlint {

/// In the order of the plane: X and Y in G17, Z and X in G18.
struct PlanePoint {
  double first = 0;
  double second = 0;

  bool operator==(const PlanePoint&) const = default;
};

inline PlanePoint operator-(PlanePoint to, PlanePoint from) { return {to.first - from.first, to.second - from.second}; }
inline double length(PlanePoint vector) { return std::hypot(vector.first, vector.second); }
inline double angle(PlanePoint vector) { return std::atan2(vector.second, vector.first); }

/// The point at this distance from `centre`.
inline PlanePoint around(PlanePoint centre, double distance, double angle) {
  return {centre.first + distance * std::cos(angle), centre.second + distance * std::sin(angle)};
}

/// The interpreter adds multiples of π to angles in extended precision, where the machine has it, and rounds the sum once.
inline constexpr long double kPi = std::numbers::pi_v<long double>;
inline constexpr long double kHalfPi = kPi / 2;
inline constexpr long double kTwoPi = 2 * kPi;
inline double rounded(long double sum) { return static_cast<double>(sum); }

}  // namespace owlint
