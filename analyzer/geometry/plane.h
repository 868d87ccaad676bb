// Points of a plane, and turns about its origin, with the interpreter's operations in their order: comparisons at a
// tolerance come out as there.
#pragma once

namespace owlint {

struct Flat {
  double first = 0;   ///< along the first axis of the plane: X of XY, Z of ZX, Y of YZ
  double second = 0;  ///< along the second

  bool operator==(const Flat&) const = default;
};

double radians(double degrees);
double distance(Flat a, Flat b);
/// The point behind a turn about the origin, counterclockwise.
Flat turned(Flat point, double degrees);

/// Polar words: a distance from the origin and an angle in degrees, of which either may be null. A missing one stays what it is.
Flat polar(Flat point, const double* radius, const double* angle);
/// The same in incremental distance mode, of one word: the other one stays what it is.
Flat further_out(Flat point, double by);
Flat further_around(Flat point, double by);

}  // namespace owlint
