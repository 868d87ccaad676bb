#include "analyzer/geometry/contour.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analyzer/geometry/contour_shape.h"

namespace owlint {
namespace {

/// Moves that are followed, and segments that are looked at for them.
constexpr size_t kMostMoves = 100'000;
constexpr size_t kMostWork = 10'000'000;
constexpr int kMostPasses = 1000;
/// People write a few dozen.
constexpr size_t kMostElements = 10'000;

/// Sends moves to the machine.
class Tool {
 public:
  Tool(const ContourShape& shape, ContourMoves& moves) : shape_(shape), moves_(moves) {}

  bool rapid(Complex to) { return move({ContourMove::Kind::kRapid, shape_.on_machine(to), {}}); }
  bool feed(Complex to) { return move({ContourMove::Kind::kFeed, shape_.on_machine(to), {}}); }
  /// Along a segment from `from` to `to`, both on it.
  bool along(const ContourSegment& segment, Complex from, Complex to) {
    if (segment.is_line()) return feed(to);
    constexpr double kLeftOut = 0.0001;
    const Complex way = to - from;
    if (std::abs(way.real()) < kLeftOut && std::abs(way.imag()) < kLeftOut) return true;
    const bool clockwise = segment.is_clockwise() != shape_.is_mirrored();
    return move({clockwise ? ContourMove::Kind::kClockwise : ContourMove::Kind::kCounterclockwise,
                 shape_.on_machine(to), shape_.on_machine(segment.center)});
  }
  ContourOutcome refused(bool unsure = false) const {
    return {count_ > kMostMoves ? ContourEnd::kTooLong : ContourEnd::kRefused, nullptr, unsure};
  }

 private:
  bool move(const ContourMove& move) { return ++count_ <= kMostMoves && moves_.move(move); }

  const ContourShape& shape_;
  ContourMoves& moves_;
  size_t count_ = 0;
};

/// Layer by layer, down into the shape.
class Layers {
 public:
  Layers(const ContourShape& shape, const ContourWords& words, ContourMoves& moves)
      : segments_(shape.segments()),
        words_(words),
        tool_(shape, moves),
        at_(segments_.front().start),
        height_(at_.imag()),
        layer_(std::max(words.i, 2 * kSameHeight)),
        rims_{height_} {}

  ContourOutcome cut();

 private:
  enum class Went : uint8_t { kOn, kUp, kStopped };
  Went stop(const char* message) {
    outcome_ = {ContourEnd::kStops, message};
    return Went::kStopped;
  }
  /// What a move comes to.
  Went moved(bool moved) {
    if (moved) return Went::kOn;
    outcome_ = tool_.refused();
    return Went::kStopped;
  }
  Went go(const ContourSegment& segment, Complex to) {
    const Went went = moved(tool_.along(segment, at_, to));
    at_ = to;
    return went;
  }
  /// The first segment leads to the part.
  bool in_the_air() const { return segment_ == 0; }
  Went go_down(const ContourSegment& line, Complex to) {
    if (!in_the_air()) return go(line, to);
    at_ = to;
    return moved(tool_.rapid(to));
  }
  bool lower();
  bool is_too_much(size_t work);
  Went dive(const ContourSegment& segment);
  Went dive_along_arc(const ContourSegment& segment);
  Went climb(const ContourSegment& segment, bool whole);
  Went climb_out();
  Went climb_along_rest();
  Went cut_layer();
  Went cut_to(Complex point);

