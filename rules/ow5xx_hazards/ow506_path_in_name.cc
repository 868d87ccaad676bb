// OW506 path-in-name: a called name that leads out of the search path.
// Depends on: LinuxCNC adds the name of an unknown sub to each folder of the search path, and opens that file.
#include "rules/driver/stops.h"

namespace owlint::rules::ow506 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Call& call : p.calls) {
    if (call.callee == kNoName || call.target != kNoRegion || p.at(call.statement).runs_remap()) continue;
    const std::string& name = p.name(call.callee);
    if (!leaves_folders(name)) continue;
    Finding& f = out.add(p.at(call.statement).head_span(),
                         "the called name `" + name + "` leads out of the machine's search path");
    f.help = "put the file into a folder of `SUBROUTINE_PATH`, and call it by its name only";
    f.reach = in.flow.reach(call.statement);
    f.never_ends = true;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW506",
    .name = "path-in-name",
    .summary = "a called name that leads out of the search path: absolute, `..`, `~` (security)",
    .group = Group::kHazards,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A `call` with a name that is an absolute path, begins with `~`, or has `..` in it.)",
            .why = R"(LinuxCNC 2.9 opens the file at that path and runs the sub of that name in it. So a program from
outside can run a file from anywhere on the controller, even from a memory stick. The shop's search
path, which should decide which subs may run, is not used. Other versions stop at the call.

owlint does not follow such names, so it does not check the called file.)",
            .bad = R"(G21 G90
o<../incoming/drill> call
M2
)",
            .good = R"(G21 G90
o<drill> sub
  G81 X0 Y0 Z-5 R2 F80
o<drill> endsub
o<drill> call
M2
)",
            .fix =
                R"(Move the file into the search path and call it by its name. Until then the program depends on where
the file is.)",
            .level_reason = "Error: a program from outside can reach files that are not meant for it.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow506
