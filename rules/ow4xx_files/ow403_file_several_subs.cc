// OW403 file-several-subs: more than one sub in a file that is called.
// Depends on: up to 2.9 the called sub can call subs after it in the file; 2.10 stops.
#include <algorithm>

#include "rules/driver/stops.h"

namespace owlint::rules::ow403 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f =
        out.add(p.at(stop.statement).head_span(),
                "`" + p.head(stop.statement) + "` calls another sub in the same file; LinuxCNC 2.10 stops here");
    for (const Region& region : p.regions) {
      if (region.opener != kNoStatement && p.name(region.name) == stop.detail)
        relate(f, p, region.opener, "this is the sub");
    }
    f.help = "move that sub into a file of its own";
    return &f;
  });
  if (!p.sub_file) return;
  const Region* entry = nullptr;
  for (const Region& region : p.regions) {
    if (region.opener != kNoStatement && region.name == p.entry && entry == nullptr) entry = &region;
  }
  for (const Region& region : p.regions) {
    if (region.opener == kNoStatement || region.name == p.entry || !p.at(region.opener).is(Keyword::kSub)) continue;
    const bool stops = std::ranges::any_of(
        p.calls, [&](const Call& call) { return call.callee == region.name && has_stop(in, call.statement); });
    if (stops) continue;
    Finding& f =
        out.add(p.at(region.opener).head_span(),
                "`" + p.label_text(region.name) + "` is a second sub in the file of `" + p.label_text(p.entry) + "`");
    relate(f, p, entry->opener, "calls of this file run this sub");
    f.help = "move it into a file of its own: if another file also has `" + p.label_text(region.name) +
        "`, LinuxCNC calls the first one for both, and 2.10 stops at the call";
    f.reach = in.flow.reach(region.opener);
    f.group = "second sub " + p.label_text(region.name);  // the same helper in several files
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW403",
    .name = "file-several-subs",
    .summary = "more than one sub in a called file: LinuxCNC 2.10 stops at the call of the second",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A called file defines other subs besides the one with its own name.)",
            .why = R"(The documentation allows one sub in each file. Up to LinuxCNC 2.9, the called sub can still call a
sub **after** it in the file (but not one before it, see OW404). That sub then stays known for the
rest of the run, so a second file with a helper of the same number calls this one instead of its own
(OW410). LinuxCNC 2.10 stops at the call of the helper.)",
            .bad = R"(G21 G90
o<pocket> call [20]
M2
; file: pocket.ngc
o<pocket> sub
  o100 call [#1]
o<pocket> endsub
o100 sub
  G1 X#1 F300
o100 endsub
)",
            .good = R"(G21 G90
o<pocket> call [20]
M2
; file: pocket.ngc
o<pocket> sub
  o<pocket_side> call [#1]
o<pocket> endsub
; file: pocket_side.ngc
o<pocket_side> sub
  G1 X#1 F300
o<pocket_side> endsub
)",
            .fix = R"(Move the helper into a file of its own, with the helper's name.)",
            .level_reason = "Error in the versions that stop there. Warning in the others: the documentation does not "
                            "allow it, and LinuxCNC 2.10 stops.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow403
