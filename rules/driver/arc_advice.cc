#include "rules/driver/arc_advice.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "rules/driver/positions.h"

namespace owlint::rules {
namespace {

constexpr double kInch = 25.4;
/// A radius that is none, but for how numbers are rounded.
constexpr double kNothing = 1e-9;
/// The difference of the radii, as a part of the greater one, up to which the numbers are meant and only not exact.
constexpr double kNearMiss = 0.1;

/// As it is when it is written with four decimals.
double rounded(double value) {
  constexpr double kDecimals = 1e4;
  return std::round(value * kDecimals) / kDecimals;
}
Flat rounded(Flat at) { return {rounded(at.first), rounded(at.second)}; }
Flat plus(Flat a, Flat b) { return {a.first + b.first, a.second + b.second}; }
Flat minus(Flat a, Flat b) { return {a.first - b.first, a.second - b.second}; }
Flat times(Flat a, double by) { return {a.first * by, a.second * by}; }

/// In XZ the first axis is Z, but X is written first.
std::string in_order(std::string a, std::string b, std::string_view between) {
  if (b < a) std::swap(a, b);
  return a.append(between).append(b);
}

/// An arc by its center, and the words that it is written with.
class CenterWords {
 public:
  explicit CenterWords(const ArcNumbers& arc) : arc_(arc) {}

  /// What I and J say, or would say.
  Flat words_of(Flat center) const { return arc_.absolute_center ? center : minus(center, arc_.start); }
  Flat center_of(Flat words) const { return arc_.absolute_center ? words : plus(arc_.start, words); }
  Flat end_words() const { return arc_.incremental ? minus(arc_.end, arc_.start) : arc_.end; }
  Flat end_of(Flat words) const { return arc_.incremental ? plus(arc_.start, words) : words; }
  bool passes(Flat center, Flat end) const {
    return arc_by_center(arc_.start, center, end, arc_.tolerance).fault == ArcFault::kNone;
  }
  /// `I5 J0`; empty if that does not fit.
  std::string center_text(Flat center) const;
  std::string end_text(Flat end) const;

