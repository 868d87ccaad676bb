// OW405 file-shadowed: a sub hides a file, or a file hides another one.
// Depends on: known subs come before files, and the first file on the search path before all others.
#include <unordered_set>

#include "rules/driver/stops.h"

namespace owlint::rules::ow405 {
namespace {

bool same_bytes(const Files& files, const std::string& a, const std::string& b) {
  std::string error;
  const auto left = files.read(a, &error);
  const auto right = files.read(b, &error);
  return left != nullptr && right != nullptr && left->bytes() == right->bytes();
}

StatementId opener_of_target(const Program& p, const Call& call) { return p.regions[call.target].opener; }

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  const Answers& search = in.linked.search_path();
  std::unordered_set<NameId> reported;
  const auto is_own = [&](const FoundFile& file) { return file_key(file.path) == file_key(p.source->path()); };
  for (const Call& call : p.calls) {
    if (call.callee == kNoName || !reported.insert(call.callee).second || !in.flow.executed[call.statement]) continue;
    const std::string& name = p.name(call.callee);
    std::vector<FoundFile> files = search.find_all(name);
    if (call.target != kNoRegion) {
      if (p.sub_file && (call.callee == p.entry || opener_of_target(p, call) < call.statement)) continue;  // skipped
      std::erase_if(files, is_own);
      if (files.empty()) continue;
      const StatementId opener = opener_of_target(p, call);
      const Statement& sub = p.at(opener);
      if (opener > call.statement) {
        if (p.sub_file) continue;  // OW410, which its callers show, too
        Finding& f = out.add(p.at(call.statement).head_span(),
                             "`" + p.head(call.statement) + "` runs " + files[0].path + ", not the sub on line " +
                                 std::to_string(sub.line) + ", which comes later");
        relate(f, p, opener, "this sub is not called there");
        f.help = "define the sub before the call, or rename it";
        f.reach = in.flow.reach(call.statement);
        continue;
      }
      Finding& f = out.add(sub.head_span(),
                           "`" + p.label_text(call.callee) + "` hides the file " + files[0].path + " of the same name");
      f.help = "rename the sub, unless this program needs its own version";
      f.reach = in.flow.reach(opener);
    } else if (files.size() > 1 && !same_bytes(search.path()->files(), files[0].path, files[1].path)) {
      Finding& f = out.add(p.at(call.statement).head_span(),
                           "`" + p.head(call.statement) + "` runs " + files[0].path + ", which hides " + files[1].path);
      f.help = "remove or rename the file that you do not want";
      f.reach = in.flow.reach(call.statement);
    }
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW405",
    .name = "file-shadowed",
    .summary = "a sub hides a file, or a file hides another one further along the search path",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A sub of the program has the name of a file on the search path, or the search path has two files
with the same name but different contents.)",
            .why = R"(LinuxCNC uses a sub that it knows before it looks for a file, and it uses the first file that it
finds: first the INI's folder, then `PROGRAM_PREFIX`, then `SUBROUTINE_PATH` from left to right. So
an old copy in the INI's folder or in `PROGRAM_PREFIX` hides the corrected file in
`SUBROUTINE_PATH`, without a message.)",
            .bad = R"(G21 G90
o<face> call
M2
; file: machine.ini
[RS274NGC]
SUBROUTINE_PATH = subs
; file: face.ngc
o<face> sub
  G1 Z-2 F100
o<face> endsub
; file: subs/face.ngc
o<face> sub
  G1 Z-1 F100
o<face> endsub
)",
            .good = R"(G21 G90
o<face> call
M2
; file: machine.ini
[RS274NGC]
SUBROUTINE_PATH = subs
; file: subs/face.ngc
o<face> sub
  G1 Z-1 F100
o<face> endsub
)",
            .fix = R"(Keep one of the two. If the program needs its own version, give it another name.)",
            .level_reason = "Warning: the program runs, but perhaps with the other file.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = check,
};

}  // namespace owlint::rules::ow405
