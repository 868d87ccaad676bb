// OW407 search-path-missing: a folder of the INI that does not exist.
// Depends on: LinuxCNC ignores such folders without a message.
#include <algorithm>
#include <span>

#include "rules/driver/machine_rules.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow407 {
namespace {

void check(const Input&, Reporter&) {}

/// Which folder that is, where its name alone does not say it.
std::string path_of(const IniFolder& folder) { return folder.path == folder.text ? "" : " (" + folder.path + ")"; }

std::string words_of(const IniFolder& folder) { return "`" + folder.text + "` of `" + std::string(folder.key) + "`"; }

/// One finding for all of them: with an INI from another computer most folders are missing.
void check_setup(const SetupInput& in, Reporter& out) {
  std::vector<const IniFolder*> missing;
  for (const IniFolder& folder : in.setup.folders) {
    if (comment_in(folder.text) != std::string_view::npos || folder.text.find(',') != std::string::npos)
      continue;  // OW415
    if (!folder.exists && (folder.key == "PROGRAM_PREFIX" || folder.key == "SUBROUTINE_PATH"))
      missing.push_back(&folder);
  }
  if (missing.empty()) return;
  // A name that begins at the root or at somebody's home is right on the machine, as a rule, where this computer lacks it.
  // So is the link `../../nc_files` that LinuxCNC makes beside a copy of one of its configurations.
  const auto of_machine = [](const IniFolder* folder) {
    return folder->text.starts_with('/') || folder->text.starts_with('~') ||
        (folder->text.starts_with("..") && folder->text.find("/nc_files") != std::string::npos);
  };
  std::stable_partition(missing.begin(), missing.end(), [&](const IniFolder* folder) { return !of_machine(folder); });
  const bool elsewhere = of_machine(missing[0]);
  const IniFolder& first = *missing[0];
  const bool several = missing.size() > 1;
  Finding& f = out.add(first.source, first.span, "the folder " + words_of(first) + " does not exist" + path_of(first));
  if (several)
    f.message = std::to_string(missing.size()) + " folders of this INI do not exist; the first is " + words_of(first) +
        path_of(first);
  for (const IniFolder* folder : std::span(missing).subspan(1)) {
    f.related.push_back({folder->span, words_of(*folder) + " does not exist" + path_of(*folder),
                         folder->source == first.source ? nullptr : folder->source});
  }
  const bool blank = std::ranges::any_of(
      missing, [](const IniFolder* folder) { return folder->text.starts_with(' ') || folder->text.ends_with(' '); });
  if (elsewhere && !blank) f.weight = Weight::kAside;
  if (!blank) f.missing = first.text;
  // Copies of one configuration lack the same folders.
  f.group = first.text;
  f.habit_severity = Severity::kInfo;
  f.help = blank  ? "remove the spaces around the names: they count as part of the names"
      : elsewhere ? "if the INI is from another computer, name this computer's folders with `--sub-path`; else make "
                    "the folder, or correct its name"
      : several ? "make the folders or correct their names; if the INI is from another computer, name this computer's "
                  "folders with `--sub-path`"
                : "make the folder, or correct its name";
  // What people take for a sign between folders, or around them.
  if (first.text.find(';') != std::string::npos) {
    f.help = "write `:` between the folders: `;` is a part of the name";
    f.missing.clear();
  } else if (first.text.find_first_of("\"'") == 0) {
    f.help = "remove the quotes: they are a part of the name";
    f.missing.clear();
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW407",
    .name = "search-path-missing",
    .summary = "a folder in PROGRAM_PREFIX or SUBROUTINE_PATH that does not exist",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A folder that the INI names in `PROGRAM_PREFIX` or `SUBROUTINE_PATH` does not exist. Relative names
count from the INI's folder, `~/` from the home folder of the user who starts LinuxCNC.)",
            .why = R"(LinuxCNC searches the other folders and gives no message. It does not find the subs in the missing
folder, and the first call of one of them stops the program. Spaces around the `:` are part of the
names.

If the INI's HAL files, tool table and Python files are missing as well, the folder has only a part of the
configuration. Then one finding names all files and folders that are missing, instead of one finding for
each (also those of OW208 and OW423).)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
SUBROUTINE_PATH = sub
; file: subs/face.ngc
o<face> sub
  G1 Z-1 F100
o<face> endsub
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
SUBROUTINE_PATH = subs
; file: subs/face.ngc
o<face> sub
  G1 Z-1 F100
o<face> endsub
)",
            .fix = R"(Correct the name, or make the folder.)",
            .level_reason = "Warning: LinuxCNC starts without the folder; the calls of its subs stop later. Info for a "
                            "name that begins with `/` or `~`, which may exist on the machine only, and where several "
                            "INIs have only a part of their configuration here.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = check,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow407
