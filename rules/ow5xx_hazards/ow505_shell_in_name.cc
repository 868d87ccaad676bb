// OW505 shell-in-name: a called name that LinuxCNC passes to a shell.
// Depends on: the name of an unknown sub is expanded as a shell does, commands included (measured, 2.9).
#include "rules/driver/stops.h"

namespace owlint::rules::ow505 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  if (in.profile.version < Version::k2_9) return;  // earlier versions open the name as it is
  for (const Call& call : p.calls) {
    if (call.callee == kNoName || p.at(call.statement).runs_remap()) continue;
    const std::string& name = p.name(call.callee);
    const bool command = expands(name);
    const bool breaks = breaks_expansion(name);
    if (!command && !breaks) continue;
    // A sub that the program defines is found before any file is looked for.
    if (call.target != kNoRegion && p.regions[call.target].opener < call.statement) continue;
    Finding& f = out.add(
        p.at(call.statement).head_span(),
        command ? "LinuxCNC passes the called name `" + name + "` to a shell, which can run commands on the controller"
                : "LinuxCNC crashes when it looks for a file with the name `" + name + "`");
    f.help = command ? "do not run this program until you know who wrote it and why; use only small letters, digits, "
                       "`-` and `_` in names of subs"
                     : "use only small letters, digits, `-` and `_` in the name of the sub";
    f.reach = in.flow.reach(call.statement);
    f.stops = breaks && f.reach != Reach::kNever && !has_stop(in, call.statement);
    f.never_ends = f.stops || command;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW505",
    .name = "shell-in-name",
    .summary = "a called name that LinuxCNC passes to a shell (security)",
    .group = Group::kHazards,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A `call` whose name has characters with a meaning for a shell: a back quote or `$`, or characters
such as `&`, `;`, `|`, brackets or an open quote.)",
            .why =
                R"(To find the file of an unknown sub, LinuxCNC 2.9 and later expand the called name as a shell does. A
back quote or `$` in the name **runs a command** with the rights of the user who started the machine
control, before any motion and without asking. No honest program needs such a name: treat the file
like an unknown program. With the other characters the expansion fails, and LinuxCNC crashes.

owlint expands nothing and looks for no such file.)",
            .bad = R"(G21 G90
o<drill&tap> call
M2
)",
            .good = R"(G21 G90
o<drill-tap> sub
  G81 X0 Y0 Z-5 R2 F80
o<drill-tap> endsub
o<drill-tap> call
M2
)",
            .fix = R"(Do not run a program with such a name until you know where it comes from. If the name is a typing
error, correct it.)",
            .level_reason = "Error: a program from outside can run any command on the machine's computer.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow505
