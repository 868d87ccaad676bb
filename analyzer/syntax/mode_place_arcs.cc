// Whether the numbers of an arc make one, from where the machine stands.
#include <fmt/format.h>

#include "analyzer/geometry/arc.h"
#include "analyzer/syntax/mode_place.h"

namespace owlint::places {
namespace {

/// The points of an arc in its plane, in one of the two places.
struct Ends {
  Flat start, end;
};

class Arc {
 public:
  Arc(ModeLine& line, const ArcAxes& axes, Motion motion, const Point& end)
      : line_(line), axes_(axes), motion_(motion), from_(line.place()->at), to_(end) {
    const size_t first = index(axes.first), second = index(axes.second);
    here_ = {{places::here(from_[first]), places::here(from_[second])},
             {places::here(to_[first]), places::here(to_[second])}};
    elsewhere_ = {{places::elsewhere(from_[first], first), places::elsewhere(from_[second], second)},
                  {places::elsewhere(to_[first], first), places::elsewhere(to_[second], second)}};
    start_unknown_ = from_[first].is_unknown() || from_[second].is_unknown();
    unknown_ = start_unknown_ || to_[first].is_unknown() || to_[second].is_unknown();
    const bool inch = line.only(Mode::kUnits) == modes::kG20;
    tolerance_ = arc_tolerance(inch, inch ? line.machine().arc_tolerance_inch : line.machine().arc_tolerance_mm);
  }

  bool stops_by_center(bool absolute);
  bool stops_by_radius(double radius);

 private:
  static size_t index(Axis axis) { return static_cast<size_t>(axis); }
  static char letter(Axis axis) { return kAxisOrder[index(axis)]; }
  static std::string capital(Axis axis) { return std::string(1, static_cast<char>(letter(axis) - 'a' + 'A')); }
  std::string point(Flat at, bool unknown) const;
  Flat center(Flat start, bool absolute) const;
  std::string said(const CenterArc& arc, Flat center, bool known, bool absolute) const;
  ArcNumbers numbers(bool absolute) const;
  bool passes(const Ends& ends, bool absolute) const;
  ModeMask deciding(bool absolute) const;

