// OW502 stale-repeat-count: a `return` out of a `repeat` in a sub that can be called again.
// Depends on: the remaining count is kept with the label, labels live for the whole run, and
// `return` does not reset the count.
#include "rules/driver/stops.h"

namespace owlint::rules::ow502 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kStaleRepeatCount || h.other == kNoStatement) continue;
    Finding& f = out.add(
        p.at(h.statement).head_span(),
        "`" + p.head(h.statement) +
            "` leaves a `repeat` before its last pass: the next call of the sub runs only the remaining passes");
    relate(f, p, h.other, "the count of this `repeat` stays");
    f.help = "use a `while` with a counter, or leave the loop before returning";
    f.reach = h.reach;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW502",
    .name = "stale-repeat-count",
    .summary = "after a `return` out of a `repeat`, the next call of the sub runs only the remaining passes",
    .group = Group::kHazards,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A sub that can `return` from inside a `repeat`, and is called more than once.)",
            .why = R"(LinuxCNC keeps the number of remaining passes with the label of the `repeat`. `return` does not
clear it. So the next call does not start again: it makes only the passes that were left. Measured:
`repeat [4]`, left in its first pass, makes three passes in the next call and four in the one after.
There is no message.)",
            .bad = R"(G21 G90
o100 sub
  o110 repeat [4]
    G91 G38.3 Z-2 F50
    G90
    o120 if [#5070 EQ 1]
      o100 return
    o120 endif
  o110 endrepeat
o100 endsub
G0 X10 Y10 Z5
o100 call
G0 Z5
G0 X30
o100 call
G0 Z5
M2
)",
            .good = R"(G21 G90
o100 sub
  #<n> = 0
  o110 while [#<n> LT 4]
    G91 G38.3 Z-2 F50
    G90
    o120 if [#5070 EQ 1]
      o100 return
    o120 endif
    #<n> = [#<n> + 1]
  o110 endwhile
o100 endsub
G0 X10 Y10 Z5
o100 call
G0 Z5
G0 X30
o100 call
G0 Z5
M2
)",
            .fix = R"(Use a `while` with a counter, which starts again in each call, or let the `repeat` run to its end
and skip the work inside.)",
            .level_reason = "Warning: the program runs, but the next call makes fewer passes.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow502
