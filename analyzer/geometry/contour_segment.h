// A piece of a lathe contour as a complex number has it: Z is the real part, X the imaginary one.
#pragma once

#include <array>
#include <complex>
#include <cstdint>

namespace owlint {

using Complex = std::complex<double>;
/// Heights closer than this are the same for the interpreter.
inline constexpr double kSameHeight = 1e-6;

struct ContourSegment {
  enum class Kind : uint8_t { kLine, kClockwise, kCounterclockwise };
  /// Places at one height, the one that is met first comes first.
  struct Crossings {
    std::array<Complex, 2> at{};
    size_t count = 0;

    void add(Complex point) { at[count++] = point; }
    Complex first() const { return at[0]; }
    Complex last() const { return at[count - 1]; }
    bool empty() const { return count == 0; }
  };

  Kind kind = Kind::kLine;
  bool corner = false;  ///< its ends are not known yet, `size_of_corner` is
  double size_of_corner = 0;
  Complex start{}, end{};
  Complex center{};  ///< of an arc

  bool is_line() const { return kind == Kind::kLine; }
  bool is_clockwise() const { return kind == Kind::kClockwise; }
  double radius() const { return std::abs(start - center); }
  /// A line's length; of an arc the smaller one of its chord and its radius.
  double size() const;
  /// An arc whose ends are not equally far from its center.
  bool has_two_radii() const;
  /// Moves it aside: a line to the left of its way back, an arc away from its center or towards it.
  void shift(double by);
  /// Whether it always goes towards smaller Z.
  bool is_monotonic() const;
  Crossings crossings(double height) const;
  void mirror_x();
  void mirror_z();
  /// A quarter turn, so that X becomes Z.
  void turn();

 private:
  bool holds(Complex point) const;
  void reverse_sense();
};

enum class Joint : uint8_t {
  kMade,
  kUnsure,    ///< made, but rounding decides where: two lines lie nearly in one direction, or an arc has two radii
  kParallel,  ///< not made
};
/// Lets `a` end and `b` begin where the two meet.
Joint join_segments(ContourSegment& a, ContourSegment& b);

}  // namespace owlint
