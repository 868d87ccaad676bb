// A coordinate as far as a program alone tells it: its value on a machine that was just started, and beside it what it is on
// another machine, which began elsewhere. What is the same on both does not depend on where the program starts.
#pragma once

#include <cmath>
#include <limits>

namespace owlint {

struct Coordinate {
  double value = 0;  ///< NaN if it is unknown even on a machine that was just started
  double other = 0;  ///< of an unknown one a count from somewhere, if not NaN, too

  static constexpr Coordinate of(double value) { return {value, value}; }
  static constexpr Coordinate unknown() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone};
  }
  bool is_known() const { return value == other; }
  bool is_unknown() const { return std::isnan(value); }

  bool operator==(const Coordinate& to) const { return same(value, to.value) && same(other, to.other); }

 private:
  static bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }
};

inline Coordinate operator+(Coordinate a, Coordinate b) { return {a.value + b.value, a.other + b.other}; }
inline Coordinate operator-(Coordinate a, Coordinate b) { return {a.value - b.value, a.other - b.other}; }
inline Coordinate operator-(Coordinate a) { return {-a.value, -a.other}; }
inline Coordinate operator*(Coordinate a, double b) { return {a.value * b, a.other * b}; }
inline Coordinate operator/(Coordinate a, double b) { return {a.value / b, a.other / b}; }

}  // namespace owlint
