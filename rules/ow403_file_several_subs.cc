// OW403 file-several-subs: more than one sub in a file that is called.
// Rests on: up to 2.9 subs behind the called one can be called from it; 2.10 refuses them.
#include <algorithm>

#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = out.add(p.at(stop.statement).head_span(), "`" + p.head(stop.statement) + "` calls another sub of its own file, which LinuxCNC 2.10 does not do");
    for (const Region& region : p.regions) {
      if (region.opener != kNoStatement && p.name(region.name) == stop.detail) relate(f, p, region.opener, "this is the sub");
    }
    f.help = "put the sub into a file of its own";
    return &f;
  });
  if (!p.sub_file) return;
  const Region* entry = nullptr;
  for (const Region& region : p.regions) {
    if (region.opener != kNoStatement && region.name == p.entry && entry == nullptr) entry = &region;
  }
  for (const Region& region : p.regions) {
    if (region.opener == kNoStatement || region.name == p.entry || !p.at(region.opener).is(Keyword::kSub)) continue;
    const bool stops = std::ranges::any_of(p.calls, [&](const Call& call) { return call.callee == region.name && has_stop(in, call.statement); });
    if (stops) continue;
    Finding& f = out.add(p.at(region.opener).head_span(), "`" + p.label_text(region.name) + "` is a second sub in a file that is called for `" + p.label_text(p.entry) + "`");
    relate(f, p, entry->opener, "the file is called for this one");
    f.help = "put it into a file of its own: LinuxCNC 2.10 stops where it is called";
    f.reach = in.flow.reach(region.opener);
  }
}

}  // namespace

extern const Rule kOw403{
    .code = "OW403",
    .name = "file-several-subs",
    .summary = "more than one sub in a called file (documented as not allowed; fatal from 2.10 when met)",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page = {
        .what = R"(A file that is called for the sub it is named after defines more subs.)",
        .why = R"(The documentation allows one sub for each file. Up to LinuxCNC 2.9 a sub that stands **behind** the called one can be called
from it all the same (one before it can not, see OW404), and it stays known for the rest of the run: a second file with a
helper of the same number then meets `redefining sub`. LinuxCNC 2.10 refuses the call of the helper.)",
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
        .fix = R"(Move the helper into a file of its own, named after it.)",
        .interpreter = "",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
