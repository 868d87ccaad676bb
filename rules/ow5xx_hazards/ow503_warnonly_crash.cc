// OW503 warnonly-crash: under FEATURE 0x20, an error after which the interpreter crashes.
// Depends on: with OWORD_WARNONLY LinuxCNC prints a message for an undefined label and then uses it
// anyway, which ends the process.
#include "rules/driver/stops.h"

namespace owlint::rules::ow503 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kCrash) continue;
    Finding& f = out.add(p.at(h.statement).head_span(),
                         "LinuxCNC crashes at `" + p.head(h.statement) +
                             "`: no block has this label, and with FEATURE 0x20 LinuxCNC goes on after the error");
    f.help = "correct the label; do not rely on FEATURE 0x20";
    f.interpreter = h.interpreter;
    f.reach = h.reach;
    f.stops = true;
    f.never_ends = true;
    add_consequences(in, h.statement, f);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW503",
    .name = "warnonly-crash",
    .summary = "under FEATURE 0x20, an error after which the interpreter crashes",
    .group = Group::kHazards,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(With FEATURE 0x20 (`OWORD_WARNONLY`): an `else`, `elseif`, `endif`, `break`, `continue`, `endwhile`
or `endrepeat` whose label no line has opened, on a line that a run can get to.)",
            .why =
                R"(The setting turns the documented O-word errors into messages. For an undefined label LinuxCNC prints
the message, goes on, and the **interpreter crashes** at that line, in the middle of a cut. Without
the setting the program stops normally. Crossed blocks lead to the same crash, because the inner end
has a label that was skipped.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 0]
  (MSG,no contact: check the probe)
o101 endif
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 0]
  (MSG,no contact: check the probe)
o100 endif
G0 Z5
M2
)",
            .fix = R"(Correct the label; the finding with an OW1 code at the same line says which one. Better still,
remove `OWORD_WARNONLY` from the INI.)",
            .level_reason = "Error: LinuxCNC crashes, which is worse than a stop.",
            .interpreter = "undefined O-word label: 'o101 endif'",
            .options = "--feature 0x20",
        },
    .check = check,
};

}  // namespace owlint::rules::ow503
