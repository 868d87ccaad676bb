// OW409 file-percent-delimited: a sub file between `%` lines, called from a program between `%` lines.
// Depends on: in such a program every `%` line ends it, also one in a called file.
#include "rules/driver/stops.h"

namespace owlint::rules::ow409 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const Program& file = *stop.file;
    Finding& f = out.add(p.at(stop.statement).head_span(),
                         "`" + p.head(stop.statement) + "` finds a `%` before the sub in " + file.source->path() +
                             ": it ends this program");
    for (StatementId id = 0; id < file.size(); ++id) {
      if (file.at(id).kind != LineKind::kPercent) continue;
      relate(in, f, {&file, id}, "this `%`");
      break;
    }
    f.help = "remove the `%` lines from the called file";
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW409",
    .name = "file-percent-delimited",
    .summary = "a sub file with `%` lines, called from a program with `%` lines: the interpreter stops",
    .group = Group::kFiles,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A program between `%` lines calls a file that is between `%` lines too.)",
            .why = R"(In a program that begins with `%`, the next `%` line ends the program, even in a called file.
LinuxCNC finds the first `%` of the file before it finds the sub, and stops. A program without `%`
can call the same file.)",
            .bad = R"(%
G21 G90
o<slot> call
%
; file: slot.ngc
%
o<slot> sub
  G1 X10 F100
o<slot> endsub
%
)",
            .good = R"(%
G21 G90
o<slot> call
%
; file: slot.ngc
o<slot> sub
  G1 X10 F100
o<slot> endsub
)",
            .fix = R"(Remove the `%` lines from called files: they end with `endsub`.)",
            .level_reason = "Error if a run gets to the call: the program stops. Warning if no run does.",
            .interpreter = "Failed to find sub 'Oslot' before EOF",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow409
