// OW509 stale-continue: a `continue` in a `do` … `while` after which a `break` or a `repeat` can run.
// Depends on: all loops share one "continuing" flag, and only `endwhile` and `endrepeat` at the end
// of a skip clear it.
#include <algorithm>

#include "rules/driver/stops.h"

namespace owlint::rules::ow509 {
namespace {

/// Whether the `continue` lies in the loop itself: then each pass may set the flag again.
bool is_within(const Program& of_loop, StatementId end, const Program& p, StatementId jump) {
  const BlockId block = of_loop.block_of[end];
  return &of_loop == &p && block != kNoBlock && of_loop.blocks[block].opener < jump && jump < end;
}

/// Whether that is known of the loop with this end.
bool never_ends(const Input& in, const Elsewhere& end) {
  const BlockId block = end.program->block_of[end.statement];
  return end.program == &in.program && block != kNoBlock && std::ranges::any_of(in.flow.hazards, [&](const Hazard& h) {
           return h.kind == HazardKind::kEndlessLoop && h.statement == in.program.blocks[block].opener;
         });
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kStaleContinue) continue;
    Elsewhere shown = place_of(in, h.other, h.other_elsewhere);
    if (shown.program == nullptr) shown = {&p, h.statement};
    const bool repeats = shown.program->at(shown.statement).is(Keyword::kEndrepeat);
    const std::string effect = !repeats ? " goes on after its `break`"
        : is_within(*shown.program, shown.statement, p, h.statement) || never_ends(in, shown)
        ? " begins its passes again, and never ends if they execute it each time"
        : " runs its passes twice";
    Finding& f = out.add(p.at(h.statement).head_span(),
                         "`" + p.head(h.statement) + "` still has an effect later: the loop that ends on " +
                             line_words(in, shown) + effect);
    relate(in, f, shown, "this loop" + effect);
    f.help = "skip the rest of the `do` loop with an `if` instead";
    f.reach = h.reach;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW509",
    .name = "stale-continue",
    .summary = "a `continue` in a `do … while` makes a later `break` go on, or a later `repeat` run its passes twice",
    .group = Group::kHazards,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A `do` loop with a `continue` that can be executed, and below it (or in a sub called later) a
`repeat`, or a `while` with a `break`.)",
            .why =
                R"(`continue` sets a flag that the `while` at the end of a `do` loop does not clear. The next end of a
loop that LinuxCNC skips to uses the flag: a later `repeat` **runs its passes twice** (measured: six
pecks instead of three), and a later `break` does not leave its `while` but begins the next pass.
There is no message. Versions 2.8.4 to 2.10 behave alike.)",
            .bad = R"(G21 G90
#<x> = 0
o100 do
  #<x> = [#<x> + 10]
  o110 if [#<x> EQ 20]
    o100 continue
  o110 endif
  G81 X#<x> Y0 Z-5 R2 F80
o100 while [#<x> LT 40]
G80
G0 X0 Y20 Z2
o120 repeat [3]
  G91 G1 Z-2 F80
o120 endrepeat
G90 G0 Z5
M2
)",
            .good = R"(G21 G90
#<x> = 0
o100 do
  #<x> = [#<x> + 10]
  o110 if [#<x> NE 20]
    G81 X#<x> Y0 Z-5 R2 F80
  o110 endif
o100 while [#<x> LT 40]
G80
G0 X0 Y20 Z2
o120 repeat [3]
  G91 G1 Z-2 F80
o120 endrepeat
G90 G0 Z5
M2
)",
            .fix =
                R"(Put the rest of the pass into an `if` instead of using `continue`, or write the loop with `while` …
`endwhile`, where `continue` works.)",
            .level_reason = "Warning: the program runs, but a later loop makes a different number of passes.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow509
