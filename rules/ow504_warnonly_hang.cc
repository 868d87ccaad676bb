// OW504 warnonly-hang: under FEATURE 0x20, a finding after which the interpreter never ends.
// Rests on: with OWORD_WARNONLY the label still belongs to the first block, so the end of the
// second jumps back to it.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  // An endless loop that begins with an error which 0x20 turned into a message.
  for (const Hazard& loop : in.flow.hazards) {
    if (loop.kind != HazardKind::kHang) continue;
    Finding& f = out.add(p.at(loop.statement).head_span(), "under FEATURE 0x20 the program never ends after `" + p.head(loop.statement) + "`");
    relate(f, p, loop.other, "it comes back to this line again and again");
    f.help = "correct the label; do not rely on FEATURE 0x20";
    f.interpreter = loop.interpreter;
    f.reach = loop.reach;
    f.never_ends = true;
  }
}

}  // namespace

extern const Rule kOw504{
    .code = "OW504",
    .name = "warnonly-hang",
    .summary = "under 0x20, a finding after which the interpreter never ends",
    .group = Group::kHazards,
    .level = Severity::kError,
    .page = {
        .what = R"(With FEATURE 0x20 (`OWORD_WARNONLY`) in effect: a second `repeat` or `while` on a used label, an
`endwhile` or `endrepeat` on a block of another kind, an `else` on a loop's label, where the flow
from there never comes out again.)",
        .why = R"(The setting turns the documented O-word errors into messages, but the label still stands for the
first block. The second block's end jumps back to the first one's opening line, and so on **for
ever**: the machine repeats the same moves until somebody presses stop, and prints the message each
time round. In the example four holes along X are followed by one along Y, three along X, one along
Y, and so on, away from the part. Without the setting the program stops in an orderly way.)",
        .bad = R"(G21 G90
G0 X0 Y0 Z5
o100 repeat [4]
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
o100 repeat [4]
  G91 G0 Y10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
M2
)",
        .good = R"(G21 G90
G0 X0 Y0 Z5
o100 repeat [4]
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
o110 repeat [4]
  G91 G0 Y10
  G90 G1 Z-2 F80
  G0 Z5
o110 endrepeat
M2
)",
        .fix = R"(Correct the label; the finding under the OW1 code at the same place says which one. Better still,
take `OWORD_WARNONLY` out of the INI.)",
        .interpreter = "duplicate O-word label: 'o100 repeat [4]' - defined in line N",
        .options = "--feature 0x20",
    },
    .check = check,
};

}  // namespace owlint::rules
