// OW101 return-outside-sub: a `return` or `endsub` that is executed while no sub is running or being defined.
// Depends on: outside of calls and of skipped definitions, both are errors until the first call has
// come back. From then on `return` is ignored without a message, and `endsub` stops with another message.
#include <algorithm>

#include "rules/driver/stops.h"
#include "rules/driver/wrong_ends.h"

namespace owlint::rules::ow101 {
namespace {

/// The line above, as `o<f> sbu`, that was to begin the sub that this one ends.
StatementId misread_sub(const Input& in, StatementId id) {
  const auto found = in.index.subs.find(in.program.at(id).label);
  return found == in.index.subs.end() || found->second > id ? kNoStatement : found->second;
}

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  Finding& f = out.add(s.head_span(), "`" + p.head(id) + "` is not inside a sub");
  const Region& around = p.regions[p.region_of[id]];
  const StatementId end = around.early_end != kNoStatement && around.early_end < id ? around.early_end : kNoStatement;
  if (end != kNoStatement) {
    f.message += ": `" + p.head(end) + "` on line " + std::to_string(p.at(end).line) + " has already ended the sub";
    relate(f, p, end, "the sub ends here");
  }
  f.help = "remove the line, or end the program with `M2`";
  if (tell_wrong_end(p, id, f)) return &f;
  const StatementId misread = misread_sub(in, id);
  if (misread != kNoStatement && end == kNoStatement) {
    f.message += ": " + misread_words(p, misread);
    name_misread(p, misread, p.label_at(id) + " sub", f);
  } else if (s.is(Keyword::kReturn) && s.value_count == 0 && end == kNoStatement)
    f.fixes.push_back({"end the program here with `M2`", false, {{s.head_span(), "M2"}}});
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
    if (has_stop(in, id) || likely.contains(id) || misread_sub(in, id) != kNoStatement) continue;
    report(in, out, id)->reach = in.flow.reach(id);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW101",
    .name = "return-outside-sub",
    .summary = "`return` or `endsub` that is not inside a sub",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A `return` or `endsub` in the main program. It may be left over from code that was moved out of a
sub, the `sub` line may be gone, or somebody used `return` to end the program early.)",
            .why = R"(The interpreter stops when a run gets to such a line. In a branch that is not taken there is no
message. The message is `not in a subroutine definition: 'o110 return'`.

After a call has come back to the main program, LinuxCNC does something else: it ignores `return`
without a message, and the program **goes on with the next line**, which is the opposite of what was
meant. `endsub` then stops with `Not in subroutine definition`.

Under FEATURE 0x20 (`OWORD_WARNONLY`) `return` only prints the message, and the program goes on with
the next line. `endsub` still stops.)",
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
            .fix =
                R"(To end the program early, use `M2` or `M30`; they also work inside an `if`. If the line belongs to a
sub, put the `sub` line back before the sub's first line.)",
            .level_reason = "Error: the program stops here. Warning if no run gets to this line.",
            .interpreter = "not in a subroutine definition: 'o110 return'",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow101
