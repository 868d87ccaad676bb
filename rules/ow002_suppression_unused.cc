// OW002 suppression-unused: a suppression comment that suppresses no finding.
// Rests on no fact of the interpreter: to LinuxCNC every suppression is an ordinary comment.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  if (!in.suppressions_applied) return;
  for (const Suppression& s : in.suppressions) {
    if (s.used || s.malformed || !known_prefix(s.code)) continue;
    const std::string what = s.code.empty() ? "anything" : "`" + s.code + "`";
    const std::string where = s.line == 0 ? "in this file" : "on line " + std::to_string(s.line);
    Finding& f = out.add(s.span, "there is no finding of " + what + " " + where + " to ignore");
    f.help = "remove it";
    f.reach = Reach::kAlways;
  }
}

}  // namespace

extern const Rule kOw002{
    .code = "OW002",
    .name = "suppression-unused",
    .summary = "a suppression that suppresses nothing",
    .group = Group::kLinter,
    .level = Severity::kWarning,
    .page = {
        .what = R"(A comment such as `(owlint: ignore OW301)` in front of a line, on a line or for a file in which
there is no finding with that code.)",
        .why = R"(It is left over from a mistake that has been mended since, or it stands at the wrong line. Left in
place it would hide the next mistake of that kind made there.

LinuxCNC reads the line as a comment and does nothing.)",
        .bad = R"(G21 G90
G0 X0 Y0 Z5
o100 repeat [3]
  (owlint: ignore OW301)
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
M2
)",
        .good = R"(G21 G90
G0 X0 Y0 Z5
o100 repeat [3]
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
M2
)",
        .fix = R"(Take the comment out, or move it: on a line of its own it speaks for the next line, at the end of a
line without O-word for that line, and `(owlint: ignore-file …)` for the whole file.)",
        .interpreter = "",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
