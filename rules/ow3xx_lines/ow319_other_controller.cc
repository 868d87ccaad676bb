// OW319 other-controller: a program for a controller other than LinuxCNC.
// Depends on: the marks in analyzer/syntax/controllers.cc, each of which stops LinuxCNC, or a comment that names the controller.
#include "rules/driver/stops.h"

namespace owlint::rules::ow319 {
namespace {

void check(const Input& in, Reporter& out) {
  const Nature& nature = in.index.nature;
  if (nature.kind != Nature::kOtherController) return;
  Finding& f = out.add(
      nature.mark, "this looks like a program for " + std::string(nature.controller) + "; owlint checks for LinuxCNC");
  if (nature.other_mark.end > nature.other_mark.begin)
    f.related.push_back({nature.other_mark, "LinuxCNC does not have this either", nullptr});
  f.help = "leave the file out of the check with `--exclude`, or write the program for LinuxCNC";
  f.reach = Reach::kAlways;
}

}  // namespace

extern const Rule kRule{
    .code = "OW319",
    .name = "other-controller",
    .summary = "a program for another controller",
    .group = Group::kLine,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A program that looks like one for another controller: FluidNC, grbl and grblHAL, Fanuc macro B,
Haas, Mach3 and Mach4, PathPilot, a 3D printer (Marlin, Klipper), Siemens, Heidenhain. owlint
needs one clear sign (a line that stops LinuxCNC and cannot be a typing error), two weaker ones, or a
comment that names the controller together with a code that LinuxCNC does not have. A few such lines in a program with O-word blocks are mistakes, and are
reported as mistakes.)",
            .why = R"(LinuxCNC stops at the first line that it does not know. owlint reports the controller first;
other stops in the file are info, and what no run reaches is not reported.)",
            .bad = R"(O9010
IF [#1 EQ #0] GOTO 90
#2 = 0
WHILE [#2 LT 5] DO 1
  G0 X[#2 * 10]
  #2 = [#2 + 1]
END 1
N90 M99
)",
            .good = R"(o9010 sub
  #2 = 0
  o100 while [#2 LT 5]
    G0 X[#2 * 10]
    #2 = [#2 + 1]
  o100 endwhile
o9010 endsub
o9010 call
M2
)",
            .fix = R"(Write the program for LinuxCNC, or leave the file out of the check.)",
            .level_reason = "Warning: the program stops, but perhaps it is meant for another machine.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
    .other_controller = true,
};

}  // namespace owlint::rules::ow319
