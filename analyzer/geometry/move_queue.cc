#include "analyzer/geometry/move_queue.h"

#include <algorithm>
#include <cmath>

namespace owlint {
namespace {

/// An anchor that is scaled so often is at the origin or far beyond all points: once more changes no verdict.
constexpr int kMostWaiting = 32;

}  // namespace

Sweep sweep(PlanePoint from, PlanePoint to, PlanePoint center, int turns) {
  double start = angle(from - center);
  double end = angle(to - center);
  double apart = std::fabs(start - end);
  if (turns > 0 && end <= start) end = rounded(end + kTwoPi);
  if (turns < 0 && start <= end) start = rounded(start + kTwoPi);
  Sweep swept;
  swept.angle = rounded((end - start) + (turns > 0 ? turns - 1 : turns + 1) * kTwoPi);
  swept.other = swept.angle;
  // Directions on both sides of the one where angles jump from π to -π are close, too. One point is a whole turn for certain.
  if (from != to && (apart < kTie || apart > kTwoPi - kTie)) {
    bool whole = std::fabs(end - start) > kPi;
    swept.other += rounded(whole == (turns > 0) ? -kTwoPi : kTwoPi);
  }
  return swept;
}

void MoveQueue::append(const QueuedMove& move) {
  if (empty()) moves_[1] = {};
  if (waiting_ < kMoves) moves_[waiting_] = move;
  waiting_ = std::min(waiting_ + 1, kMostWaiting);
}

void MoveQueue::append_standing(PlanePoint at, bool rapid) {
  QueuedMove move;
  move.rapid = rapid;
  move.end = at;
  append(move);
}

void MoveQueue::append_others(int count) {
  if (empty()) return;
  for (int i = 0; i < count && waiting_ < kMostWaiting; i++) append({});
}

void MoveQueue::anchor(PlanePoint at) {
  anchor_ = at;
  anchored_ = true;
}

void MoveQueue::send() {
  waiting_ = 0;
  anchor_ = {};
  anchored_ = false;
}

bool MoveQueue::trim(PlanePoint at, bool inch, PathStep& step) {
  if (empty()) return true;
  for (int i = 0; i < std::min(waiting_, kMoves); i++) {
    if (!reaches(moves_[i], at, inch, step)) return false;
    moves_[i].end = at;
  }
  send();
  anchor(at);
  return true;
}

bool MoveQueue::reaches(const QueuedMove& move, PlanePoint at, bool inch, PathStep& step) const {
  if (move.arc) {
    double before = length(move.end - move.center);
    double now = length(at - move.center);
    if (std::fabs(before - now) > 0.01)
      return step.stop(
          PathFault::kBug,
          printed("BUG: cutter compensation has generated an invalid arc with mismatched radii r1 %f r2 %f", before,
                  now));
    if (!anchored_ || move.swept.angle == 0) return true;
    double slack = inch ? 0.001 : 0.0254;
    auto too_far = [&](double swept, double programmed, double tie) {
      return std::fabs(swept) > std::fabs(programmed) + slack + tie;
    };
    Sweep swept = sweep(anchor_, at, move.center, move.turns);
    bool gouges = too_far(swept.angle, move.swept.angle, 0);
    for (double possible : {swept.angle, swept.other})
      for (double programmed : {move.swept.angle, move.swept.other})
        for (double tie : {-kTie, kTie})
          if (too_far(possible, programmed, tie) != gouges) step.undecided = true;
    if (gouges)
      return step.stop(PathFault::kGouge, "Arc move in concave corner cannot be reached by the tool without gouging");
    return true;
  }
  if (!anchored_) return true;
  PlanePoint left = at - anchor_;
  double along = move.direction.first * left.first + move.direction.second * left.second;
  // What is left of a line may be nothing but rounding of the two points.
  double size = length(left) + 0.01 * (length(at) + length(anchor_));
  if (std::fabs(along) < kTie * length(move.direction) * size) step.undecided = true;
  if (along < 0)
    return step.stop(PathFault::kGouge,
                     std::string("Straight ") + (move.rapid ? "traverse" : "feed") +
                         " in concave corner cannot be reached by the tool without gouging");
  return true;
}

void MoveQueue::scale(double factor) {
  auto scale_point = [factor](PlanePoint& point) {
    point.first *= factor;
    point.second *= factor;
  };
  for (int i = 0; i < std::min(waiting_, kMoves); i++) {
    scale_point(moves_[i].end);
    scale_point(moves_[i].center);
  }
  // Once for each, as the interpreter does: it is right only if one is waiting.
  for (int i = 0; i < waiting_; i++) scale_point(anchor_);
}

}  // namespace owlint
