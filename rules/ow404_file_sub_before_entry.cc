// OW404 file-sub-before-entry: a helper that stands before the called sub in its file.
// Rests on: the interpreter passes over what stands before the called sub, and does not note it.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = out.add(p.at(stop.statement).head_span(), "`" + p.head(stop.statement) + "` calls a sub that stands before the called one in this file: LinuxCNC did not see it");
    for (const Region& region : p.regions) {
      if (region.opener != kNoStatement && p.name(region.name) == stop.detail) {
        relate(f, p, region.opener, "defined here, and passed over");
        break;
      }
    }
    f.help = "put the helper into a file of its own, named `" + stop.detail + ".ngc`";
    return &f;
  });
}

}  // namespace

extern const Rule kOw404{
    .code = "OW404",
    .name = "file-sub-before-entry",
    .summary = "a helper defined before the called sub in its file is not visible to it",
    .group = Group::kFiles,
    .level = Severity::kError,
    .page = {
        .what = R"(A called file has a helper sub in front of the sub that it is named after, and the latter calls it.)",
        .why = R"(To call `o<drill>` LinuxCNC reads `drill.ngc` for the line `o<drill> sub` and takes no note of anything before it. A call
of a sub from there is looked for as a file, and then from the call on to the end of the file, where it is not.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
o<drill> call [10]
M2
; file: drill.ngc
o<peck> sub
  G81 X#1 Y0 Z-5 R2 F80
o<peck> endsub
o<drill> sub
  o<peck> call [#1]
o<drill> endsub
)",
        .good = R"(G21 G90
o<drill> call [10]
M2
; file: drill.ngc
o<drill> sub
  o<peck> call [#1]
o<drill> endsub
; file: peck.ngc
o<peck> sub
  G81 X#1 Y0 Z-5 R2 F80
o<peck> endsub
)",
        .fix = R"(Give the helper a file of its own. Behind the called sub it would run up to LinuxCNC 2.9, and stop from 2.10 on.)",
        .interpreter = "EOF in file:FILE seeking o-word: o<peck> from line: N",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
