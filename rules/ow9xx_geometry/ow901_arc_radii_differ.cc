// OW901 arc-radii-differ: an arc by its center whose ends are not equally far from it.
// Depends on: the start is where the machine stands. The center counts from there in G91.1, which is in effect unless a program
// sets G90.1. How far the two radii may differ depends on the unit and the INI.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "rules/driver/arc_advice.h"
#include "rules/driver/positions.h"

namespace owlint::rules::ow901 {
namespace {

std::string what_differs(const WordStop& at, const ArcNumbers& arc) {
  const double more = arc.end_radius - arc.start_radius;
  const int decimals = telling_decimals(std::abs(more), arc.allowed);
  return fmt::format("{} ends {} {} its center than it starts; {} is allowed",
                     at.letter == 'g' ? "`" + at.word + "`" : "this arc", length(std::abs(more), arc.inch, decimals),
                     more > 0 ? "farther from" : "nearer to", length(arc.allowed, arc.inch, decimals));
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    if (stop.words.arc == nullptr) return nullptr;
    const WordStop at = word_stop(in, stop, "G2 G3");
    Finding& f = out.add(at.span, what_differs(at, *stop.words.arc));
    advise_about_center(in, stop, f);
    tell_arc_start(in, stop, f);
    f.arc = sketch_of(*stop.words.arc);
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW901",
    .name = "arc-radii-differ",
    .summary = "an arc whose start and end are not equally far from its center",
    .group = Group::kGeometry,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A `G2` or `G3` with a center (`I`, `J`, `K`), whose end is farther from the center than its start, or nearer
to it. No arc goes through both.)",
            .why =
                R"(LinuxCNC stops with `Radius to end of arc differs from radius to start` and the numbers of the arc: r1 is the
distance from the center to the start, r2 the distance from the center to the end.

The two may differ by 0.0283 mm, or by 0.0028 inch in `G20`. For large arcs they may differ by a thousandth of
the radius, but never by more than 2.83 mm or 0.283 inch. `[RS274NGC]CENTER_ARC_RADIUS_TOLERANCE_MM` and
`..._INCH` in the INI make it stricter. Numbers with three decimals are always exact enough.

The arc starts where the line before it ends. In `G91.1`, which is in effect unless a program writes `G90.1`,
`I`, `J` and `K` count from that start; in `G90.1` they are the position of the center. In `G7` they are
radii, although `X` is a diameter.)",
            .bad = R"(G21 G90 G17
G0 X0 Y0 Z5
G1 Z-2 F200
G2 X20 Y0 I10.1 J0
G0 Z5
M2
)",
            .good = R"(G21 G90 G17
G0 X0 Y0 Z5
G1 Z-2 F200
G2 X20 Y0 I10 J0
G0 Z5
M2
)",
            .fix =
                R"(If the difference is small, compute the center with more decimals, or write `R` instead of `I` and `J` if the
arc is less than half a circle. If it is large, the tool does not start where you think, the center is written
for `G90.1` instead of `G91.1` or the other way round, or a word is missing or has the wrong sign.)",
            .level_reason =
                "Error if a run gets here: the program stops. Warning if it stops only on a machine that was just "
                "started, at X0 Y0 Z0 and without offsets. Warning if it stops at an earlier line first.",
            .interpreter =
                "Radius to end of arc differs from radius to start: start=(X0.0000,Y0.0000) center=(X10.1000,Y0.0000) "
                "end=(X20.0000,Y0.0000) r1=10.1000 r2=9.9000 abs_err=0.2 rel_err=1.9802%",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow901
