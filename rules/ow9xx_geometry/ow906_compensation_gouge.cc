// OW906 compensation-gouge: a corner or an arc of a compensated path that the tool does not fit into.
// Depends on: a path is cut back at each inside corner. Whether a move was long enough for its corners is known when the next one
// comes, or the path ends: the interpreter stops at that line.
#include <array>

#include "rules/driver/positions.h"

namespace owlint::rules::ow906 {
namespace {

constexpr std::string_view kMoves = "G0 G1 G2 G3 G40 M2 M30 M0 M1 M60 *";
constexpr std::string_view kWider =
    "use a thinner tool, or make the corner and the moves beside it wider than the tool";

constexpr std::array kSaid = {
    Said{"Tool radius not less than arc radius", "G2 G3 *", "is an inside arc that is too small for the tool",
         "use a tool whose radius is less than that of the arc, or make the arc wider"},
    Said{"Straight feed in concave corner", kMoves,
         "cuts back the straight move before it by more than its length: the tool does not fit between its corners",
         kWider},
    Said{"Straight traverse in concave corner", kMoves,
         "cuts back the rapid move before it by more than its length: the tool does not fit between its corners",
         kWider},
    Said{"Arc move in concave corner", kMoves, "makes a corner with an arc, and the tool does not fit into it", kWider},
    Said{"Arc to straight motion makes a corner", kMoves,
         "makes a corner with the arc before it, and the tool does not fit into it", kWider},
    Said{"Arc to arc motion makes a corner", kMoves,
         "makes a corner with the arc before it, and the tool does not fit into it", kWider},
    Said{"arcs have the same center", kMoves, "has the same center as the arc before it, but another radius",
         "put a straight move between the two arcs"},
    Said{"mismatched radii", kMoves, "makes a corner that LinuxCNC cannot compute",
         "begin compensation along a straight line"},
};

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = add_said(in, out, stop, kSaid);
    note_start(stop, f);
    relate_setter(in, f, setter_of(in, stop, "G41 G42 G41.1 G42.1", false), "begins compensation here");
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW906",
    .name = "compensation-gouge",
    .summary = "a corner or an arc of a compensated path that the tool does not fit into",
    .group = Group::kGeometry,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(With cutter compensation on: an inside arc whose radius is not greater than the tool's radius, a move between
two inside corners that is too short, or a corner next to an arc that the tool does not fit into.)",
            .why =
                R"(LinuxCNC stops with `Straight feed in concave corner cannot be reached by the tool without gouging`, `Tool
radius not less than arc radius with comp`, `Arc to straight motion makes a corner the compensated tool can't
fit in without gouging` and the like.

LinuxCNC shortens a move at an inside corner only when it reads the next move, `G40`, `M0` or the
end of the program. So it stops one line after the move that is too short; at the last corner, that
line is `G40`.)",
            .bad = R"(G21 G90 G17
G0 X-10 Y0 Z5
G41.1 D10
G1 X20 Y0 F200
G1 X20 Y8
G1 X0 Y8
G40
G0 Z5
M2
)",
            .good = R"(G21 G90 G17
G0 X-10 Y0 Z5
G41.1 D6
G1 X20 Y0 F200
G1 X20 Y8
G1 X0 Y8
G40
G0 Z5
M2
)",
            .fix =
                R"(Use a tool that fits: its radius must be less than that of each inside arc, and each move between two inside
corners must be long enough for it. The very short moves that a CAM system makes from curves are too
short for any tool if there is an inside corner between them.)",
            .level_reason = "Error if a run gets here: the program stops. Warning if that depends on the position of "
                            "the machine when the program starts. Warning if it stops at an earlier line first.",
            .interpreter = "Straight feed in concave corner cannot be reached by the tool without gouging",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow906