  ModeLine& line_;
  const ArcAxes& axes_;
  Motion motion_;
  const Point& from_;
  const Point& to_;
  Ends here_{}, elsewhere_{};
  bool start_unknown_ = false, unknown_ = false;
  ArcTolerance tolerance_{};
};

/// `(X1.0000,Y2.0000)`; dots stand for what is not known.
std::string Arc::point(Flat at, bool unknown) const {
  if (unknown) return fmt::format("({}...,{}...)", capital(axes_.first), capital(axes_.second));
  return fmt::format("({}{:.4f},{}{:.4f})", capital(axes_.first), at.first, capital(axes_.second), at.second);
}

Flat Arc::center(Flat start, bool absolute) const {
  const auto offset = [this](char letter) { return line_.has(letter) ? *line_.value(letter) : 0; };
  const Flat written{offset(axes_.first_center), offset(axes_.second_center)};
  return absolute ? written : Flat{start.first + written.first, start.second + written.second};
}

std::string Arc::said(const CenterArc& arc, Flat center, bool known, bool absolute) const {
  const auto length = [known](double value) { return known ? fmt::format("{:.4f}", value) : "..."; };
  std::string text =
      arc.fault == ArcFault::kZeroRadius ? "Zero-radius arc: " : "Radius to end of arc differs from radius to start: ";
  text += fmt::format("start={} center={} end={} r1={} r2={}", point(here_.start, start_unknown_),
                      point(center, start_unknown_ && !absolute), point(here_.end, unknown_), length(arc.start_radius),
                      length(arc.end_radius));
  if (arc.fault == ArcFault::kZeroRadius) return text;
  if (!known) return text + " abs_err=... rel_err=...";
  return text + fmt::format(" abs_err={:.4g} rel_err={:.4f}%", arc.difference, arc.share * 100);
}

ArcNumbers Arc::numbers(bool absolute) const {
  ArcNumbers numbers{};
  numbers.first = letter(axes_.first);
  numbers.second = letter(axes_.second);
  numbers.first_center = axes_.first_center;
  numbers.second_center = axes_.second_center;
  numbers.start_known = !unknown_;
  numbers.inch = line_.only(Mode::kUnits) == modes::kG20;
  numbers.diameter = line_.holds({{Mode::kDiameter, value_bit(modes::kG7)}}) == Answer::kYes;
  numbers.incremental = line_.only(Mode::kDistance) == modes::kG91;
  numbers.absolute_center = absolute;
  numbers.clockwise = motion_ == Motion::kG2;
  numbers.tolerance = tolerance_;
  numbers.start = here_.start;
  numbers.end = here_.end;
  return numbers;
}

bool Arc::passes(const Ends& ends, bool absolute) const {
  return arc_by_center(ends.start, center(ends.start, absolute), ends.end, tolerance_).fault == ArcFault::kNone;
}

/// The modes of which another one would make the arc pass.
ModeMask Arc::deciding(bool absolute) const {
  if (unknown_) return 0;
  ModeMask modes = 0;
  const bool whole_center = line_.has(axes_.first_center) && line_.has(axes_.second_center);
  if (whole_center && passes(here_, !absolute)) modes |= mask_of(Mode::kArcDistance);
  if (line_.only(Mode::kDistance) != modes::kG91 || line_.words().has_polar_words()) return modes;
  Ends other = here_;
  if (line_.has(letter(axes_.first))) other.end.first -= here_.start.first;
  if (line_.has(letter(axes_.second))) other.end.second -= here_.start.second;
  if (other.end != here_.end && passes(other, absolute)) modes |= mask_of(Mode::kDistance);
  return modes;
}

bool Arc::stops_by_center(bool absolute) {
  const Flat center = this->center(here_.start, absolute);
  const CenterArc arc = arc_by_center(here_.start, center, here_.end, tolerance_);
  const CenterArc other =
      arc_by_center(elsewhere_.start, this->center(elsewhere_.start, absolute), elsewhere_.end, tolerance_);
  const bool same = agree(arc.start_radius, other.start_radius);
  // With its center at its start it has no radius, wherever it ends.
  const bool at_start = same && arc.start_radius < tolerance_.least_radius;
  const bool same_end = agree(arc.end_radius, other.end_radius);
  const bool agrees = at_start || (same && same_end);
  const CheckOutcome outcome = outcome_of(arc.fault != ArcFault::kNone, other.fault == arc.fault, agrees, unknown_);
  if (outcome == CheckOutcome::kPasses) return false;
  ArcNumbers numbers = this->numbers(absolute);
  numbers.center = center;
  numbers.start_radius = arc.start_radius;
  numbers.end_radius = arc.end_radius;
  numbers.allowed = arc.allowed;
  const StopKind kind = arc.fault == ArcFault::kZeroRadius ? StopKind::kArcWords : StopKind::kArcRadiiDiffer;
  return stop_by(line_, outcome, kind,
                 said(arc, center, outcome != CheckOutcome::kUnsure && (same_end || !unknown_), absolute),
                 line_.mover(), kNoWord, deciding(absolute), numbers);
}

bool Arc::stops_by_radius(double radius) {
  const RadiusArc arc = arc_by_radius(here_.start, here_.end, radius, tolerance_);
  const RadiusArc other = arc_by_radius(elsewhere_.start, elsewhere_.end, radius, tolerance_);
  // A radius of 0 reaches nothing.
  const bool agrees = radius == 0 || agree(arc.least_radius, other.least_radius);
  const CheckOutcome outcome = outcome_of(arc.fault != ArcFault::kNone, other.fault == arc.fault, agrees, unknown_);
  if (outcome == CheckOutcome::kPasses) return false;
  ArcNumbers numbers = this->numbers(false);
  numbers.radius = radius;
  numbers.least_radius = arc.least_radius;
  const bool same = arc.fault == ArcFault::kSamePoint;
  return stop_by(line_, outcome, same ? StopKind::kArcWords : StopKind::kArcRadiusTooSmall,
                 same ? "Current point same as end point of arc" : "Arc radius too small to reach end point",
                 line_.at('r'), line_.mover(), 0, numbers);
}

/// Whether all words of the center are known.
bool knows_center(const ModeLine& line) {
  for (const char letter : {'i', 'j', 'k'}) {
    if (line.has(letter) && line.value(letter) == nullptr) return false;
  }
  return true;
}

}  // namespace

bool arc(ModeLine& line, Motion motion, const Point& end) {
  if (line.place() == nullptr) return false;
  // A compensated path looks at its arcs itself. Where nothing is known of it, the radii have to fit whatever the tool.
  if (line.place()->path.offsets()) return false;
  const std::optional<uint8_t> plane = line.only(Mode::kPlane);
  const bool by_radius = line.has('r');
  const std::optional<uint8_t> arc_distance = by_radius ? modes::kG91_1 : line.only(Mode::kArcDistance);
  const double* const radius = line.value('r');
  const bool known =
      plane && arc_distance && line.only(Mode::kUnits) && (by_radius ? radius != nullptr : knows_center(line));
  if (!known) {
    return stop_by(line, CheckOutcome::kUnsure, by_radius ? StopKind::kArcRadiusTooSmall : StopKind::kArcRadiiDiffer,
                   by_radius ? "Arc radius too small to reach end point"
                             : "Radius to end of arc differs from radius to start: ...",
                   line.mover());
  }
  Arc arc(line, kArcAxes[*plane], motion, end);
  return by_radius ? arc.stops_by_radius(*radius) : arc.stops_by_center(*arc_distance == modes::kG90_1);
}

}  // namespace owlint::places
