// OW210 call-too-deep: a chain of calls, or a recursion, that goes beyond the nesting limit.
// Rests on: nine calls may be open at once; the tenth is refused. Each called file and M98 counts.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& s) -> Finding* {
    Finding& f = out.add(p.at(s.statement).head_span(), "`" + p.head(s.statement) + "` can be the tenth level of calls; LinuxCNC allows nine");
    const RegionId region = p.region_of[s.statement];
    const bool recursive = p.regions[region].name != kNoName && p.regions[region].name == p.at(s.statement).label;
    if (recursive) {
      f.message = "`" + p.head(s.statement) + "` calls its own sub, " + (s.unproven ? "how deep is not known" : "again and again") + ": LinuxCNC allows nine levels";
      relate(f, p, p.regions[region].opener, "the sub begins here");
    }
    f.help = recursive ? "use a loop, or count the depth and stop before the tenth call" : "call the subs one after the other instead";
    return &f;
  });
}

}  // namespace

extern const Rule kOw210{
    .code = "OW210",
    .name = "call-too-deep",
    .summary = "a chain of calls, or recursion without an exit, beyond the nesting limit",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page = {
        .what = R"(A sub that calls a sub that calls a sub …, more than nine deep, or a sub that calls itself (directly
or through others) with nothing that stops it.)",
        .why = R"(LinuxCNC has room for nine open calls. At the tenth it stops, in the middle of whatever the ninth
was doing: a recursive pecking cycle with no exit makes nine pecks and halts.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
o<peck> sub
  G1 Z[0 - #1] F80
  G0 Z2
  o<peck> call [#1 + 2]
o<peck> endsub
G0 X10 Y10 Z2
o<peck> call [2]
M2
)",
        .good = R"(G21 G90
o<peck> sub
  #<depth> = 0
  o100 while [#<depth> LT #1]
    #<depth> = [#<depth> + 2]
    G1 Z[0 - #<depth>] F80
    G0 Z2
  o100 endwhile
o<peck> endsub
G0 X10 Y10 Z2
o<peck> call [12]
M2
)",
        .fix = R"(Use a `while` or `repeat` instead of recursion. A recursion with an exit is safe as long as it
cannot go nine deep.)",
        .interpreter = "Too many subroutine levels",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
