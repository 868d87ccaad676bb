// OW504 warnonly-hang: under FEATURE 0x20, an error after which the program never ends.
// Depends on: with OWORD_WARNONLY the label still belongs to the first block, so the end of the
// second jumps back to it.
#include "rules/driver/stops.h"

namespace owlint::rules::ow504 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  // An endless loop that begins with an error which 0x20 turned into a message.
  for (const Hazard& loop : in.flow.hazards) {
    if (loop.kind != HazardKind::kHang) continue;
    Finding& f = out.add(p.at(loop.statement).head_span(),
                         "with FEATURE 0x20 the program never ends after `" + p.head(loop.statement) + "`");
    relate(f, p, loop.other, "the program comes back to this line again and again");
    f.help = "correct the label; do not rely on FEATURE 0x20";
    f.interpreter = loop.interpreter;
    f.reach = loop.reach;
    f.never_ends = true;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW504",
    .name = "warnonly-hang",
    .summary = "under FEATURE 0x20, an error after which the program never ends",
    .group = Group::kHazards,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(With FEATURE 0x20 (`OWORD_WARNONLY`): a second `repeat` or `while` with a used label, an `endwhile`
or `endrepeat` of another kind of block, or an `else` with a loop's label, if the program never ends
after that.)",
            .why = R"(The setting turns the documented O-word errors into messages, but the label still belongs to the
first block. The end of the second block jumps back to the beginning of the first one, and so on
**for ever**: the machine repeats the same moves until somebody presses stop, and prints the message
in every pass. In the example, four holes along X are followed by one along Y, three along X, one
along Y, and so on, away from the part. Without the setting the program stops normally.)",
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
            .fix = R"(Correct the label; the finding with an OW1 code at the same line says which one. Better still,
remove `OWORD_WARNONLY` from the INI.)",
            .level_reason = "Error: the program never ends, and somebody has to abort it.",
            .interpreter = "duplicate O-word label: 'o100 repeat [4]' - defined in line N",
            .options = "--feature 0x20",
        },
    .check = check,
};

}  // namespace owlint::rules::ow504
