// OW406 file-name-characters: a called file whose name has other characters than the documentation allows.
// Rests on: such names run today; what LinuxCNC makes of them is not documented.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Call& call : p.calls) {
    if (call.callee == kNoName || call.target != UINT32_MAX) continue;
    const std::string& name = p.name(call.callee);
    // What a shell would look at, and what leads out of the folders, is said by OW505 and OW506.
    if (expands(name) || breaks_expansion(name) || leaves_folders(name)) continue;
    const bool known = in.linked.target(name).file != CallTarget::kNotFound;
    const size_t odd = name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_");
    if (odd == std::string::npos || !known) continue;
    const auto byte = static_cast<unsigned char>(name[odd]);
    const std::string which = byte >= 0x80 ? "a letter that is not English" : "`" + std::string(1, name[odd]) + "`";
    Finding& f = out.add(p.at(call.statement).head_span(), "the called name `" + name + "` has " + which + " in it, which LinuxCNC does not promise to find");
    f.help = "name the file and its sub with small letters, digits, `-` and `_` only";
    f.reach = in.flow.reach(call.statement);
  }
}

}  // namespace

extern const Rule kOw406{
    .code = "OW406",
    .name = "file-name-characters",
    .summary = "a called name with characters other than lowercase letters, digits, `-`, `_`",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page = {
        .what = R"(A call of a file whose name has other characters than small letters, digits, `-` and `_`: a dot, a slash, an umlaut.)",
        .why = R"(The documentation allows these characters only. Others happen to work: with a path (`o<subs/drill>`) LinuxCNC 2.9 calls the
sub `drill` of that file, 2.8 and 2.10 stop. A name is looked at as a shell would look at it, which makes some characters
dangerous (OW505).)",
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
        .interpreter = "",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
