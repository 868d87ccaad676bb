// OW903 arc-degenerate: words of an arc that do not make one, a full circle by its radius, or one without a radius.
// Depends on: an arc has a radius or a center, never both. A missing word of the center is 0 in G91.1 and an error in G90.1. An
// arc with a radius needs an end point in its plane. Letters that the plane does not have are OW804's.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "rules/driver/arc_advice.h"
#include "rules/driver/positions.h"

namespace owlint::rules::ow903 {
namespace {

constexpr std::string_view kArc = "G2 G3 * I J K R";
constexpr std::string_view kLacksCenter = " word missing in absolute center arc";
constexpr std::string_view kLacksEnd = " words missing for arc in ";
constexpr std::string_view kZero = "Zero-radius arc: ";
constexpr int kLeastDecimals = 5;  // of the least radius
constexpr std::string_view kSamePoint = "Current point same as end point";

constexpr std::array kSaid = {
    Said{"all missing for arc", kArc, "is an arc without a center or a radius",
         "write the center as `I` and `J`, or the radius as `R`; a straight move needs its `G1` or `G0`"},
    Said{"Mixed radius ijk", "R", "gives a radius, but the line also gives a center",
         "write `R` or the center, not both"},
    Said{kLacksCenter, kArc, "has only one word for its center, and `G90.1` is in effect", ""},
    Said{kLacksEnd, "R", "gives a radius, but the line has no end point in the plane of the arc", ""},
    Said{kZero, "G2 G3 I J K *", "", ""},
    Said{kSamePoint, "R", "gives a radius, but the arc ends where it starts", ""},
};

/// `XZ`, as in `X and z words missing for arc in xz plane`.
std::string plane_in(const std::string& said) {
  const size_t at = said.find(kLacksEnd);
  return at == std::string::npos ? "" : capital(said[at + kLacksEnd.size()]) + capital(said[at + kLacksEnd.size() + 1]);
}

/// For what depends on where the machine stands.
void explain_place(const Input& in, const FlowStop& stop, Finding& f) {
  const ArcNumbers& arc = *stop.words.arc;
  if (stop.interpreter.starts_with(kSamePoint)) {
    const auto center = [&](char letter) { return capital(letter) + number_text(std::abs(arc.radius)); };
    const auto [first, second] = std::minmax(arc.first_center, arc.second_center);
    f.help = fmt::format("a full circle needs its center instead of `R`, such as `{}` or `{}`", center(first),
                         center(second));
  } else {
    const bool at_start = arc.start_radius < arc.tolerance.least_radius;
    const std::string arc_word = subject(word_stop(in, stop, "G2 G3"));
    const double radius = at_start ? arc.start_radius : arc.end_radius;
    constexpr double kNothing = 1e-9;
    if (radius > kNothing) {
      f.message = fmt::format("{} is too small for an arc: its center is {} from its {}, and at least {} is needed",
                              arc_word, length(radius, arc.inch, telling_decimals(radius, 0)),
                              at_start ? "start" : "end", length(arc.tolerance.least_radius, arc.inch, kLeastDecimals));
    } else {
      f.message = arc_word + " has its center at its " + (at_start ? "start" : "end") + ", so it has no radius";
    }
    advise_about_zero_radius(in, stop, f);
  }
  tell_arc_start(in, stop, f);
  f.arc = sketch_of(arc);
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = add_said(in, out, stop, kSaid);
    const std::string& said = stop.interpreter;
    if (stop.words.arc != nullptr) {
      explain_place(in, stop, f);
      return &f;
    }
    if (said.ends_with(kLacksCenter)) {
      f.help = fmt::format("write `{}` too, or `G91.1`, in which a missing word is 0", said.substr(0, 1));
      relate_setter(in, f, setter_of(in, stop, "G90.1"));
    } else if (const std::string plane = plane_in(said); !plane.empty()) {
      f.help = fmt::format("write `{}` or `{}`; a full circle needs its center instead of `R`", plane[0], plane[1]);
      relate_setter(in, f, setter_of(in, stop, "G17 G18 G19"));
    } else {
      relate_setter(in, f, setter_of(in, stop, "G2 G3", false));
    }
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW903",
    .name = "arc-degenerate",
    .summary = "an arc without a center or a radius, or that ends where it starts",
    .group = Group::kGeometry,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A `G2` or `G3` without a center (`I`, `J`, `K`) and without a radius (`R`), or with both; with only
one word of the center in `G90.1`; with `R`, but with no end point in the plane of the arc or with
its start as the end; or with its center at its start or its end. `G2` stays in effect: a line after
an arc with only `X` and `Y` is an arc, too.)",
            .why =
                R"(LinuxCNC stops with `R i j k words all missing for arc`, `Mixed radius ijk format for arc`, `J word missing
in absolute center arc` and the like.

It stops with `Current point same as end point of arc` for a full circle with `R`, whose center
could be anywhere. It stops with `Zero-radius arc` if the center is less than 0.00127 mm (0.00005
inch) from an end.

With a center, no end point is needed: without one the arc is a full circle. In `G91.1`, which is in effect
unless a program writes `G90.1`, a missing word of the center is 0.)",
            .bad = R"(G21 G90 G17
G0 X0 Y0 Z5
G1 Z-2 F200
G2 X20 Y0 I10
X0 Y10
G0 Z5
M2
)",
            .good = R"(G21 G90 G17
G0 X0 Y0 Z5
G1 Z-2 F200
G2 X20 Y0 I10
G1 X0 Y10
G0 Z5
M2
)",
            .fix =
                R"(Write the center or the radius of the arc. After an arc, write `G1` or `G0` on the next straight move.)",
            .level_reason =
                "Error if a run gets here: the program stops. Warning if it stops at an earlier line first.",
            .interpreter = "R i j k words all missing for arc",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow903
