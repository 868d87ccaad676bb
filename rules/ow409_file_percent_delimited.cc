// OW409 file-percent-delimited: a sub file between `%` lines, called from a program between `%` lines.
// Rests on: in such a program every `%` line ends it, also one in a called file.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const Program& file = *stop.file;
    Finding& f = out.add(p.at(stop.statement).head_span(), "`" + p.head(stop.statement) + "` finds a `%` in " + file.source->path() + " before the sub, which ends this program");
    for (StatementId id = 0; id < file.size(); ++id) {
      if (file.at(id).kind != LineKind::kPercent) continue;
      relate(in, f, {&file, id}, "this line");
      break;
    }
    f.help = "take the `%` lines out of the called file";
    return &f;
  });
}

}  // namespace

extern const Rule kOw409{
    .code = "OW409",
    .name = "file-percent-delimited",
    .summary = "a `%`-delimited sub file called from a `%`-delimited program: the interpreter stops",
    .group = Group::kFiles,
    .level = Severity::kError,
    .page = {
        .what = R"(A program that stands between `%` lines calls a file that does so too.)",
        .why = R"(In a program that begins with `%`, the next `%` line that is read ends it. That is true of the lines of a called file as
well: LinuxCNC finds the first `%` there before it finds the sub, and stops. From a program without `%` the same file can
be called.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
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
        .fix = R"(Take the `%` lines out of files that are called: they end with `endsub`.)",
        .interpreter = "Failed to find sub 'Oslot' before EOF",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
