// OW503 warnonly-crash: under FEATURE 0x20, a finding after which the interpreter crashes.
// Rests on: with OWORD_WARNONLY an undefined label is reported and then used all the same, which
// ends the process.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kCrash) continue;
    Finding& f = out.add(p.at(h.statement).head_span(), "LinuxCNC crashes at `" + p.head(h.statement) + "`: the label is unknown, and FEATURE 0x20 makes it go on");
    f.help = "correct the label; do not rely on FEATURE 0x20";
    f.interpreter = h.interpreter;
    f.reach = h.reach;
    f.stops = true;
    f.never_ends = true;
    add_consequences(in, h.statement, f);
  }
}

}  // namespace

extern const Rule kOw503{
    .code = "OW503",
    .name = "warnonly-crash",
    .summary = "under 0x20, a finding after which the interpreter crashes",
    .group = Group::kHazards,
    .level = Severity::kError,
    .page = {
        .what = R"(With FEATURE 0x20 (`OWORD_WARNONLY`) in effect: an `else`, `elseif`, `endif`, `break`, `continue`,
`endwhile` or `endrepeat` whose label nothing has opened, on a line that a run can get to.)",
        .why = R"(The setting turns the documented O-word errors into messages. For an undefined label LinuxCNC prints
the message, goes on, and the **interpreter crashes** at that very line: a program fault of the
controller in the middle of a cut, not a warning. Without the setting the program stops in an
orderly way. Crossed blocks lead to the same, because the inner end meets a label that was skipped.)",
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
        .fix = R"(Correct the label; the finding under the OW1 code at the same place says which one. Better still,
take `OWORD_WARNONLY` out of the INI.)",
        .interpreter = "undefined O-word label: 'o101 endif'",
        .options = "--feature 0x20",
    },
    .check = check,
};

}  // namespace owlint::rules
