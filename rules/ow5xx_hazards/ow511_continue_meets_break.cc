// OW511 continue-meets-break: a `continue` in a `do` loop that has a `break` of the same loop further down.
// Depends on: `continue` skips to the next line with the loop's label. A `break` with that label acts
// even if the `if` around it is skipped.
#include "rules/driver/stops.h"

namespace owlint::rules::ow511 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kContinueMeetsBreak || h.other == kNoStatement) continue;
    Finding& f = out.add(p.at(h.statement).head_span(),
                         "`" + p.head(h.statement) +
                             "` ends the loop: on the way to the `while`, LinuxCNC executes the `break` on line " +
                             std::to_string(p.at(h.other).line));
    relate(f, p, h.other, "this `break` ends the loop");
    f.help = "move the `break` above the `continue`, or write the loop as a `while`";
    f.reach = h.reach;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW511",
    .name = "continue-meets-break",
    .summary = "a `continue` in a `do` loop with a `break` of that loop below it: the loop ends there",
    .group = Group::kHazards,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A `do` loop with a `continue` above a `break` of the same loop.)",
            .why = R"(After `continue` LinuxCNC skips to the next line with the loop's label. That should be the `while`
at the end, but the `break` comes first, and LinuxCNC obeys it without looking at the `if` around
it. So **the loop ends** instead of beginning its next pass. Measured: the example drills one hole
instead of four, without a message. In a `while` … `endwhile` loop the same lines work.)",
            .bad = R"(G21 G90
#<x> = 0
o100 do
  #<x> = [#<x> + 10]
  o110 if [#<x> EQ 20]
    o100 continue
  o110 endif
  o120 if [#<_current_tool> GT 90]
    o100 break
  o120 endif
  G81 X#<x> Y0 Z-5 R2 F80
o100 while [#<x> LT 50]
G80
M2
)",
            .good = R"(G21 G90
#<x> = 0
o100 while [#<x> LT 50]
  #<x> = [#<x> + 10]
  o110 if [#<x> EQ 20]
    o100 continue
  o110 endif
  o120 if [#<_current_tool> GT 90]
    o100 break
  o120 endif
  G81 X#<x> Y0 Z-5 R2 F80
o100 endwhile
G80
M2
)",
            .fix = R"(Write the loop with `while` … `endwhile`, move the `if` with the `break` above the `continue`, or
replace the `continue` by an `if`.)",
            .level_reason = "Warning: the program runs, but the loop ends too early.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow511
