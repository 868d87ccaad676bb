// OW319 other-controller: a program for a controller other than LinuxCNC.
// Depends on: the marks in analyzer/syntax/controllers.cc, each of which stops LinuxCNC, or a comment that names the controller.
#include <algorithm>

#include "rules/driver/behind_stops.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow319 {
namespace {

/// Where every run stops at a line, the finding is about that line: others in the file are info.
void stop_at_first_line(const Input& in, Finding& f) {
  const FlowStop* const stop = stop_that_ends_all(in.flow);
  if (stop == nullptr || stop->statement == kNoStatement || stop->unproven) return;
  f.stops = true;
  f.interpreter = stop->interpreter;
  const Span line = in.program.at(stop->statement).whole();
  const auto is_here = [&](Span span) { return span.begin >= line.begin && span.end <= line.end; };
  std::erase_if(f.related, [&](const Related& other) { return is_here(other.span); });
  if (is_here(f.span)) return;
  f.related.insert(f.related.begin(), {f.span, "only such programs have this", nullptr});
  f.span = line;
}

void check(const Input& in, Reporter& out) {
  const Nature& nature = in.index.nature;
  if (nature.kind != Nature::kOtherController) return;
  Finding& f = out.add(
      nature.mark, "this looks like a program for " + std::string(nature.controller) + "; owlint checks for LinuxCNC");
  if (nature.other_mark.end > nature.other_mark.begin)
    f.related.push_back({nature.other_mark, "LinuxCNC does not have this either", nullptr});
  stop_at_first_line(in, f);
  f.group = "programs for " + std::string(nature.controller);  // a folder of them is one question to its author
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
            .why = R"(LinuxCNC stops at the first line that it does not know. owlint reports the controller there, once;
stops at other lines of the file are info, and what no run reaches is not reported.)",
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
            .level_reason = "Error if every run stops at one of its lines. Warning otherwise.",
            .interpreter = "Unknown word starting with f",
            .options = "",
        },
    .check = check,
    .other_controller = true,
};

}  // namespace owlint::rules::ow319
