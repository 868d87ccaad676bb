// OW905 compensation-entry: the first move with cutter compensation is too short for the tool to get beside the path.
// Depends on: the first move behind G41 or G42 ends beside its end point. A move along the tool alone, or of a rotary axis,
// is none
// in the plane.
#include <array>

#include "rules/driver/positions.h"

namespace owlint::rules::ow905 {
namespace {

constexpr std::array kSaid = {
    Said{"Length of cutter compensation entry", "G0 G1 G33 G33.1 G76 * @ ^",
         "is the first move with cutter compensation, but it is not longer than the tool's radius",
         "make the entry move longer than the radius of the tool; move along the tool axis before `G41` or `G42`"},
    Said{"Radius of cutter compensation entry", "G2 G3 *",
         "is the first move with cutter compensation, but its end is not farther away than the tool's radius",
         "make the entry arc longer, or enter along a straight line"},
    Said{"Bug in tool radius comp", "G2 G3 *", "is an entry arc that LinuxCNC cannot compute",
         "enter along a straight line"},
};

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = add_said(in, out, stop, kSaid);
    note_start(stop, f);
    relate_setter(in, f, setter_of(in, stop, "G41 G42 G41.1 G42.1"), "begins compensation here");
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW905",
    .name = "compensation-entry",
    .summary = "the first move with cutter compensation is too short for the tool",
    .group = Group::kGeometry,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(The first move after `G41`, `G42`, `G41.1` or `G42.1` is not longer than the radius of the tool. A move of only
Z has no length in the plane of the path, but it counts as the first move, too.)",
            .why =
                R"(During the entry move, the tool goes to the side of the path; at its end the tool is beside the programmed
point. LinuxCNC stops with `Length of cutter compensation entry move is not greater than the tool
radius`, or, for an arc, with `Radius of cutter compensation entry arc is not greater than the tool radius`,
although it measures the straight distance between the ends of that arc.)",
            .bad = R"(G21 G90 G17
G0 X0 Y0 Z5
G41.1 D10
G1 X3 Y0 F200
G1 X20 Y0
G40
G0 Z5
M2
)",
            .good = R"(G21 G90 G17
G0 X-10 Y0 Z5
G41.1 D10
G1 X3 Y0 F200
G1 X20 Y0
G40
G0 Z5
M2
)",
            .fix =
                R"(Begin the entry move farther away, and go down to the depth before `G41` or `G42`. During the entry move the
tool does not yet follow the path, so begin it off the part.)",
            .level_reason = "Error if a run gets here: the program stops. Warning if that depends on the position of "
                            "the machine when the program starts. Warning if it stops at an earlier line first.",
            .interpreter = "Length of cutter compensation entry move is not greater than the tool radius",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow905