  const std::vector<ContourSegment>& segments_;
  const ContourWords& words_;
  Tool tool_;
  Complex at_;
  double height_;
  double layer_;
  size_t segment_ = 0;
  size_t work_ = 0;
  std::vector<double> rims_;
  ContourOutcome outcome_{};
};

bool Layers::lower() {
  while (height_ > at_.imag() + kSameHeight) {
    const double before = height_;
    height_ -= layer_;
    if (height_ == before) {
      outcome_ = {ContourEnd::kNeverEnds};
      return false;
    }
    if (is_too_much(1)) return false;
  }
  return true;
}

bool Layers::is_too_much(size_t work) {
  work_ += work;
  if (work_ <= kMostWork) return false;
  outcome_ = {ContourEnd::kTooLong};
  return true;
}

Layers::Went Layers::dive(const ContourSegment& segment) {
  if (!segment.is_line()) return dive_along_arc(segment);
  if (!(segment.start.imag() - segment.end.imag() > kSameHeight)) return Went::kUp;
  if (height_ < segment.end.imag()) return go_down(segment, segment.end);
  const auto crossings = segment.crossings(height_);
  if (crossings.empty()) return stop("G7X error: x too large in straight dive");
  return go_down(segment, crossings.first());
}

Layers::Went Layers::dive_along_arc(const ContourSegment& segment) {
  if (at_.real() - segment.end.real() <= kSameHeight) {
    at_ = segment.end;
    return Went::kOn;
  }
  auto crossings = segment.crossings(height_);
  if (crossings.empty()) crossings = segment.crossings(height_ - kSameHeight);
  const double middle = segment.center.real();
  if (segment.is_clockwise()) {
    if (at_.real() <= middle) return Went::kUp;
    if (crossings.empty()) return go(segment, segment.end);
    if (crossings.first().real() < middle) return Went::kOn;
    return go(segment, crossings.first());
  }
  if (at_.real() - kSameHeight > middle) return Went::kUp;
  if (crossings.empty() || crossings.last().real() > middle) return go(segment, segment.end);
  return go(segment, crossings.last());
}

Layers::Went Layers::climb(const ContourSegment& segment, bool whole) {
  if (segment.is_line()) {
    if (segment.start.imag() - segment.end.imag() > kSameHeight) return Went::kUp;
    if (whole && std::abs(at_ - segment.start) > kSameHeight) return stop("G7X error: How did we get here?");
    return go(segment, segment.end);
  }
  const double middle = segment.center.real();
  if (segment.is_clockwise()) return at_.real() <= middle ? go(segment, segment.end) : Went::kUp;
  if (at_.real() < middle) return Went::kUp;
  const bool ends_before = segment.end.real() >= middle;
  const Went went = go(segment, ends_before ? segment.end : segment.center + Complex(0, segment.radius()));
  return went == Went::kOn ? Went::kUp : went;
}

/// Segment after segment, up to one that leads down again.
Layers::Went Layers::climb_out() {
  Went went = Went::kOn;
  while (segment_ < segments_.size() && (went = climb(segments_[segment_], true)) == Went::kOn) ++segment_;
  if (went == Went::kStopped) return went;
  if (words_.cut == ContourWords::Cut::kPocketsAfterwards) {
    while (rims_.size() > 1 && rims_.back() < at_.imag()) rims_.pop_back();
    if (rims_.size() == 1) rims_.push_back(at_.imag());
  }
  height_ = rims_.back();
  return Went::kOn;
}

/// Without pockets: past what lies lower.
Layers::Went Layers::climb_along_rest() {
  for (; segment_ < segments_.size(); ++segment_) {
    const ContourSegment& segment = segments_[segment_];
    if (segment.is_line() && segment.end.imag() < segment.start.imag()) continue;
    const auto crossings = segment.crossings(at_.imag());
    if (crossings.empty()) continue;
    const Complex from = segment.is_clockwise() ? crossings.last() : crossings.first();
    if (!segment.is_line() &&
        (segment.is_clockwise() ? from.real() > segment.center.real() : from.real() < segment.center.real()))
      continue;
    at_ = from;
    if (!tool_.feed(at_)) return moved(false);
    if (climb(segment, false) == Went::kStopped) return Went::kStopped;
  }
  return Went::kOn;
}

Layers::Went Layers::cut_to(Complex point) {
  const double lift = std::min(words_.r, std::abs(point - at_) / 2);
  const Went went =
      moved(tool_.feed(point) && tool_.rapid(point + lift * Complex(1, 1)) &&
            tool_.rapid(at_ + lift * Complex(-1, 1)) && (in_the_air() ? tool_.rapid(at_) : tool_.feed(at_)));
  height_ -= layer_;
  return went;
}

Layers::Went Layers::cut_layer() {
  for (size_t i = segment_; i < segments_.size(); ++i) {
    const auto crossings = segments_[i].crossings(at_.imag());
    if (crossings.empty()) continue;
    const Complex point = i == segment_ ? crossings.last() : crossings.first();
    if (point.real() > at_.real() + kSameHeight) continue;
    if (std::abs(point - at_) >= kSameHeight) return cut_to(point);
    if (i == segment_) continue;
    if (std::abs(segments_[i].start - at_) < kSameHeight) {
      segment_ = i;
    } else {
      height_ -= layer_;
    }
    return Went::kOn;
  }
  return Went::kOn;
}

ContourOutcome Layers::cut() {
  if (!tool_.rapid(at_)) return tool_.refused();
  if (words_.cut == ContourWords::Cut::kPocketsAfterwards) {
    height_ = -1e9;
    Went went = Went::kOn;
    while (segment_ < segments_.size() && (went = dive(segments_[segment_])) == Went::kOn) ++segment_;
    if (went == Went::kStopped) return outcome_;
    height_ = at_.imag();
  }
  while (segment_ < segments_.size()) {
    const Complex from = at_;
    const double from_height = height_;
    const size_t from_segment = segment_;
    if (!lower() || is_too_much(segments_.size() - segment_)) return outcome_;
    Went went = dive(segments_[segment_]);
    if (went == Went::kUp) {
      const bool passes = words_.cut == ContourWords::Cut::kNoPockets;
      if ((passes ? climb_along_rest() : climb_out()) == Went::kStopped) return outcome_;
      if (passes) return {};
      continue;
    }
    if (went == Went::kOn) {
      if (std::abs(at_.imag() - height_) > kSameHeight) {
        ++segment_;
      } else {
        went = cut_layer();
      }
    }
    if (went == Went::kStopped) return outcome_;
    if (at_ == from && height_ == from_height && segment_ == from_segment) return {ContourEnd::kNeverEnds};
  }
  return {};
}

/// Along the whole shape, in passes that come closer to it.
ContourOutcome finish(const ContourShape& shape, const ContourWords& words, ContourMoves& moves) {
  if (!(words.p < kMostPasses)) return {ContourEnd::kTooLong};
  for (int pass = static_cast<int>(words.p); pass > 0; --pass) {
    ContourShape aside = shape;
    ContourOutcome outcome = aside.shift((pass - 1) * (words.d - words.e) / words.p + words.e);
    outcome.unsure = aside.is_unsure();
    if (outcome.end != ContourEnd::kDone) return outcome;
    Tool tool(aside, moves);
    const std::vector<ContourSegment>& segments = aside.segments();
    bool moved = tool.rapid(segments.front().start) && tool.rapid(segments.front().end);
    for (size_t i = 1; moved && i < segments.size(); ++i)
      moved = tool.along(segments[i], segments[i].start, segments[i].end);
    if (!moved) return tool.refused(aside.is_unsure());
  }
  return {ContourEnd::kDone, nullptr, shape.is_unsure()};
}

ContourOutcome rough(ContourShape& shape, const ContourWords& words, ContourMoves& moves) {
  ContourOutcome outcome = shape.shift(words.d);
  if (outcome.end == ContourEnd::kDone) {
    shape.close();
    outcome = Layers(shape, words, moves).cut();
  }
  outcome.unsure = shape.is_unsure();
  return outcome;
}

}  // namespace

ContourOutcome cut_contour(std::span<const ContourElement> elements, const ContourWords& words, ContourMoves& moves) {
  if (elements.size() < 2) return {};
  if (elements.size() > kMostElements) return {ContourEnd::kTooLong};
  if (words.i <= 0) return {ContourEnd::kStops, "G7X error: I must be greater than zero."};
  ContourShape shape(elements);
  if (ContourOutcome prepared = shape.prepare(words); prepared.end != ContourEnd::kDone) {
    prepared.unsure = shape.is_unsure();
    return prepared;
  }
  return words.cut == ContourWords::Cut::kFinish ? finish(shape, words, moves) : rough(shape, words, moves);
}

}  // namespace owlint
