// OW402 file-name-case: a file whose name has capitals: no call can find it.
// Rests on: LinuxCNC lowers the letters of a called name, whatever `NO_DOWNCASE_OWORD` says (measured, 2.9).
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const std::string other = in.linked.search_path().find_other_case(stop.detail).value_or(stop.detail);
    Finding& f = out.add(p.at(stop.statement).head_span(), "`" + p.head(stop.statement) + "` looks for `" + stop.detail + ".ngc`, and the file is named " + other);
    f.help = "rename the file to `" + stop.detail + ".ngc`: LinuxCNC looks for names in small letters only";
    return &f;
  });
  const std::string name = file_name(*p.source);
  if (!p.sub_file || name == small_letters(name)) return;
  for (const Region& region : p.regions) {
    if (region.name != p.entry || region.opener == kNoStatement) continue;
    Finding& f = out.add(p.at(region.opener).head_span(), "no call can find this sub: the file is named `" + name + "`");
    f.help = "rename the file to `" + small_letters(name) + "`: LinuxCNC looks for names in small letters only";
    f.reach = Reach::kNever;
    return;
  }
}

void check_setup(const SetupInput& in, Reporter& out) {
  for (const IniCall& call : in.setup.calls) {
    if (call.name.empty() || in.setup.search_path->find(small_letters(call.name))) continue;
    const auto other = in.setup.search_path->find_other_case(call.name);
    if (!other) continue;
    Finding& f = out.add(call.source, call.span, "`" + std::string(call.key) + "` calls `" + small_letters(call.name) + ".ngc`, and the file is named " + *other);
    f.help = "rename the file to `" + small_letters(call.name) + ".ngc`";
  }
}

}  // namespace

extern const Rule kOw402{
    .code = "OW402",
    .name = "file-name-case",
    .summary = "a file whose name has capitals can never be called",
    .group = Group::kFiles,
    .level = Severity::kError,
    .page = {
        .what = R"(A called name fits a file only if capitals and small letters are taken for the same; or a file of subs has capitals in its
name.)",
        .why = R"(LinuxCNC turns the whole line into small letters before it looks for the file: `o<Probe> call` looks for `probe.ngc`. On
Linux that is another file than `Probe.ngc`, and the call stops as if there were none. `NO_DOWNCASE_OWORD` in the INI was
tried and does not change it.)",
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
        .interpreter = "EOF in file:PROGRAM seeking o-word: o<probe> from line: 2",
        .options = "--ini machine.ini",
    },
    .check = check,
    .check_setup = check_setup,
};

}  // namespace owlint::rules
