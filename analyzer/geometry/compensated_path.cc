#include "analyzer/geometry/compensated_path.h"

#include <cmath>

#include "analyzer/geometry/arc.h"

namespace owlint {
namespace {

/// A corner by less than this angle is none, in radians.
constexpr double kStraightOn = 0.05;

constexpr const char* kToolTooLarge = "Tool radius not less than arc radius with comp";
constexpr const char* kNotStraight = "Bug code not g0 or g1";

bool above(double value, long double bound, PathStep& step) {
  if (std::fabs(value - bound) < kTie) step.undecided = true;
  return value > bound;
}
bool below(double value, long double bound, PathStep& step) { return above(-value, -bound, step); }

/// Equal by the numbers as written is no tie.
bool at_most(double value, double bound, PathStep& step) {
  if (value != bound && std::fabs(value - bound) < kTie * bound) step.undecided = true;
  return value <= bound;
}

/// An inverse function takes only values from -1 to 1.
bool out_of_range(double value, PathStep& step) { return above(std::fabs(value), 1, step); }

}  // namespace

void CompensatedPath::start(const Tool& tool, const ArcUnits& units, PlanePoint at) {
  queue_ = {};
  radius_ = std::fabs(tool.radius);
  side_ = tool.side;
  if (tool.radius < 0) side_ = side_ == Side::kLeft ? Side::kRight : Side::kLeft;
  orientation_ = tool.orientation;
  units_ = units;
  programmed_ = tool_ = at;
  on_ = true;
  entered_ = false;
}

PathStep CompensatedPath::line(PlanePoint end, Mover mover) {
  PathStep step;
  arc_forbidden_ = false;
  if (entered_)
    next_line(end, mover, step);
  else
    enter_line(end, mover, step);
  return step;
}

PathStep CompensatedPath::arc(ArcEntry arc) {
  PathStep step;
  if (entered_)
    next_arc(arc, step);
  else
    enter_arc(arc, step);
  return step;
}

PathStep CompensatedPath::pause() {
  PathStep step;
  if (offsets() && entered_ && trim(tool_, step)) queue_.send();
  return step;
}

PathStep CompensatedPath::off() {
  PathStep step = pause();
  bool forbids = arc_forbidden_ || (offsets() && entered_);
  PlanePoint at = programmed_;
  // As good as new, so that paths which differ in nothing that matters compare equal.
  *this = {};
  programmed_ = tool_ = at;
  arc_forbidden_ = forbids;
  return step;
}

void CompensatedPath::change_units(bool inch) {
  if (!on_ || inch == units_.inch) return;
  double factor = inch ? 1 / kMillimetresInInch : kMillimetresInInch;
  units_.inch = inch;
  radius_ *= factor;
  for (PlanePoint* point : {&programmed_, &tool_}) {
    point->first *= factor;
    point->second *= factor;
  }
  queue_.scale(factor);
}

bool CompensatedPath::enter_line(PlanePoint end, Mover mover, PathStep& step) {
  PlanePoint move = end - tool_;
  if (at_most(length(move), radius_, step))
    return step.stop(PathFault::kEntryTooShort,
                     "Length of cutter compensation entry move is not greater than the tool radius");
  if (mover == Mover::kThread) return step.stop(PathFault::kNotStraight, kNotStraight);
  double ahead = angle(move);
  double across = side_ == Side::kLeft ? rounded(ahead + kHalfPi) : rounded(ahead - kHalfPi);
  queue_.anchor(tool_);
  // Across, not along, so that the entry move may be shortened as far as a corner asks.
  append_line(around(end, radius_, across), {std::cos(across), std::sin(across)}, mover);
  programmed_ = end;
  entered_ = true;
  return true;
}

bool CompensatedPath::enter_arc(ArcEntry& arc, PathStep& step) {
  bool within = is_inside(arc.turns);
  if (at_most(length(arc.end - tool_), radius_, step))
    return step.stop(PathFault::kEntryTooShort,
                     "Radius of cutter compensation entry arc is not greater than the tool radius");
  if (arc.by_radius && within && at_most(std::fabs(arc.radius), radius_, step))
    return step.stop(PathFault::kGouge, kToolTooLarge);
  if (!arc_check(tool_, units_, arc, step)) return false;
  if (!arc.by_radius && within && at_most(length(arc.center - tool_), radius_, step))
    return step.stop(PathFault::kGouge, kToolTooLarge);

  PlanePoint end = around(arc.end, radius_, angle(within ? arc.center - arc.end : arc.end - arc.center));
  double half = length(tool_ - end) / 2;
  double to_center = angle(arc.center - end);
  double slant = std::cos(angle(tool_ - end) - to_center);
  if (std::fabs(slant) < 0.0001) return step.stop(PathFault::kGouge, kToolTooLarge);
  // The tool goes along an arc from where it is, with another center.
  PlanePoint center = around(end, half / slant, to_center);
  if (std::fabs(length(center - end) - length(center - tool_)) > arc.spread)
    return step.stop(PathFault::kBug, "Bug in tool radius comp");

  if (orientation_ != 0 && orientation_ != 9) {
    queue_.append_standing(tool_, false);
    queue_.anchor(tool_);
  }
  append_arc(end, center, arc.turns, sweep(tool_, end, center, arc.turns));
  programmed_ = arc.end;
  entered_ = true;
  return true;
}

bool CompensatedPath::next_line(PlanePoint end, Mover mover, PathStep& step) {
  if (end == programmed_) {
    if (mover == Mover::kThread) return step.stop(PathFault::kNotStraight, kNotStraight);
    queue_.append_standing(tool_, mover == Mover::kRapid);
    return true;
  }
  double across = angle(tool_ - programmed_);
  double ahead = angle(end - programmed_);
  double turn;
  if (side_ == Side::kLeft) {
    if (across < ahead) across = rounded(across + kTwoPi);
    turn = rounded((across - ahead) - kHalfPi);
  } else {
    if (ahead < across) ahead = rounded(ahead + kTwoPi);
    turn = rounded((ahead - across) - kHalfPi);
  }
  if (!turn_into_line(end, across, ahead, turn, mover, step)) return false;
  append_line(around(end, radius_, ahead + quarter()), end - programmed_, mover);
  programmed_ = end;
  return true;
}

bool CompensatedPath::turn_into_line(PlanePoint end, double across, double ahead, double turn, Mover mover,
                                     PathStep& step) {
  const QueuedMove& front = queue_.front();
  bool concave = below(turn, -kStraightOn, step) || above(turn, kPi + kStraightOn, step) ||
      (!queue_.empty() && front.arc && !is_inside(front.turns) && above(turn, kPi - kStraightOn, step));
  if (concave) {
    if (front.arc) return shorten_arc_for_line(end, step);
    double back = radius_ / std::tan(rounded((turn + kPi) / 2));
    return trim(around(tool_, back, across + quarter()), step);
  }
  if (above(turn, kStraightOn, step)) {
    if (!trim(tool_, step)) return false;
    if (mover == Mover::kThread) return step.stop(PathFault::kNotStraight, kNotStraight);
    queue_.anchor(around(programmed_, radius_, ahead + quarter()));
    return true;
  }
  queue_.send();
  queue_.anchor(tool_);
  return true;
}

bool CompensatedPath::shorten_arc_for_line(PlanePoint end, PathStep& step) {
  const QueuedMove& arc = queue_.front();
  bool within = is_inside(arc.turns);
  double radius = length(arc.center - arc.end);
  double ahead = angle(end - programmed_);
  double across = arc.turns > 0 ? rounded(ahead + kHalfPi) : rounded(ahead - kHalfPi);
  double whole = within ? radius + radius_ : radius - radius_;
  double apart = whole * std::cos(across - angle(arc.center - programmed_));
  double share = within ? (apart - radius_) / radius : (apart + radius_) / radius;
  if (out_of_range(share, step))
    return step.stop(PathFault::kGouge,
                     "Arc to straight motion makes a corner the compensated tool can't fit in without gouging");
  double meeting =
      within == (arc.turns > 0) ? rounded(across - std::acos(share) + kPi) : rounded(across + std::acos(share) + kPi);
  return trim(around(arc.center, radius, meeting), step);
}

bool CompensatedPath::next_arc(ArcEntry& arc, PathStep& step) {
  if (!arc_check(programmed_, units_, arc, step)) return false;
  double radius = length(arc.center - arc.end);
  double across = angle(tool_ - programmed_);
  across = side_ == Side::kLeft ? rounded(across - kHalfPi) : rounded(across + kHalfPi);
  double outward = angle(arc.center - programmed_);
  double ahead = arc.turns > 0 ? rounded(outward - kHalfPi) : rounded(outward + kHalfPi);
  double turn = side_ == Side::kLeft ? across - ahead : ahead - across;
  if (turn > 3 * kHalfPi) turn = rounded(turn - kTwoPi);
  if (turn < -kHalfPi) turn = rounded(turn + kTwoPi);

  bool within = is_inside(arc.turns);
  if (within && at_most(radius, radius_, step)) return step.stop(PathFault::kGouge, kToolTooLarge);
  if (!within) outward = rounded(outward + kPi);
  PlanePoint tool_end = around(arc.end, radius_, angle(within ? arc.center - arc.end : arc.end - arc.center));
  if (!turn_into_arc(arc, radius, across, outward, turn, step)) return false;
  append_arc(tool_end, arc.center, arc.turns, sweep(programmed_, arc.end, arc.center, arc.turns));
  programmed_ = arc.end;
  return true;
}

bool CompensatedPath::turn_into_arc(const ArcEntry& arc, double radius, double before, double outward, double turn,
                                    PathStep& step) {
  bool concave = below(turn, -kStraightOn, step) || above(turn, kPi + kStraightOn, step) ||
      (!is_inside(arc.turns) && above(turn, kPi - kStraightOn, step) && below(turn, kPi + kStraightOn, step));
  if (concave)
    return queue_.front().arc ? shorten_arc_for_arc(arc, radius, step)
                              : shorten_line_for_arc(arc, radius, before, turn, step);
  PlanePoint begins = above(turn, kStraightOn, step) ? around(programmed_, radius_, outward) : tool_;
  queue_.send();
  queue_.anchor(begins);
  return true;
}

bool CompensatedPath::shorten_line_for_arc(const ArcEntry& arc, double radius, double before, double turn,
                                           PathStep& step) {
  bool within = is_inside(arc.turns);
  double apart = rounded(radius * std::sin(turn - kHalfPi));
  double tool_radius = within ? radius - radius_ : radius + radius_;
  double share = within ? (apart + radius_) / tool_radius : (apart - radius_) / tool_radius;
  if (out_of_range(share, step))
    return step.stop(PathFault::kGouge, "Arc move in concave corner cannot be reached by the tool without gouging");
  double meeting;
  if (within)
    meeting = arc.turns > 0 ? before + std::asin(share) : before - std::asin(share);
  else
    meeting = arc.turns > 0 ? rounded(before + kPi - std::asin(share)) : rounded(before + kPi + std::asin(share));
  return trim(around(arc.center, tool_radius, meeting), step);
}

bool CompensatedPath::shorten_arc_for_arc(const ArcEntry& arc, double radius, PathStep& step) {
  const QueuedMove& last = queue_.front();
  double last_radius = length(last.center - last.end);
  double next_radius = is_inside(arc.turns) ? radius - radius_ : radius + radius_;
  double apart = length(last.center - arc.center);
  if (last_radius == 0 || apart == 0)
    return step.stop(PathFault::kGouge, "Arc to arc motion is invalid because the arcs have the same center");
  double share = (last_radius * last_radius + apart * apart - next_radius * next_radius) / (2 * last_radius * apart);
  if (out_of_range(share, step))
    return step.stop(PathFault::kGouge,
                     "Arc to arc motion makes a corner the compensated tool can't fit in without gouging");
  double meeting = angle(arc.center - last.center);
  meeting = is_inside(last.turns) == (arc.turns > 0) ? meeting + std::acos(share) : meeting - std::acos(share);
  return trim(around(last.center, last_radius, meeting), step);
}

void CompensatedPath::append_line(PlanePoint tool_end, PlanePoint direction, Mover mover) {
  QueuedMove move;
  move.rapid = mover == Mover::kRapid;
  move.end = tool_end;
  move.direction = direction;
  queue_.append(move);
  tool_ = tool_end;
}

void CompensatedPath::append_arc(PlanePoint tool_end, PlanePoint center, int turns, Sweep swept) {
  QueuedMove move;
  move.arc = true;
  move.turns = turns;
  move.end = tool_end;
  move.center = center;
  move.swept = swept;
  queue_.append(move);
  tool_ = tool_end;
}

}  // namespace owlint
