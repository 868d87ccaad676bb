// OW204 sub-not-closed: a `sub` whose `endsub` is missing or has another label.
// Depends on: the interpreter skips a definition up to its own label; only the end of the file ends
// the skip too, and another `sub` on the way is a nesting error.
#include <algorithm>

#include "rules/driver/modes.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow204 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const Region& region = p.regions[p.region_of[id]];
  Finding& f = out.add(p.at(id).head_span(), "`" + p.head(id) + "` is not closed");
  const std::string end = p.label_at(id) + " endsub";
  f.help = "write `" + end + "` where the sub ends";
  if (region.opener == id && region.likely_end != kNoStatement) {
    const Statement& other = p.at(region.likely_end);
    if (ends_block(other.keyword) && !other.refused) {
      const std::string line = "line " + std::to_string(other.line);
      f.message += ": `" + p.head(region.likely_end) + "` on " + line + " does not end it";
      relate(f, p, region.likely_end, "this is probably meant to be `" + end + "`");
      f.help = "write `" + end + "` on " + line;
      f.fixes.push_back({"write `" + end + "`", false, {{other.head_span(), end}}});
      return &f;
    }
    if (!other.is(Keyword::kEndsub) || other.refused) {
      f.message += ": " + misread_words(p, region.likely_end);
      name_misread(p, region.likely_end, end, f);
      if (other.kind == LineKind::kWords && !f.fixes.empty()) f.fixes[0].safe = true;
      return &f;
    }
    f.message += ": `" + p.head(region.likely_end) + "` on line " + std::to_string(other.line) + " has another label";
    relate(f, p, region.likely_end, "this is probably meant to be `" + end + "`");
    f.help = "write `" + end + "` on line " + std::to_string(other.line);
    f.fixes.push_back({"write `" + end + "`", true, {{other.head_span(), end}}});
  }
  return &f;
}

/// A sub for M98 without `M99` at its end: LinuxCNC goes on into the one below it.
void report_running_on(const Input& in, Reporter& out, const Hazard& h) {
  const Program& p = in.program;
  const Statement& next = p.at(h.statement);
  if (find_word(words_of(*p.source, p.at(h.statement - 1).whole()), "M99") != nullptr)
    return;  // OW217: it does not act
  const Region& before = p.regions[p.region_of[h.statement - 1]];
  const std::string name = before.opener == kNoStatement ? "the sub above" : "`" + p.head(before.opener) + "`";
  Finding& f =
      out.add(next.head_span(), name + " has no `M99` at its end: LinuxCNC goes on into `" + p.head(h.statement) + "`");
  if (before.opener != kNoStatement) relate(f, p, before.opener, "this sub begins here");
  f.help = "write `M99` before this line";
  f.fixes.push_back({f.help, false, {{{next.offset, next.offset}, "M99" + line_end(*p.source, next)}}});
  f.reach = h.reach;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  std::vector<bool> done(p.size());
  for_stops(in, out, [&](const FlowStop& s) {
    done[s.statement] = true;
    return report(in, out, s.statement);
  });
  StatementId last_nested = 0;
  if (const auto nested = in.index.by_code.find("OW202"); nested != in.index.by_code.end()) {
    for (const FlowStop* s : nested->second) last_nested = std::max(last_nested, s->statement);
  }
  for (const Region& region : p.regions) {
    if (region.opener == kNoStatement || region.end != kNoStatement || !p.at(region.opener).is(Keyword::kSub)) continue;
    if (p.at(region.opener).inner_cr || p.at(region.opener).refused) continue;
    // A `sub` that begins before this one is closed stops the interpreter there and is reported there.
    if (done[region.opener] || last_nested > region.opener) continue;
    if (region.likely_end != kNoStatement && has_stop(in, region.likely_end)) continue;
    // Its `sub` was meant as the end of the one above.
    const Region& above = *std::prev(p.regions.begin() + (&region - p.regions.data()));
    if (last_nested == region.opener && above.name == region.name && above.end == kNoStatement) continue;
    report(in, out, region.opener)->reach = in.flow.reach(region.opener);
  }
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind == HazardKind::kRunsIntoSub && h.other == kNoStatement) report_running_on(in, out, h);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW204",
    .name = "sub-not-closed",
    .summary = "`sub` without its `endsub`",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A `sub` line without an `endsub` of the same label below it. If an `endsub` with another label is in
the right place, the finding names it. Or a sub for `M98` (`O100`) without `M99` at its end: LinuxCNC
goes on into the sub below it.)",
            .why =
                R"(The interpreter skips everything below the `sub`, including `M2`, and stops at the end of the file.
The program makes no move, and the message is about the end of the file, not about the sub. From
2.9.10 on the message is `File ended with no percent sign (%) or program end (M2)`; in a program
between `%` signs it is `Failed to find sub 'O100' before EOF`; if another `sub` follows, it is
`Nested subroutine definition`.

If a call enters such a sub at the end of the file, and `M2` ends it, the program runs without a
message and never comes back from the call.)",
            .bad = R"(G21 G90
o100 sub
  G81 X#1 Y#2 Z-5 R2 F80
  G80
o101 endsub
o100 call [10] [20]
M2
)",
            .good = R"(G21 G90
o100 sub
  G81 X#1 Y#2 Z-5 R2 F80
  G80
o100 endsub
o100 call [10] [20]
M2
)",
            .fix = R"(Give the `endsub` the label of its `sub`, or add the missing line.)",
            .level_reason =
                "Error if a run reads to the end of the file: the program stops there. Warning if the sub runs anyway.",
            .interpreter = "File ended with no percent sign or program end",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow204
