// OW202 sub-nested: a `sub` line inside the body of another sub.
// Depends on: while a definition is skipped, another `sub` (or a bare O number) is an error,
// called or not. From 2.10 on the same holds in called files.
#include <algorithm>

#include "rules/driver/block_helpers.h"
#include "rules/driver/idioms.h"

namespace owlint::rules::ow202 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id, RegionId outer) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  const std::string what = s.is(Keyword::kBare) ? "the program number `" + p.head(id) + "`" : "`" + p.head(id) + "`";
  if (s.is(Keyword::kBare) && meant_by(p, id).keyword != Keyword::kUnknown) {
    Finding& f =
        out.add(s.head_span(), "the label's name has no `>`: LinuxCNC reads the line as the beginning of another sub");
    if (s.name_open) {
      const Meant meant = meant_by(p, id);
      f.help = "write `" + std::string(p.source->slice({meant.words.begin, meant.name_end})) + "> " +
          std::string(spelling(meant.keyword)) + "`";
      f.fixes.push_back({f.help, false, {{{meant.name_end, meant.name_end}, ">"}}});
    } else {
      explain_idiom(in, id, f);
    }
    return &f;
  }
  if (is_forgotten_end(p, id)) {
    Finding& f = out.add(s.head_span(), "");
    tell_forgotten_end(p, id, f);
    return &f;
  }
  if (lacks_call(in, id)) {
    Finding& f = out.add(s.head_span(), "`" + p.head(id) + "` alone on a line calls nothing, and stops in a sub");
    f.help = "write `" + p.head(id) + " call`";
    return &f;
  }
  if (outer == kMainRegion) {
    Finding& f = out.add(s.head_span(), what + " is inside another sub");
    f.help = "close the other sub before this line";
    return &f;
  }
  const Region& region = p.regions[outer];
  const std::string began = " on line " + std::to_string(p.at(region.opener).line);
  Finding& f = out.add(s.head_span(),
                       region.end == kNoStatement
                           ? what + " begins before `" + p.head(region.opener) + "`" + began + " is closed"
                           : what + " is inside `" + p.head(region.opener) + "`, which begins" + began);
  relate(f, p, region.opener, "the outer sub begins here");
  if (region.end == kNoStatement && s.is(Keyword::kSub) && s.label == region.name) {
    f.message = "`" + p.head(id) + "` does not close `" + p.head(region.opener) + "`" + began +
        ": LinuxCNC reads it as the beginning of another sub";
    f.help = "write `" + p.label_text(region.name) + " endsub`";
    f.fixes.push_back({f.help, false, {{s.head_span(), p.label_text(region.name) + " endsub"}}});
    return &f;
  }
  f.help = region.end == kNoStatement ? "close it with `" + p.label_text(region.name) + " endsub`"
                                      : "move this sub out of the other one";
  if (region.end != kNoStatement && s.is(Keyword::kSub) && s.label != kNoName) {
    const auto lines = p.by_label[s.label];
    const auto end = std::ranges::find_if(std::ranges::upper_bound(lines, id), lines.end(),
                                          [&](StatementId line) { return p.at(line).is(Keyword::kEndsub); });
    if (end != lines.end() && *end < region.end)
      f.fixes.push_back(move_up(p, id, *end, region.opener, "move this sub before the other one"));
  }
  return &f;
}

/// The definition that is being skipped at `id`: the one around it, or an unclosed one before it.
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
    if (!p.at(id).is(Keyword::kSub) || region == kMainRegion || p.regions[region].opener == id || has_stop(in, id))
      continue;
    if (std::ranges::any_of(in.flow.hazards,
                            [id](const Hazard& h) { return h.kind == HazardKind::kSubInCall && h.statement == id; }))
      continue;  // OW411
    report(in, out, id, region)->reach = in.flow.reach(id);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW202",
    .name = "sub-nested",
    .summary = "a `sub` inside another sub",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A sub that is defined between the `sub` and the `endsub` of another one. A program number such as
`o300` on a line of its own counts too. Often the `endsub` of the first sub is missing.)",
            .why = R"(The interpreter stops at the inner `sub` line when it skips the outer definition: before the first
move, even if nothing calls either of them. In a called file LinuxCNC up to 2.9 accepts it; from
2.10 on it stops there too.)",
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
            .fix = R"(Define the subs one after the other. A sub may call any sub that is defined above it.)",
            .level_reason = "Error if LinuxCNC reads the inner `sub`: the program stops there. Warning if no run does.",
            .interpreter = "Nested subroutine definition",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow202
