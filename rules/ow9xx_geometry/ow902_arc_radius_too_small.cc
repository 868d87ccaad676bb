// OW902 arc-radius-too-small: an arc by its radius that does not reach from its start to its end.
// Depends on: the start is where the machine stands. Half the way to the end is the least radius.
#include <cmath>

#include <fmt/format.h>

#include "rules/driver/arc_advice.h"
#include "rules/driver/positions.h"

namespace owlint::rules::ow902 {
namespace {

constexpr double kInch = 25.4;
/// A radius that is so much too small, as a part of the least one, is meant and only not exact.
constexpr double kNear = 0.1;

std::string what_is_lacking(const WordStop& at, const ArcNumbers& arc) {
  const int decimals = telling_decimals(std::abs(arc.radius), arc.least_radius);
  std::string radius = subject(at);
  if (arc.radius == 0) return radius + " is no radius: no arc has it";
  if (!at.value) radius += ", which is " + length(arc.radius, arc.inch, decimals) + ",";
  return fmt::format("{} does not reach the end of the arc: the end is {} away, so the radius must be {} or more",
                     radius, length(2 * arc.least_radius, arc.inch), length(arc.least_radius, arc.inch, decimals));
}

std::string how_to_reach(const ArcNumbers& arc) {
  if (arc.radius == 0) return "write the radius of the arc, or its center instead";
  const std::string least = least_radius_word(arc);
  const double radius = std::abs(arc.radius);
  const double other_unit = arc.inch ? radius / kInch : radius * kInch;
  if (std::abs(other_unit - arc.least_radius) < arc.tolerance.difference) {
    return fmt::format("a half circle fits if the radius is in {}: in {} it is `{}`",
                       arc.inch ? "millimeters" : "inches", arc.inch ? "inches" : "millimeters", least);
  }
  const bool near = arc.least_radius - radius <= kNear * arc.least_radius;
  if (!near || least.empty()) return "check the end, the radius, and where the arc starts";
  return fmt::format("`{}` reaches it, as a half circle", least);
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    if (stop.words.arc == nullptr) return nullptr;
    const WordStop at = word_stop(in, stop, "R");
    Finding& f = out.add(at.span, what_is_lacking(at, *stop.words.arc));
    f.help = how_to_reach(*stop.words.arc);
    tell_arc_start(in, stop, f);
    f.arc = sketch_of(*stop.words.arc);
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW902",
    .name = "arc-radius-too-small",
    .summary = "an arc whose radius does not reach from its start to its end",
    .group = Group::kGeometry,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A `G2` or `G3` with `R`, whose end is farther from its start than twice that radius. No arc with this radius
reaches so far.)",
            .why =
                R"(LinuxCNC stops with `Arc radius too small to reach end point`. A radius may be up to 0.00127 mm, or
0.00005 inch, less than half the distance: then the arc is half a circle. The same applies to a negative `R`,
which takes the longer way round.

The arc starts where the line before it ends.)",
            .bad = R"(G21 G90 G17
G0 X0 Y0 Z5
G1 Z-2 F200
G2 X20 Y10 R11.1
G0 Z5
M2
)",
            .good = R"(G21 G90 G17
G0 X0 Y0 Z5
G1 Z-2 F200
G2 X20 Y10 R11.1804
G0 Z5
M2
)",
            .fix =
                R"(If only a little is missing, round the radius of the half circle up, or write its center with `I` and `J`. If
much is missing, the start or the end is not where you think.)",
            .level_reason =
                "Error if a run gets here: the program stops. Warning if it stops only on a machine that was just "
                "started, at X0 Y0 Z0 and without offsets. Warning if it stops at an earlier line first.",
            .interpreter = "Arc radius too small to reach end point",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow902
