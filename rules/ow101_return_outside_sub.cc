// OW101 return-outside-sub: a `return` or `endsub` that is executed while no sub is running or being defined.
// Rests on: at call level 0 with no definition being passed over, both are refused, until a first
// call has come back; from then on `return` is passed over silently and `endsub` stops with
// another message.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  Finding& f = out.add(s.head_span(), "`" + p.head(id) + "` is not inside a sub");
  const Region& around = p.regions[p.region_of[id]];
  const StatementId end = around.early_end != kNoStatement && around.early_end < id ? around.early_end : kNoStatement;
  if (end != kNoStatement) {
    f.message += ": `" + p.head(end) + "` on line " + std::to_string(p.at(end).line) + " has already ended it";
    relate(f, p, end, "the definition ends here");
  }
  f.help = "remove the line, or end the program with `M2`";
  if (s.is(Keyword::kReturn) && s.value_count == 0 && end == kNoStatement) f.fixes.push_back({"end the program here with `M2`", false, {{s.head_span(), "M2"}}});
  return &f;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  const auto stop = [&](const FlowStop& s) { return report(in, out, s.statement); };
  for_stops(in, out, stop);
  for_warned(in, out, stop);
  std::unordered_set<StatementId> likely;
  for (const Region& region : p.regions) {
    if (region.likely_end != kNoStatement) likely.insert(region.likely_end);
  }
  for (const StatementId id : in.index.sub_lines) {
    if (p.at(id).is(Keyword::kSub) || p.region_of[id] != kMainRegion) continue;
    if (has_stop(in, id) || likely.contains(id)) continue;
    report(in, out, id)->reach = in.flow.reach(id);
  }
}

}  // namespace

extern const Rule kOw101{
    .code = "OW101",
    .name = "return-outside-sub",
    .summary = "`return` or `endsub` that is not within a sub definition",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page = {
        .what = R"(A `return` or `endsub` in the main program: left behind after moving code out of a sub, the end of a
sub whose `sub` line is gone, or `return` used to leave the program early.)",
        .why = R"(The interpreter stops where a run gets to such a line; in a branch that is not taken nothing is
said. The message is `not in a subroutine definition: 'o110 return'`.

Once a call has come back to the main program it behaves otherwise: `return` there is passed over
without a word and the program **goes on below it**, which is the opposite of what was meant;
`endsub` stops with `Not in subroutine definition`.

Under FEATURE 0x20 (`OWORD_WARNONLY`) `return` is only reported and the program goes on with the
next line; `endsub` stops all the same.)",
        .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 0]
  G0 Z5
  o110 return
o100 endif
G10 L20 P1 Z0
G0 Z5
M2
)",
        .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 0]
  G0 Z5
  M2
o100 endif
G10 L20 P1 Z0
G0 Z5
M2
)",
        .fix = R"(To end the program early use `M2` or `M30`: they work inside an `if` too. If the line belongs to a
sub, put the `sub` line back in front of the body.)",
        .interpreter = "not in a subroutine definition: 'o110 return'",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
