// OW407 search-path-missing: a folder of the INI that does not exist.
// Rests on: LinuxCNC passes over such folders without a word.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input&, Reporter&) {}

void check_setup(const SetupInput& in, Reporter& out) {
  for (const IniFolder& folder : in.setup.folders) {
    if (folder.exists || (folder.key != "PROGRAM_PREFIX" && folder.key != "SUBROUTINE_PATH")) continue;
    const bool blank = !folder.text.empty() && (folder.text.front() == ' ' || folder.text.back() == ' ');
    Finding& f = out.add(folder.source, folder.span, "the folder `" + folder.text + "` of `" + std::string(folder.key) + "` does not exist (" + folder.path + ")");
    f.help = blank ? "take out the blank: it counts as a part of the name" : "make the folder, or correct its name";
  }
}

}  // namespace

extern const Rule kOw407{
    .code = "OW407",
    .name = "search-path-missing",
    .summary = "a PROGRAM_PREFIX or SUBROUTINE_PATH directory that does not exist",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page = {
        .what = R"(A folder that the INI names in `PROGRAM_PREFIX` or `SUBROUTINE_PATH` does not exist. Relative names count from the INI's
folder, `~/` from the home folder of the user who starts LinuxCNC.)",
        .why = R"(LinuxCNC searches the other folders and says nothing. Subs in the folder that was meant are not found, and the first call
of one of them stops the program. Blanks around the `:` belong to the names.)",
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
        .fix = R"(Correct the INI.)",
        .interpreter = "",
        .options = "--ini machine.ini",
    },
    .check = check,
    .check_setup = check_setup,
};

}  // namespace owlint::rules
