// OW104 if-label-reused: an `if` whose label already belongs to another block of the same scope.
// Depends on: an `if` with a label from another line is an error, even if that other block was skipped.
#include "rules/driver/block_helpers.h"

namespace owlint::rules::ow104 {
namespace {

void check(const Input& in, Reporter& out) { check_label_reused(in, out, Keyword::kIf); }

}  // namespace

extern const Rule kRule{
    .code = "OW104",
    .name = "if-label-reused",
    .summary = "a label on `if` that another block already has",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(An `if` whose label was already used for another `if`, `while`, `do` or `repeat` in the same sub or
main program. Usually a block was copied and the number not changed.)",
            .why = R"(LinuxCNC remembers every label, and the line where it was first used, until the program ends. It
stops at the second `if`, even if the first one ended long before or its condition was false. There
is no error as long as a run gets to only one of the two. So a program can run for months, and then
stop in the middle of a cut on the day the other branch is taken.

Under FEATURE 0x20 (`OWORD_WARNONLY`) LinuxCNC prints the message and the second `if` works as
written. If the label belongs to a loop, its `endif` gives a message too.)",
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
            .fix =
                R"(Give the second `if` a label of its own, and use it on its `elseif`, `else` and `endif` too. Labels
of blocks are local to a sub, so another sub may use the same number.)",
            .level_reason =
                "Error if a run gets to both blocks: the program stops at the second. Warning if no run does.",
            .interpreter = "duplicate O-word label - already defined in line N: 'o100 if [#5070 EQ 1]'",
            .options = "",
        },
    .check = check,
    .label_reused = true,
};

}  // namespace owlint::rules::ow104
