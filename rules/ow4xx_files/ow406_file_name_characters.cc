// OW406 file-name-characters: a called file whose name has characters that the documentation does not allow.
// Depends on: such names run today, but LinuxCNC's documentation does not say so.
#include "rules/driver/stops.h"

namespace owlint::rules::ow406 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Call& call : p.calls) {
    if (call.callee == kNoName || call.target != kNoRegion || p.at(call.statement).runs_remap()) continue;
    const std::string& name = p.name(call.callee);
    // What a shell would look at, and what leads out of the folders, is said by OW505 and OW506.
    if (expands(name) || breaks_expansion(name) || leaves_folders(name)) continue;
    const bool known = in.linked.target(name).file != CallTarget::kNotFound;
    const size_t odd = name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_");
    if (odd == std::string::npos || !known) continue;
    const auto byte = static_cast<unsigned char>(name[odd]);
    const std::string which = byte >= 0x80 ? "a letter that is not English" : "`" + std::string(1, name[odd]) + "`";
    Finding& f =
        out.add(p.at(call.statement).head_span(),
                "the called name `" + name + "` has " + which + " in it; LinuxCNC's documentation does not allow that");
    f.help = "use only small letters, digits, `-` and `_` in the name of the file and of its sub";
    f.reach = in.flow.reach(call.statement);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW406",
    .name = "file-name-characters",
    .summary = "a called name with characters other than small letters, digits, `-` and `_`",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A call of a file whose name has other characters than small letters, digits, `-` and `_`: for
example a dot, a slash or an umlaut.)",
            .why = R"(The documentation allows only these characters. Others may work: with a path (`o<subs/drill>`)
LinuxCNC 2.9 calls the sub `drill` of that file, but 2.8 and 2.10 stop. LinuxCNC also expands the
name as a shell does, which makes some characters dangerous (OW505).)",
            .bad = R"(G21 G90
o<drill.v2> call
M2
; file: drill.v2.ngc
o<drill.v2> sub
  G81 X0 Y0 Z-5 R2 F80
o<drill.v2> endsub
)",
            .good = R"(G21 G90
o<drill-v2> call
M2
; file: drill-v2.ngc
o<drill-v2> sub
  G81 X0 Y0 Z-5 R2 F80
o<drill-v2> endsub
)",
            .fix = R"(Rename the file and its sub.)",
            .level_reason =
                "Warning: the call works on this computer, but may fail with another file system or version.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow406
