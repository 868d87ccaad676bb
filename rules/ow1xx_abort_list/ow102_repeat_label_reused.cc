// OW102 repeat-label-reused: a `repeat` whose label already belongs to another block of the same scope.
// Depends on: a label is defined when its first line is reached and stays defined for the whole run;
// a `repeat` with a label from another line is an error.
#include "rules/driver/block_helpers.h"

namespace owlint::rules::ow102 {
namespace {

void check(const Input& in, Reporter& out) { check_label_reused(in, out, Keyword::kRepeat); }

}  // namespace

extern const Rule kRule{
    .code = "OW102",
    .name = "repeat-label-reused",
    .summary = "a label on `repeat` that another block already has",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A `repeat` whose label was already used for another `repeat`, `while`, `do` or `if` in the same sub
(or in the main program), even if that block has already ended.)",
            .why = R"(LinuxCNC remembers every label, and the line where it was first used, until the program ends. At a
`repeat` with a label from another line it stops, even if the earlier block was skipped. There is no
error as long as no run gets to both lines.

Under FEATURE 0x20 (`OWORD_WARNONLY`) it goes on, and the second `endrepeat` jumps back to the
**first** block. Both blocks then run for ever.)",
            .bad = R"(G21 G90
G0 X0 Y0 Z5
o100 repeat [4]
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
o100 repeat [4]
  G91 G0 Y10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
M2
)",
            .good = R"(G21 G90
G0 X0 Y0 Z5
o100 repeat [4]
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
o110 repeat [4]
  G91 G0 Y10
  G90 G1 Z-2 F80
  G0 Z5
o110 endrepeat
M2
)",
            .fix =
                R"(Give the second block a label of its own, on its `repeat` and its `endrepeat`. Labels of blocks are
local to a sub, so another sub may use the same number.)",
            .level_reason =
                "Error if a run gets to both blocks: the program stops at the second. Warning if no run does.",
            .interpreter = "duplicate O-word label: 'o100 repeat [4]' - defined in line N",
            .options = "",
        },
    .check = check,
    .label_reused = true,
};

}  // namespace owlint::rules::ow102
