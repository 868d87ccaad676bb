#include "analyzer/geometry/contour_segment.h"

#include <algorithm>
#include <cmath>

namespace owlint {
namespace {

constexpr double kMonotonicSlack = 0.001;
constexpr Complex kI{0, 1};

double cross_product(Complex a, Complex b) { return (std::conj(a) * b).imag(); }

/// Seen from the end of `b`, along it: so rounding decides as in the interpreter whether two lines are parallel.
Joint join_lines(ContourSegment& a, ContourSegment& b) {
  const Complex back = b.start - b.end;
  const Complex along = std::conj(back) / std::abs(back);
  const Complex start = (a.start - b.end) * along, end = (a.end - b.end) * along;
  const double fall = (start - end).imag();
  if (fall == 0) return Joint::kParallel;
  const Complex at = start + (end - start) * (start.imag() / fall);
  a.end = b.start = at / along + b.end;
  constexpr double kNearlyParallel = 1e-9;
  return std::abs(fall) < kNearlyParallel * std::abs(end - start) ? Joint::kUnsure : Joint::kMade;
}

void join_line_and_arc(ContourSegment& a, ContourSegment& b) {
  if (std::abs(a.end - b.start) < kSameHeight) return;
  const ContourSegment& line = a.is_line() ? a : b;
  const ContourSegment& arc = a.is_line() ? b : a;
  const Complex along = (line.end - line.start) / std::abs(line.end - line.start);
  const Complex to_center = (arc.center - line.start) * std::conj(along);
  const double radius = std::abs(arc.end - arc.center);
  const double half = std::sqrt(std::max(0.0, radius * radius - to_center.imag() * to_center.imag()));
  const Complex one = line.start + (to_center.real() - half) * along;
  const Complex other = line.start + (to_center.real() + half) * along;
  const Complex at = std::abs(one - b.start) < std::abs(other - b.start) ? one : other;
  a.end = b.start = at;
}

void join_arcs(ContourSegment& a, ContourSegment& b) {
  const double ra = a.radius(), rb = b.radius();
  const Complex between = a.center - b.center;
  const double way = std::abs(between);
  const double k = (way * way + rb * rb - ra * ra) / (2 * rb * way);
  const double square = std::min(k * k, 1.0);
  a.end = b.start = b.center + Complex(k, std::sqrt(1 - square)) * rb * between / way;
}

}  // namespace

double ContourSegment::size() const {
  const double chord = std::abs(start - end);
  return is_line() ? chord : std::min(chord, radius());
}

bool ContourSegment::has_two_radii() const {
  constexpr double kFarApart = 0.01;
  return !is_line() && std::abs(radius() - std::abs(end - center)) > kFarApart;
}

void ContourSegment::shift(double by) {
  if (is_line()) {
    const Complex aside = by * kI * (start - end) / std::abs(start - end);
    start += aside;
    end += aside;
    return;
  }
  const double share = (radius() + (is_clockwise() ? -by : by)) / radius();
  start = center + (start - center) * share;
  end = center + (end - center) * share;
}

bool ContourSegment::is_monotonic() const {
  const double way = (end - start).real();
  if (is_line()) return way <= kMonotonicSlack;
  if (!(way <= -kMonotonicSlack)) return false;
  const double from = (start - center).imag(), to = (end - center).imag();
  return is_clockwise() ? from <= kMonotonicSlack && to <= kMonotonicSlack
                        : from >= -kMonotonicSlack && to >= -kMonotonicSlack;
}

bool ContourSegment::holds(Complex point) const {
  const double behind_start = cross_product(start - center, point - center);
  const double behind_end = cross_product(end - center, point - center);
  return is_clockwise() ? behind_start <= kSameHeight && behind_end >= -kSameHeight
                        : behind_start >= -kSameHeight && behind_end <= kSameHeight;
}

ContourSegment::Crossings ContourSegment::crossings(double height) const {
  Crossings found;
  if (is_line()) {
    const double low = std::min(start.imag(), end.imag()), high = std::max(start.imag(), end.imag());
    if (height < low - kSameHeight || height > high + kSameHeight) return found;
    if (high - low < kSameHeight) {
      found.add(start);
      found.add(end);
    } else {
      found.add(start + (end - start) * ((height - start.imag()) / (end.imag() - start.imag())));
    }
    return found;
  }
  const double radius = this->radius();
  const double square = (radius - height + center.imag()) * (radius + height - center.imag());
  if (!(square >= -kSameHeight)) return found;
  const double half = std::sqrt(std::max(square, 0.0));
  for (const double z : {center.real() + half, center.real() - half}) {
    const Complex point(z, height);
    if (holds(point)) found.add(point);
  }
  return found;
}

void ContourSegment::reverse_sense() {
  if (!is_line()) kind = is_clockwise() ? Kind::kCounterclockwise : Kind::kClockwise;
}

void ContourSegment::mirror_x() {
  for (Complex* const point : {&start, &end, &center}) *point = std::conj(*point);
  reverse_sense();
}

void ContourSegment::mirror_z() {
  for (Complex* const point : {&start, &end, &center}) *point = -std::conj(*point);
  reverse_sense();
}

void ContourSegment::turn() {
  for (Complex* const point : {&start, &end, &center}) *point = Complex(point->imag(), -point->real());
}

Joint join_segments(ContourSegment& a, ContourSegment& b) {
  if (a.is_line() && b.is_line()) return join_lines(a, b);
  const bool unsure = a.has_two_radii() || b.has_two_radii();
  if (a.is_line() || b.is_line()) {
    join_line_and_arc(a, b);
  } else {
    join_arcs(a, b);
  }
  return unsure ? Joint::kUnsure : Joint::kMade;
}

}  // namespace owlint
