// OW411 sub-in-called-file: a `sub`, or an `endsub` with another label, inside the sub that is being called.
// Depends on: in a call, up to 2.9, a `sub` line does nothing and any `endsub` returns. From 2.10 the `sub` line stops (OW202).
#include <algorithm>

#include "rules/driver/stops.h"

namespace owlint::rules::ow411 {
namespace {

/// The sub whose body is left early: null where nothing of it is left.
const Region* cut_short(const Program& p, StatementId end) {
  const Region& region = p.regions[p.region_of[end]];
  return region.opener != kNoStatement && region.end != kNoStatement && region.end > end ? &region : nullptr;
}

/// Whether it is in a block of its sub, and so may be passed over.
bool in_block(const Program& p, StatementId statement) {
  const StatementId sub = p.regions[p.region_of[statement]].opener;
  return std::ranges::any_of(p.blocks, [&](const Block& b) {
    return sub < b.opener && b.opener < statement && b.end != kNoStatement && statement < b.end;
  });
}

/// The sub that a line is inside of. Of a `sub` line that begins a sub by itself: the one above it that is not closed.
const Region* around(const Input& in, StatementId id) {
  const Program& p = in.program;
  const Region& own = p.regions[p.region_of[id]];
  if (own.opener == kNoStatement) return nullptr;
  if (own.opener != id) return &own;
  const Region* open = nullptr;
  for (const Region& region : p.regions) {
    if (region.opener == kNoStatement || region.opener >= id || region.end != kNoStatement) continue;
    if (open == nullptr || region.opener > open->opener) open = &region;
  }
  return open;
}

Finding& report_sub(const Program& p, const Hazard& h, const Region& region, Reporter& out) {
  Finding& f = out.add(p.at(h.statement).head_span(),
                       "`" + p.head(h.statement) + "` is inside `" + p.head(region.opener) +
                           "`: its lines run here at once, and its `endsub` ends the outer sub");
  f.help = "move this sub to a file of its own, and give both a name that no other file uses";
  return f;
}

Finding& report_end(const Program& p, const Hazard& h, Reporter& out) {
  const Region& region = p.regions[p.region_of[h.statement]];
  const std::string ends = "`" + p.head(h.statement) + "` ends `" + p.label_text(region.name) + "`";
  Finding& f = out.add(p.at(h.statement).head_span(),
                       in_block(p, h.statement) ? ends + " here, as a `return` does; the label is another sub's"
                                                : ends + ": the lines below it do not run");
  const std::string own = p.label_text(region.name);
  f.help = "write `" + own + " return` to end the sub here, or remove the line";
  f.fixes.push_back({"write `" + own + " return`", false, {{p.at(h.statement).head_span(), own + " return"}}});
  return f;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    const bool sub = h.kind == HazardKind::kSubInCall;
    if (!sub && h.kind != HazardKind::kForeignEnd) continue;
    const Region* region = around(in, h.statement);
    if (region == nullptr) continue;
    // In the file that is checked the missing `endsub` is reported: OW204.
    if (region->end == kNoStatement && in.linked.files()[0].program.get() == &p) continue;
    if (!sub) {
      // The `endsub` of an inner `sub` is reported there, the only one of its sub by OW204.
      const bool of_inner = std::ranges::any_of(in.flow.hazards, [&](const Hazard& other) {
        return other.kind == HazardKind::kSubInCall && other.statement < h.statement &&
            p.at(other.statement).label == p.at(h.statement).label;
      });
      if (of_inner || cut_short(p, h.statement) == nullptr) continue;
    }
    Finding& f = sub ? report_sub(p, h, *region, out) : report_end(p, h, out);
    relate(f, p, region->opener, "the called sub begins here");
    f.reach = h.reach;
    f.runs_other = true;
    f.uncertain = !sub && in_block(p, h.statement);  // it is meant as a `return`, as it seems
    f.unproven = h.unproven || f.uncertain;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW411",
    .name = "sub-in-called-file",
    .summary = "a `sub`, or an `endsub` with another label, inside a called sub: other lines run than intended",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(Inside the sub of a called file there is another `sub`, or an `endsub` with another label.)",
            .why =
                R"(When LinuxCNC executes a called sub, a `sub` line does nothing, and **any** `endsub` returns to the
caller. So the inner sub runs as part of the outer one, with the outer sub's values, its `endsub`
ends the call, and the rest of the outer sub never runs. In the example the machine goes to X7 and
X57, and never to X3. There is no message.

LinuxCNC 2.10 stops at the inner `sub` (OW202).)",
            .bad = R"(G21 G90
o<outer> call [7]
M2
; file: outer.ngc
o<outer> sub
  G0 X[#1]
  o<step> sub
    G0 X[#1 + 50]
  o<step> endsub
  o<step> call [2]
  G0 X3
o<outer> endsub
)",
            .good = R"(G21 G90
o<outer> call [7]
M2
; file: outer.ngc
o<outer> sub
  G0 X[#1]
  o<step> call [2]
  G0 X3
o<outer> endsub
; file: step.ngc
o<step> sub
  G0 X[#1 + 50]
o<step> endsub
)",
            .fix = R"(Move the inner sub to a file of its own, with the sub's name. To leave a sub early, write `return`
with the sub's own label.)",
            .level_reason = "Error if some run gets to the line: the lines after it never run. Warning for an early "
                            "exit in a block, which works.",
            .interpreter = "",
            .options = "",
            .moves = "X57",
            .moves_good = "X3",
        },
    .check = check,
    .inner_sub = true,
};

}  // namespace owlint::rules::ow411
