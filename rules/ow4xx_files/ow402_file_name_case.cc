// OW402 file-name-case: a file whose name has capitals: no call can find it.
// Depends on: LinuxCNC changes a called name to small letters, whatever `NO_DOWNCASE_OWORD` says (measured, 2.9).
#include "rules/driver/ini_pages.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow402 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const std::string other = in.linked.search_path().find_other_case(stop.detail).value_or(stop.detail);
    Finding& f =
        out.add(p.at(stop.statement).head_span(),
                "`" + p.head(stop.statement) + "` looks for `" + stop.detail + ".ngc`, but the file is named " + other);
    f.help = "rename the file to `" + stop.detail + ".ngc`: LinuxCNC looks only for names in small letters";
    if (normal_path(other) == normal_path(p.source->path())) {
      f.message = "`" + p.head(stop.statement) + "` has the name of this program, which does not define the sub";
      f.help = "define the sub in this program, or correct the name";
    }
    return &f;
  });
  const std::string name = file_name(*p.source);
  if (!p.sub_file || name == small_letters(name)) return;
  for (const Region& region : p.regions) {
    if (region.name != p.entry || region.opener == kNoStatement) continue;
    Finding& f =
        out.add(p.at(region.opener).head_span(), "no call can find this sub: the file is named `" + name + "`");
    f.help = "rename the file to `" + small_letters(name) + "`: LinuxCNC looks only for names in small letters";
    f.reach = Reach::kNever;
    return;
  }
}

/// Whether all folders of called files are here.
bool knows_all_files(const SetupInput& in) {
  return has_all_folders(in, "PROGRAM_PREFIX") && has_all_folders(in, "SUBROUTINE_PATH");
}

/// Measured: when LinuxCNC starts, it looks for the file of `ngc=` by the exact name, and for each call by that in small letters.
void check_start(const SetupInput& in, Reporter& out, const IniCall& call) {
  const std::string small = small_letters(call.name);
  if (call.name == small || in.setup.search_path->find(call.name)) return;
  const auto found = in.setup.search_path->find(small);
  if (!found) return;
  Finding& f = out.add(call.source, call.span, "`REMAP` names `" + call.name + ".ngc`, but the file is " + found->path);
  f.help = "write `ngc=" + small + "`; upper and lower case matter";
  f.fixes.push_back({"write `" + small + "`", false, {{call.span, small}}});
  f.interpreter = "INTERP_REMAP: NGC file not found: ngc=" + call.name;
  if (!knows_all_files(in)) return;
  f.message += ": LinuxCNC does not start";
  refuses(f, f.interpreter);
}

void check_setup(const SetupInput& in, Reporter& out) {
  for (const IniCall& call : in.setup.calls) {
    if (call.name.empty()) continue;
    if (call.key == "REMAP") check_start(in, out, call);
    if (in.setup.search_path->find(small_letters(call.name))) continue;
    const auto other = in.setup.search_path->find_other_case(call.name);
    if (!other) continue;
    Finding& f = out.add(call.source, call.span,
                         "`" + std::string(call.key) + "` calls `" + small_letters(call.name) +
                             ".ngc`, but the file is named " + *other);
    f.help = "rename the file to `" + small_letters(call.name) + ".ngc`";
    if (call.key != "REMAP") continue;
    const bool starts = in.setup.search_path->find(call.name).has_value();
    if (call.name != small_letters(call.name)) f.help += ", and write `ngc=" + small_letters(call.name) + "`";
    if (starts || !knows_all_files(in)) continue;
    f.message += ": LinuxCNC does not start";
    refuses(f, "INTERP_REMAP: NGC file not found: ngc=" + call.name);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW402",
    .name = "file-name-case",
    .summary = "a file whose name has capital letters can never be called",
    .group = Group::kFiles,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A called name matches a file only if capital and small letters count as the same; or a sub file has
capital letters in its name.)",
            .why =
                R"(LinuxCNC changes the whole line to small letters before it looks for the file: `o<Probe> call` looks
for `probe.ngc`. On Linux, `Probe.ngc` is a different file, so the call stops as if there were no
file. `NO_DOWNCASE_OWORD` in the INI was tried and does not change this.

For the file of `ngc=` in a `REMAP` line LinuxCNC also looks when it starts, by the exact name: if it
is not there, it does not start.)",
            .bad = R"(G21 G90
o<Probe> call
M2
; file: machine.ini
[RS274NGC]
SUBROUTINE_PATH = subs
; file: subs/Probe.ngc
o<probe> sub
  G38.2 Z-10 F50
o<probe> endsub
)",
            .good = R"(G21 G90
o<Probe> call
M2
; file: machine.ini
[RS274NGC]
SUBROUTINE_PATH = subs
; file: subs/probe.ngc
o<probe> sub
  G38.2 Z-10 F50
o<probe> endsub
)",
            .fix = R"(Rename the file.)",
            .level_reason = "Error if a run gets to the call: the program stops. Warning if no run does. Error at "
                            "a `REMAP` line with which LinuxCNC does not start.",
            .interpreter = "EOF in file:PROGRAM seeking o-word: o<probe> from line: 2",
            .options = "--ini machine.ini",
        },
    .check = check,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow402
