// OW104 if-label-reused: an `if` whose label already belongs to another block of the same scope.
// Rests on: an `if` met with a label from another line is refused, even when that other block was
// skipped.
#include "rules/blocks.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) { check_label_reused(in, out, Keyword::kIf); }

}  // namespace

extern const Rule kOw104{
    .code = "OW104",
    .name = "if-label-reused",
    .summary = "a label on `if` that is defined elsewhere",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page = {
        .what = R"(An `if` whose label was already used for another `if`, `while`, `do` or `repeat` of the same sub or
main program: the usual result of copying a block and forgetting the number.)",
        .why = R"(LinuxCNC remembers every label until the program ends, with the line that opened it. It stops at the
second `if`, also if the first one was finished long before or its condition was false. It says
nothing as long as a run meets only one of the two, so a part program can run for months and stop in
the middle of a cut on the day the other branch is taken.

Under FEATURE 0x20 (`OWORD_WARNONLY`) the message is printed and the second `if` works as written;
on the label of a loop its `endif` is reported as well.)",
        .bad = R"(G21 G90
G38.3 X20 F50
o100 if [#5070 EQ 1]
  G10 L20 P1 X0
o100 endif
G0 X-5
G38.3 Y20 F50
o100 if [#5070 EQ 1]
  G10 L20 P1 Y0
o100 endif
G0 Y-5
M2
)",
        .good = R"(G21 G90
G38.3 X20 F50
o100 if [#5070 EQ 1]
  G10 L20 P1 X0
o100 endif
G0 X-5
G38.3 Y20 F50
o110 if [#5070 EQ 1]
  G10 L20 P1 Y0
o110 endif
G0 Y-5
M2
)",
        .fix = R"(Give the second `if` a label of its own, and the same one to its `elseif`, `else` and `endif`. The
number may be used again inside another sub: labels are local there.)",
        .interpreter = "duplicate O-word label - already defined in line N: 'o100 if [#5070 EQ 1]'",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