 private:
  const ArcNumbers& arc_;
};

std::string CenterWords::center_text(Flat center) const {
  const Flat words = rounded(words_of(center));
  if (!passes(center_of(words), arc_.end)) return {};
  return in_order(capital(arc_.first_center) + number_text(words.first),
                  capital(arc_.second_center) + number_text(words.second), " ");
}

std::string CenterWords::end_text(Flat end) const {
  const Flat words = rounded(arc_.incremental ? minus(end, arc_.start) : end);
  return passes(arc_.center, end_of(words)) ? point_words(arc_, words) : std::string();
}

/// The point that is as far from both ends and nearest to the center.
Flat nearest_center(const ArcNumbers& arc) {
  const Flat along = minus(arc.end, arc.start);
  const double square = along.first * along.first + along.second * along.second;
  const Flat off = minus(arc.center, times(plus(arc.start, arc.end), 0.5));
  return minus(arc.center, times(along, (off.first * along.first + off.second * along.second) / square));
}

/// The point that is as far from the center as the start, in the direction of the end.
Flat nearest_end(const ArcNumbers& arc) {
  return plus(arc.center, times(minus(arc.end, arc.center), arc.start_radius / arc.end_radius));
}

std::string letters(const ArcNumbers& arc) {
  return "`" + in_order(capital(arc.first_center), capital(arc.second_center), "` and `") + "`";
}

/// Whether a center is nearly where the ends are equally far from it. A large radius alone fits any end that is near its start.
bool near_bisector(const ArcNumbers& arc, Flat center, Flat end) {
  constexpr double kPart = 0.2;  // of the way from the start to the end
  const Flat along = minus(end, arc.start);
  const Flat off = minus(center, times(plus(arc.start, end), 0.5));
  const double square = along.first * along.first + along.second * along.second;
  return std::abs(off.first * along.first + off.second * along.second) <= kPart * square;
}

/// For numbers of another unit.
std::string of_other_unit(const ArcNumbers& arc) {
  const CenterWords arcs(arc);
  const double factor = arc.inch ? 1 / kInch : kInch;
  const Flat center = times(arcs.words_of(arc.center), factor);
  const Flat end = times(arcs.end_words(), factor);
  const char* const meant = arc.inch ? "millimeters" : "inches";
  const char* const unit = arc.inch ? "inches" : "millimeters";
  if (arcs.passes(arcs.center_of(center), arc.end) && near_bisector(arc, arcs.center_of(center), arc.end)) {
    const std::string text = arcs.center_text(arcs.center_of(center));
    if (!text.empty()) return fmt::format("the center fits if its numbers are {}: in {} it is `{}`", meant, unit, text);
  }
  if (!arcs.passes(arc.center, arcs.end_of(end)) || !near_bisector(arc, arc.center, arcs.end_of(end))) return {};
  const std::string text = arcs.end_text(arcs.end_of(end));
  if (text.empty()) return {};
  return fmt::format("the end fits if its numbers are {}: in {} it is `{}`", meant, unit, text);
}

/// For a center on the other side, or with its words exchanged, or in diameter mode a diameter.
std::string of_other_words(const ArcNumbers& arc) {
  const CenterWords arcs(arc);
  const Flat at = arcs.words_of(arc.center);
  const std::array others = {Flat{-at.first, at.second}, Flat{at.first, -at.second}, Flat{-at.first, -at.second},
                             Flat{at.second, at.first}};
  for (const Flat other : others) {
    const std::string text = arcs.passes(arcs.center_of(other), arc.end) ? arcs.center_text(arcs.center_of(other)) : "";
    if (!text.empty())
      return fmt::format("a center at `{}` would fit: check the signs, the letters, and the end", text);
  }
  if (!arc.diameter) return {};
  Flat half = at;
  (arc.first == 'x' ? half.first : half.second) /= 2;
  const std::string text = arcs.center_text(arcs.center_of(half));
  return text.empty() ? std::string() : fmt::format("`I` is no diameter in `G7`, only `X` is: `{}` fits", text);
}

/// For numbers that are only not exact.
std::string of_near_numbers(const ArcNumbers& arc) {
  const CenterWords arcs(arc);
  const std::string center = arc.start == arc.end ? std::string() : arcs.center_text(nearest_center(arc));
  const std::string end = arcs.end_text(nearest_end(arc));
  if (center.empty() && end.empty()) return {};
  if (center.empty()) return fmt::format("an end at `{}` fits the center", end);
  if (end.empty()) return fmt::format("the nearest center that fits is `{}`", center);
  return fmt::format("the nearest center that fits is `{}`; if the center is right, an end at `{}` fits", center, end);
}

/// For numbers that fit in the other mode of center words.
std::string of_other_center_mode(const ArcNumbers& arc) {
  const CenterWords arcs(arc);
  const Flat written = arcs.words_of(arc.center);
  const std::string here = arcs.center_text(arc.absolute_center ? plus(arc.start, written) : written);
  const std::string as_it_is = here.empty() ? std::string() : fmt::format("; as it is, write `{}`", here);
  if (arc.absolute_center) {
    return fmt::format("{} fit as distances from the start: `G91.1` seems to be meant{}", letters(arc), as_it_is);
  }
  return fmt::format("{} fit as the place of the center itself: `G90.1` seems to be meant{}", letters(arc), as_it_is);
}

}  // namespace

std::string point_words(const ArcNumbers& arc, Flat point) {
  const auto word = [&](char axis, double value) {
    return capital(axis) + number_text(axis == 'x' && arc.diameter ? 2 * value : value);
  };
  return in_order(word(arc.first, point.first), word(arc.second, point.second), " ");
}

void tell_arc_start(const Input& in, const FlowStop& stop, Finding& finding) {
  const ArcNumbers& arc = *stop.words.arc;
  note_start(stop, finding);
  finding.unproven = stop.unproven;
  if (stop.words.from_start) finding.help += "; or write a move to its start before it";
  const bool polar = arc.first == 'x' && arc.second == 'y';
  const std::optional<Span> from =
      words_above(in, stop.statement, std::string{arc.first, arc.second} + (polar ? "@^" : ""));
  if (!from) return;
  std::string message = "the arc starts where this line ends";
  if (arc.start_known && !stop.words.from_start) message += ", at " + point_words(arc, arc.start);
  finding.related.push_back({*from, std::move(message), nullptr});
}

namespace {

/// Whether another mode would make the numbers fit: then that is the help.
bool names_mode(const Input& in, const FlowStop& stop, Finding& finding) {
  const ArcNumbers& arc = *stop.words.arc;
  const ModeMask decides = stop.words.decided_by;
  const Flat written = CenterWords(arc).words_of(arc.center);
  const Flat other_center = arc.absolute_center ? plus(arc.start, written) : written;
  if ((decides & mask_of(Mode::kArcDistance)) != 0 && near_bisector(arc, other_center, arc.end)) {
    finding.help = of_other_center_mode(arc);
    const auto setter = setter_of(in, stop, "G90.1 G91.1");
    if (setter && !setter->restores()) relate_setter(in, finding, setter);
    return true;
  }
  if ((decides & mask_of(Mode::kDistance)) != 0) {
    finding.help = "the end fits in `G90`; in `G91` it counts from the start";
    relate_distance(in, stop, finding);
    return true;
  }
  return false;
}

}  // namespace

void advise_about_center(const Input& in, const FlowStop& stop, Finding& finding) {
  if (names_mode(in, stop, finding)) return;
  const ArcNumbers& arc = *stop.words.arc;
  finding.help = of_other_unit(arc);
  const double greater = std::max(arc.start_radius, arc.end_radius);
  const bool near = std::abs(arc.start_radius - arc.end_radius) <= kNearMiss * greater;
  if (finding.help.empty()) finding.help = near ? of_near_numbers(arc) : of_other_words(arc);
  if (finding.help.empty()) finding.help = "check the end, the center, and where the arc starts";
}

void advise_about_zero_radius(const Input& in, const FlowStop& stop, Finding& finding) {
  if (names_mode(in, stop, finding)) return;
  const ArcNumbers& arc = *stop.words.arc;
  if (std::min(arc.start_radius, arc.end_radius) > kNothing) {
    finding.help = "write a straight move `G1` to its end, or leave the line out";
    return;
  }
  const char* const what =
      arc.absolute_center ? "write the place of the center" : "write how far the center is from the start";
  finding.help = fmt::format("{} as {}", what, letters(arc));
}

std::shared_ptr<const ArcSketch> sketch_of(const ArcNumbers& arc) {
  const bool by_radius = arc.radius != 0;
  if (arc.start == arc.end && (by_radius || arc.center == arc.start)) return nullptr;
  const auto point = [&arc](Flat at) -> ArcSketch::Point {
    if (arc.start_known) return {at.first, at.second, point_words(arc, at)};
    return {at.first, at.second, point_words(arc, minus(at, arc.start))};
  };
  const auto circle = [&](Flat center, double radius) -> ArcSketch::Circle {
    return {point(center), radius, length(radius, arc.inch)};
  };
  ArcSketch sketch;
  sketch.clockwise = arc.clockwise;
  sketch.start = point(arc.start);
  if (!arc.start_known) sketch.start.words += ", wherever the machine stands";
  sketch.end = point(arc.end);
  sketch.start_radius = by_radius ? std::abs(arc.radius) : arc.start_radius;
  sketch.end_radius = by_radius ? std::abs(arc.radius) : arc.end_radius;
  const int decimals = by_radius ? telling_decimals(sketch.start_radius, arc.least_radius)
                                 : telling_decimals(arc.start_radius, arc.end_radius);
  sketch.start_radius_words = length(sketch.start_radius, arc.inch, decimals);
  sketch.end_radius_words = length(sketch.end_radius, arc.inch, decimals);
  if (!by_radius) sketch.center = point(arc.center);
  if (arc.start == arc.end) return std::make_shared<const ArcSketch>(std::move(sketch));
  if (by_radius) {
    sketch.nearest = circle(times(plus(arc.start, arc.end), 0.5), arc.least_radius);
    sketch.nearest->words = length(arc.least_radius, arc.inch, decimals);
  } else if (arc.start_radius >= arc.tolerance.least_radius && arc.end_radius >= arc.tolerance.least_radius) {
    const Flat center = nearest_center(arc);
    sketch.nearest = circle(center, std::hypot(center.first - arc.start.first, center.second - arc.start.second));
  }
  return std::make_shared<const ArcSketch>(std::move(sketch));
}

std::string least_radius_word(const ArcNumbers& arc) {
  constexpr double kDecimals = 1e4;
  const double least = std::ceil(arc.least_radius * kDecimals) / kDecimals;
  if (arc_by_radius(arc.start, arc.end, least, arc.tolerance).fault != ArcFault::kNone) return {};
  return (arc.radius < 0 ? "R-" : "R") + number_text(least);
}

}  // namespace owlint::rules
