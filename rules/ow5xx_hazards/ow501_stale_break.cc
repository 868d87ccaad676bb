// OW501 stale-break: a `break` out of a `while` after which a `do` … `while` can run.
// Depends on: all loops share one "breaking" flag, and only the `while` that closes a `do` clears it.
#include "rules/driver/stops.h"

namespace owlint::rules::ow501 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kStaleBreak) continue;
    Elsewhere loop = place_of(in, h.other, h.other_elsewhere);
    if (loop.program == nullptr) loop = {&p, h.statement};
    Finding& f = out.add(p.at(h.statement).head_span(),
                         "`" + p.head(h.statement) + "` makes the `do` loop that ends on " + line_words(in, loop) +
                             " run only once: LinuxCNC still remembers the `break`");
    relate(in, f, loop, "this loop ends early");
    f.help = "leave the `while` by its condition instead, or write the other loop as a `while`";
    f.reach = h.reach;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW501",
    .name = "stale-break",
    .summary = "a `break` out of a `while` makes a later `do … while` loop end after one pass",
    .group = Group::kHazards,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A `while` loop that a `break` can leave, and a `do` loop that can run after it. The `do` loop then
makes only one pass.)",
            .why =
                R"(`break` sets a flag. LinuxCNC clears it only at the end of a `do` loop, not at `endwhile`. The next
`do` loop, even far below, sees the flag at its `while`, ignores the condition, and ends. Measured:
a `do` loop for four holes drills one, without a message. It happens only if the `break` was
executed, so one part comes out right and the next one does not.

A loop with `while` … `endwhile` is not affected.)",
            .bad = R"(G21 G90
G0 X0 Y0 Z5
#<x> = 0
o100 while [#<x> LT 100]
  G0 X#<x>
  G38.3 Z-10 F50
  o110 if [#5070 EQ 0]
    o100 break
  o110 endif
  G0 Z5
  #<x> = [#<x> + 20]
o100 endwhile
G0 Z5
#<y> = 0
o120 do
  G81 X0 Y#<y> Z-5 R2 F80
  #<y> = [#<y> + 10]
o120 while [#<y> LT 40]
G80
M2
)",
            .good = R"(G21 G90
G0 X0 Y0 Z5
#<x> = 0
o100 while [#<x> LT 100]
  G0 X#<x>
  G38.3 Z-10 F50
  o110 if [#5070 EQ 0]
    o100 break
  o110 endif
  G0 Z5
  #<x> = [#<x> + 20]
o100 endwhile
G0 Z5
#<y> = 0
o120 while [#<y> LT 40]
  G81 X0 Y#<y> Z-5 R2 F80
  #<y> = [#<y> + 10]
o120 endwhile
G80
M2
)",
            .fix = R"(Write the later loop with `while` … `endwhile`, or end the first loop by its condition instead of
`break`.)",
            .level_reason = "Warning: the program runs, but a later loop ends too early.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow501
