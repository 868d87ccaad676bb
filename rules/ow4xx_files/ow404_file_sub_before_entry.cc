// OW404 file-sub-before-entry: a helper before the called sub in its file.
// Depends on: the interpreter ignores everything before the called sub.
#include "rules/driver/stops.h"

namespace owlint::rules::ow404 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    Finding& f = out.add(p.at(stop.statement).head_span(),
                         "`" + p.head(stop.statement) +
                             "` calls a sub that comes before the called one in this file: LinuxCNC does not know it");
    for (const Region& region : p.regions) {
      if (region.opener != kNoStatement && p.name(region.name) == stop.detail) {
        relate(f, p, region.opener, "defined here, but LinuxCNC skips this line");
        break;
      }
    }
    f.help = "move the helper into a file of its own, named `" + stop.detail + ".ngc`";
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW404",
    .name = "file-sub-before-entry",
    .summary = "a helper before the called sub in its file is unknown",
    .group = Group::kFiles,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A called file has a helper sub before the sub with the file's name, and that sub calls the helper.)",
            .why =
                R"(For `o<drill> call` LinuxCNC reads `drill.ngc` up to the line `o<drill> sub` and ignores everything
before it. When the sub calls the helper, LinuxCNC looks for a file with the helper's name, and then
from the call to the end of the file. It does not find the helper, and stops.)",
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
            .fix =
                R"(Give the helper a file of its own. If you move it after the called sub, it runs up to LinuxCNC 2.9,
and stops from 2.10 on.)",
            .level_reason = "Error if a run gets to the call: the program stops. Warning if no run does.",
            .interpreter = "EOF in file:FILE seeking o-word: o<peck> from line: N",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow404
