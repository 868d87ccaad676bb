// OW804 plane-wrong: words or a code that the plane in effect does not allow.
// Depends on: G17 XY, G18 XZ, G19 YZ; G17.1, G18.1 and G19.1 are those of U, V and W. The plane of the line counts, wherever it
// is written. Cutter compensation is OW805's, polar words are OW709's.
#include <algorithm>
#include <array>

#include "rules/driver/modes.h"

namespace owlint::rules::ow804 {
namespace {

constexpr std::string_view kPlanes = "G17 G18 G19 G17.1 G18.1 G19.1";
constexpr std::string_view kInCycle = "remove the word, or select the right plane before it";

constexpr std::array kSaid = {
    Said{"Cannot do an arc in planes", "G2 G3 * I J K R", "is an arc, and a plane of `U`, `V` and `W` is in effect",
         "write `G17`, `G18` or `G19` on this line or before it"},
    Said{"K word given", "K", "cannot give a center in the XY plane",
         "write the center as `I` and `J`; for an arc in XZ write `G18`, in YZ `G19`"},
    Said{"J word given", "J", "cannot give a center in the XZ plane",
         "write the center as `I` and `K`; for an arc in XY write `G17`, in YZ `G19`"},
    Said{"I word given", "I", "cannot give a center in the YZ plane",
         "write the center as `J` and `K`; for an arc in XY write `G17`, in XZ `G18`"},
    Said{"Splines must be in the XY plane", "G5 G5.1", "is a spline in XY, and another plane is in effect",
         "write `G17` on this line or before it"},
    Said{"can only be used in XZ plane", "G70 G71 G71.1 G71.2 G72 G72.1 G72.2",
         "turns in XZ, and another plane is in effect", "write `G18` on this line or before it"},
    Said{"Cannot put an X in", "X", "cannot be used in a cycle in this plane", kInCycle},
    Said{"Cannot put a Y in", "Y", "cannot be used in a cycle in this plane", kInCycle},
    Said{"Cannot put a Z in", "Z", "cannot be used in a cycle in this plane", kInCycle},
    Said{"Cannot put a U in", "U", "cannot be used in a cycle in this plane", kInCycle},
    Said{"Cannot put a V in", "V", "cannot be used in a cycle in this plane", kInCycle},
    Said{"Cannot put a W in", "W", "cannot be used in a cycle in this plane", kInCycle},
    Said{"canned cycle is not possible", "G73 G74 G81 G82 G83 G84 G85 G86 G87 G88 G89 *",
         "drills along an axis that the machine does not have, because of the plane in effect",
         "write `G17` on this line or before it"},
    Said{"for plane", "G74 G84 *", "cannot tap in a plane of `U`, `V` and `W`",
         "write `G17` on this line or before it"},
    Said{"one plane must be selected", "G6.2 *", "is a curve, and a plane of `U`, `V` and `W` is in effect",
         "write `G17`, `G18` or `G19` on this line or before it"},
};

/// The plane that a code works in only; empty if there are several.
std::string plane_of(const std::string& said) {
  if (said.starts_with("Splines")) return "G17";
  return said.find("XZ plane (G18)") != std::string::npos ? "G18" : "";
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = add_said(in, out, stop, kSaid);
    const std::optional<Setter> setter = setter_of(in, stop, kPlanes);
    relate_setter(in, f, setter);
    const std::string plane = plane_of(stop.interpreter);
    const WordStop at = word_stop(in, stop, kPlanes);
    if (!plane.empty() && find_word(at.line, kPlanes) == nullptr) f.fixes.push_back(with_code(f.span, plane));
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW804",
    .name = "plane-wrong",
    .summary = "words or a code that the plane in effect does not allow",
    .group = Group::kModes,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(An arc whose center is given with a letter that its plane does not have: `K` in XY (`G17`), `J` in XZ
(`G18`), `I` in YZ (`G19`). A spline outside XY, a lathe cycle (`G70` to `G72`) outside XZ, an arc or a
cycle in a plane of `U`, `V` and `W`.)",
            .why =
                R"(The words of an arc do not say in which plane it is: the plane in effect decides. LinuxCNC stops with `K word
given for arc in xy plane`, `Splines must be in the XY plane`, `G71.0 can only be used in XZ plane (G18)`
and the like.

The plane stays in effect until another one is selected, even after calls. A plane on the line itself
applies to the move on that line, wherever on the line it is written.)",
            .bad = R"(G21 G90
G0 X10 Z5
G1 Z0 F80
G2 X14 Z-4 I0 K-4
M2
)",
            .good = R"(G21 G90
G18
G0 X10 Z5
G1 Z0 F80
G2 X14 Z-4 I0 K-4
M2
)",
            .fix =
                R"(Select the plane before the arc: `G17` for XY, `G18` for XZ, `G19` for YZ. Or write the center with the
letters of the plane that is in effect.)",
            .level_reason = "Error if a run gets here in that plane: the program stops. owlint reports nothing on "
                            "lines that no run reaches.",
            .interpreter = "K word given for arc in xy plane",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow804
