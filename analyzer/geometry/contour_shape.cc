#include "analyzer/geometry/contour_shape.h"

#include <algorithm>
#include <cmath>

namespace owlint {
namespace {

constexpr double kLeastSegment = 0.001;
constexpr double kGap = 0.01;
/// Segments that are looked at while a shape moves aside.
constexpr size_t kMostSegments = 1'000'000;
constexpr const char* kNotMonotonic = "G7X error: Not monotonic";
constexpr const char* kParallel = "G7X error: Cannot intersect parallel lines";

Complex complex(PlanePoint point) { return {point.first, point.second}; }

ContourOutcome stopped(const char* message) { return {ContourEnd::kStops, message}; }
constexpr ContourOutcome kCrash{ContourEnd::kCrashes};
bool goes_on(const ContourOutcome& outcome) { return outcome.end == ContourEnd::kDone; }

bool is_tiny(const ContourSegment& segment) { return segment.size() < kLeastSegment; }

/// Of an arc by its radius; no number if that is too small.
Complex center_by_radius(Complex start, Complex end, double radius, bool clockwise) {
  const Complex way = end - start;
  const double square = std::norm(way);
  const Complex aside = Complex(0, 1) * std::sqrt((radius * radius - square / 4) / square) * way;
  const Complex middle = (start + end) / 2.0;
  return clockwise ? middle - aside : middle + aside;
}

bool all_monotonic(std::span<const ContourSegment> segments) {
  return std::ranges::all_of(segments,
                             [](const ContourSegment& segment) { return segment.corner || segment.is_monotonic(); });
}

}  // namespace

ContourShape::ContourShape(std::span<const ContourElement> elements) {
  segments_.reserve(elements.size() + 1);
  for (const ContourElement& element : elements) add(element);
}

void ContourShape::add(const ContourElement& element) {
  using Kind = ContourElement::Kind;
  ContourSegment segment;
  segment.corner = element.kind == Kind::kFillet || element.kind == Kind::kChamfer;
  segment.start = complex(element.start);
  segment.end = complex(element.end);
  const bool clockwise = element.kind == Kind::kClockwise;
  if (clockwise) segment.kind = ContourSegment::Kind::kClockwise;
  if (element.kind == Kind::kCounterclockwise || element.kind == Kind::kFillet)
    segment.kind = ContourSegment::Kind::kCounterclockwise;
  if (segment.corner) {
    segment.center = segment.start;
    segment.size_of_corner = element.size;
  } else if (!segment.is_line()) {
    segment.center = element.by_radius ? center_by_radius(segment.start, segment.end, element.size, clockwise)
                                       : complex(element.center);
  }
  segments_.push_back(segment);
}

PlanePoint ContourShape::on_machine(Complex point) const {
  if (mirrored_z_) point = -std::conj(point);
  if (mirrored_x_) point = std::conj(point);
  if (turned_) point = Complex(-point.imag(), point.real());
  return {point.real(), point.imag()};
}

void ContourShape::turn() {
  for (ContourSegment& segment : segments_) segment.turn();
  turned_ = true;
}

void ContourShape::mirror() {
  const Complex back = segments_.front().end - segments_.back().end;
  mirrored_x_ = back.imag() > 0;
  mirrored_z_ = back.real() < 0;
  for (ContourSegment& segment : segments_) {
    if (mirrored_x_) segment.mirror_x();
    if (mirrored_z_) segment.mirror_z();
  }
}

ContourOutcome ContourShape::prepare(const ContourWords& words) {
  if (words.facing) turn();
  if (words.cut == ContourWords::Cut::kFinish && !passes_without_first()) {
    turn();
    if (!passes_without_first()) return stopped(kNotMonotonic);
  }
  mirror();
  if (const ContourOutcome made = make_corners(); !goes_on(made)) return made;
  std::erase_if(segments_, is_tiny);
  if (segments_.empty()) return kCrash;
  move_start();
  return all_monotonic(segments_) ? ContourOutcome{} : stopped(kNotMonotonic);
}

/// Whether what is finished goes towards smaller Z. Only once it is turned its start may be moved for that (measured).
bool ContourShape::passes_without_first() const {
  ContourShape rest = *this;
  rest.segments_.erase(rest.segments_.begin());
  rest.mirror();
  if (turned_) rest.move_start();
  return all_monotonic(rest.segments_);
}

/// The start is never to the left of where the first segment ends.
void ContourShape::move_start() {
  ContourSegment& first = segments_.front();
  if (first.end.real() > first.start.real()) first.start.real(first.end.real());
}

ContourOutcome ContourShape::make_corners() {
  for (size_t i = 1; i + 1 < segments_.size(); ++i) {
    if (!segments_[i].corner) continue;
    if (const ContourOutcome made = make_corner(i); !goes_on(made)) return made;
  }
  return {};
}

ContourOutcome ContourShape::make_corner(size_t at) {
  ContourSegment& corner = segments_[at];
  ContourSegment &before = segments_[at - 1], &behind = segments_[at + 1];
  double aside = corner.size_of_corner;
  ContourSegment a = before, b = behind;
  a.shift(aside);
  b.shift(aside);
  if (a.end.real() - b.start.real() > kGap) {
    aside = -aside;
    a = before;
    b = behind;
    a.shift(aside);
    b.shift(aside);
  }
  if (!join(a, b)) return stopped(kParallel);
  corner.center = a.end;
  a.shift(-aside);
  b.shift(-aside);
  before.end = corner.start = a.end;
  behind.start = corner.end = b.start;
  if (!corner.is_line()) {
    const double top = corner.center.imag();
    const bool above = corner.start.imag() > top || corner.end.imag() > top;
    corner.kind = above ? ContourSegment::Kind::kCounterclockwise : ContourSegment::Kind::kClockwise;
  }
  corner.corner = false;
  return {};
}

bool ContourShape::join(ContourSegment& a, ContourSegment& b) {
  const Joint joint = join_segments(a, b);
  unsure_ = unsure_ || joint == Joint::kUnsure;
  return joint != Joint::kParallel;
}

ContourOutcome ContourShape::shift(double distance) {
  const Complex first_way = segments_.front().end - segments_.front().start;
  const Complex whole_way = segments_.back().start - segments_.front().start;
  const double sign = (first_way / whole_way).imag() < 0 ? -1 : 1;
  ContourSegment first = segments_.front();
  segments_.erase(segments_.begin());
  size_t work = 0;
  for (double done = 0; done < distance;) {
    if (segments_.empty()) return kCrash;
    work += segments_.size();
    if (work > kMostSegments) return {ContourEnd::kTooLong};
    double least = std::ranges::min_element(segments_, {}, &ContourSegment::size)->size();
    const double step = std::min(distance - done, least / 2);
    if (const ContourOutcome moved = shift_step(sign * step); !goes_on(moved)) return moved;
    done += step;
  }
  for (size_t i = 0; i + 1 < segments_.size(); ++i) {
    const Complex middle = (segments_[i].end + segments_[i + 1].start) / 2.0;
    segments_[i].end = segments_[i + 1].start = middle;
  }
  if (segments_.empty()) return kCrash;
  first.end = segments_.front().start;
  segments_.insert(segments_.begin(), first);
  return {};
}

ContourOutcome ContourShape::shift_step(double by) {
  std::vector<ContourSegment> shifted;
  shifted.reserve(segments_.size());
  std::vector<Complex> corners;  // behind each that is left
  for (size_t i = 0; i < segments_.size(); ++i) {
    ContourSegment segment = segments_[i];
    const Complex corner = i + 1 < segments_.size() ? (segment.end + segments_[i + 1].start) / 2.0 : segment.end;
    segment.shift(by);
    if (is_tiny(segment)) continue;
    shifted.push_back(segment);
    corners.push_back(corner);
  }
  segments_ = std::move(shifted);
  close_gaps(corners, by > 0);
  return join_all();
}

/// Where two segments have moved away from each other an arc about their corner comes between them.
void ContourShape::close_gaps(const std::vector<Complex>& corners, bool outwards) {
  std::vector<ContourSegment> closed;
  for (size_t i = 0; i < segments_.size(); ++i) {
    closed.push_back(segments_[i]);
    if (i + 1 == segments_.size()) break;
    const Complex from = segments_[i].end, to = segments_[i + 1].start;
    if (from.real() - to.real() <= kGap) continue;
    ContourSegment arc;
    arc.kind = outwards ? ContourSegment::Kind::kCounterclockwise : ContourSegment::Kind::kClockwise;
    arc.start = from;
    arc.end = to;
    arc.center = corners[i];
    closed.push_back(arc);
  }
  segments_ = std::move(closed);
}

ContourOutcome ContourShape::join_all() {
  size_t work = 0;
  for (size_t i = 0; i < segments_.size();) {
    if (++work > kMostSegments) return {ContourEnd::kTooLong};
    ContourSegment& segment = segments_[i];
    const auto at = segments_.begin() + static_cast<ptrdiff_t>(i);
    if (!segment.is_monotonic()) {
      if (i == 0) return kCrash;
      segments_.erase(segment.size() < segments_[i - 1].size() ? at : at - 1);
      i = 0;
    } else if (is_tiny(segment)) {
      segments_.erase(at);
      i = 0;
    } else {
      if (i + 1 < segments_.size() && !join(segment, segments_[i + 1])) return stopped(kParallel);
      ++i;
    }
  }
  return {};
}

void ContourShape::close() {
  const double top = segments_.front().start.imag();
  const Complex last = segments_.back().end;
  if (last.imag() >= top) return;
  ContourSegment line;
  line.start = last;
  line.end = Complex(last.real(), top);
  segments_.push_back(line);
}

}  // namespace owlint
