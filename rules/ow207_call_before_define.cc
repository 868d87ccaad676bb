// OW207 call-before-define: a `call` that stands above the definition of its sub.
// Rests on: an unknown sub is looked for by reading ahead; its `sub` line then counts as met, and
// running into it later is an error, from that very line.
#include <algorithm>

#include "rules/stops.h"

namespace owlint::rules {
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
    if (region.opener == id && region.end != kNoStatement) f.fixes.push_back(move_up(p, id, region.end, outermost(p, call.statement), "move the definition above its first call"));
    break;
  }
  f.help = "move the definition above its first call, or below the program end";
  return &f;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  // In lines that no run gets to, a definition between its call and the program end is wrong all the same.
  const auto missed = [&](const Call& call) { return call.caller == kMainRegion && !in.flow.executed[call.statement]; };
  if (std::ranges::none_of(p.calls, missed)) return;
  std::unordered_map<NameId, StatementId> first_call;
  for (const Call& call : p.calls) {
    if (call.caller == kMainRegion) first_call.emplace(call.callee, call.statement);
  }
  std::vector<StatementId> ends;
  std::ranges::copy_if(in.index.ends, std::back_inserter(ends), [&](StatementId id) { return p.region_of[id] == kMainRegion; });
  for (const Region& region : p.regions) {
    if (region.opener == kNoStatement || has_stop(in, region.opener) || !p.at(region.opener).is(Keyword::kSub)) continue;
    const auto call = first_call.find(region.name);
    if (call == first_call.end() || call->second > region.opener || in.flow.executed[call->second]) continue;
    const auto end = std::ranges::lower_bound(ends, call->second);
    if (end == ends.end() || *end > region.opener) report(in, out, region.opener)->reach = in.flow.reach(region.opener);
  }
}

}  // namespace

extern const Rule kOw207{
    .code = "OW207",
    .name = "call-before-define",
    .summary = "`call` before the definition",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page = {
        .what = R"(A sub that is called further up than it is defined. It is an error where the flow then runs into the
definition, a warning where the program ends before it.)",
        .why = R"(LinuxCNC reads ahead to the `sub` line, runs the body and goes on after the `call`. When it later
comes to the definition in the normal course of the program it stops, although it is the same sub:
the parts above are already cut. With `M2` or `M30` between the calls and the definition it works.

Reading ahead leaves out everything on the way: other subs defined between the call and this one are
not known inside it, and a call of one of them from there stops with `EOF in file … seeking o-word`.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
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
        .fix = R"(Put all definitions at the top of the program. Where they have to stand below, end the program with
`M2` in front of them.)",
        .interpreter = "sub: o|100| found in illegal location",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
