// OW202 sub-nested: a `sub` line inside the body of another sub.
// Rests on: while a definition is passed over, another `sub` (or a bare O number) is an error,
// called or not. From 2.10 the same holds in called files.
#include <algorithm>

#include "rules/stops.h"

namespace owlint::rules {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id, RegionId outer) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  const std::string what = s.is(Keyword::kBare) ? "the program number `" + p.head(id) + "`" : "`" + p.head(id) + "`";
  if (outer == kMainRegion) {
    Finding& f = out.add(s.head_span(), what + " stands inside the definition of another sub");
    f.help = "close the sub before it";
    return &f;
  }
  const Region& region = p.regions[outer];
  const std::string began = " on line " + std::to_string(p.at(region.opener).line);
  Finding& f = out.add(s.head_span(), region.end == kNoStatement
                                          ? what + " begins before `" + p.head(region.opener) + "`" + began + " is closed"
                                          : what + " stands inside `" + p.head(region.opener) + "`, which begins" + began);
  relate(f, p, region.opener, "the sub around it begins here");
  f.help = region.end == kNoStatement ? "close it with `" + p.label_text(region.name) + " endsub`" : "move this sub out of the other one";
  if (region.end != kNoStatement && s.is(Keyword::kSub)) {
    const auto lines = p.by_label[s.label];
    const auto end = std::ranges::find_if(std::ranges::upper_bound(lines, id), lines.end(), [&](StatementId line) { return p.at(line).is(Keyword::kEndsub); });
    if (end != lines.end() && *end < region.end) f.fixes.push_back(move_up(p, id, *end, region.opener, "move it out, before the other one"));
  }
  return &f;
}

/// The definition that is being passed over at `id`: the one that holds it, or an unclosed one before it.
RegionId around(const Program& p, StatementId id) {
  if (p.region_of[id] != kMainRegion && p.regions[p.region_of[id]].opener != id) return p.region_of[id];
  for (RegionId r = static_cast<RegionId>(p.regions.size()); r-- > 1;) {
    if (p.regions[r].opener < id && p.regions[r].end == kNoStatement) return r;
  }
  return kMainRegion;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement, around(p, s.statement)); });
  for (const StatementId id : in.index.sub_lines) {
    const RegionId region = p.region_of[id];
    if (!p.at(id).is(Keyword::kSub) || region == kMainRegion || p.regions[region].opener == id || has_stop(in, id)) continue;
    report(in, out, id, region)->reach = in.flow.reach(id);
  }
}

}  // namespace

extern const Rule kOw202{
    .code = "OW202",
    .name = "sub-nested",
    .summary = "`sub` inside another sub's body",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page = {
        .what = R"(A sub that is defined between the `sub` and the `endsub` of another one. A bare program number such
as `o300` on a line of its own counts as well. Often it is a forgotten `endsub` in front.)",
        .why = R"(The interpreter stops at the inner line while it reads over the outer definition, before the first
move, even if nobody calls either of them. In a called file LinuxCNC up to 2.9 lets it pass; from
2.10 it stops there too.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
o100 sub
  o110 sub
    G81 X#1 Y#2 Z-5 R2 F80
  o110 endsub
  o110 call [#1] [10]
  o110 call [#1] [30]
o100 endsub
o100 call [20]
G80
M2
)",
        .good = R"(G21 G90
o110 sub
  G81 X#1 Y#2 Z-5 R2 F80
o110 endsub
o100 sub
  o110 call [#1] [10]
  o110 call [#1] [30]
o100 endsub
o100 call [20]
G80
M2
)",
        .fix = R"(Define the subs one after the other. A sub may call any sub that stands above it.)",
        .interpreter = "Nested subroutine definition",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
