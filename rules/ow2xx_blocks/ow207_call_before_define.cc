// OW207 call-before-define: a `call` above the definition of its sub.
// Depends on: the interpreter looks ahead for an unknown sub; its `sub` line then counts as reached,
// and running into it later is an error.
#include <algorithm>

#include "rules/driver/stops.h"

namespace owlint::rules::ow207 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  Finding& f = out.add(p.at(id).head_span(), "the program runs into `" + p.head(id) + "`");
  for (const Call& call : p.calls) {
    if (call.statement >= id) break;
    if (call.callee != p.at(id).label) continue;
    f.message += " after line " + std::to_string(p.at(call.statement).line) + " has called it";
    relate(f, p, call.statement, "called here, before the definition");
    const Region& region = p.regions[p.region_of[id]];
    if (region.opener == id && region.end != kNoStatement)
      f.fixes.push_back(move_up(p, id, region.end, outermost(p, call.statement), "move the sub above its first call"));
    break;
  }
  f.help = "move the sub above its first call, or below the program end";
  return &f;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  // A definition between its call and the program end is wrong too where no run gets.
  const auto missed = [&](const Call& call) { return call.caller == kMainRegion && !in.flow.executed[call.statement]; };
  if (std::ranges::none_of(p.calls, missed)) return;
  std::unordered_map<NameId, StatementId> first_call;
  for (const Call& call : p.calls) {
    if (call.caller == kMainRegion) first_call.emplace(call.callee, call.statement);
  }
  std::vector<StatementId> ends;
  std::ranges::copy_if(in.index.ends, std::back_inserter(ends),
                       [&](StatementId id) { return p.region_of[id] == kMainRegion; });
  for (const Region& region : p.regions) {
    if (region.opener == kNoStatement || has_stop(in, region.opener) || !p.at(region.opener).is(Keyword::kSub))
      continue;
    const auto call = first_call.find(region.name);
    if (call == first_call.end() || call->second > region.opener || in.flow.executed[call->second]) continue;
    const auto end = std::ranges::lower_bound(ends, call->second);
    if (end == ends.end() || *end > region.opener) report(in, out, region.opener)->reach = in.flow.reach(region.opener);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW207",
    .name = "call-before-define",
    .summary = "`call` before the definition",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A `call` of a sub that is defined further down. It is an error if the program then runs into the
definition, and a warning if no run gets there.)",
            .why = R"(LinuxCNC looks ahead for the `sub` line, runs the sub, and goes on after the `call`. When the
program later comes to the definition itself, it stops, although it is the same sub; the parts
before are already cut. If `M2` or `M30` comes between the calls and the definition, it works.

While it looks ahead, LinuxCNC does not see other subs on the way. If the called sub calls one of
them, the program stops with `EOF in file … seeking o-word`.)",
            .bad = R"(G21 G90
o100 call [10]
o100 call [30]
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
M2
)",
            .good = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
o100 call [30]
M2
)",
            .fix =
                R"(Put all subs at the top of the program. If they have to be at the bottom, end the program with `M2`
before them.)",
            .level_reason = "Error if the program runs into the definition: the program stops. Warning if no run does.",
            .interpreter = "sub: o|100| found in illegal location",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow207
