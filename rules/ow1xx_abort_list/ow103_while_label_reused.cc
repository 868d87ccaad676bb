// OW103 while-label-reused: a `while` whose label already belongs to another block of the same scope that is not
// a `do`.
// Depends on: a `while` with a label from another line is an error unless a `do` opened that label,
// because `while` also closes a `do`.
#include "rules/driver/block_helpers.h"

namespace owlint::rules::ow103 {
namespace {

void check(const Input& in, Reporter& out) { check_label_reused(in, out, Keyword::kWhile); }

}  // namespace

extern const Rule kRule{
    .code = "OW103",
    .name = "while-label-reused",
    .summary = "a label on `while` that another block already has, and that does not close a `do`",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A `while` whose label was already used for another block in the same sub or main program. The same
error appears at the `while` that closes a `do`, if the label of that `do` was used for something
else before; the `do` line itself gives no error.)",
            .why = R"(LinuxCNC remembers every label, and the line where it was first used, until the program ends. A
`while` with a label from another line stops the program, even if the earlier block has ended or was
skipped. Only a label that a `do` opened is allowed, because `while` closes the `do`.

Under FEATURE 0x20 (`OWORD_WARNONLY`) it goes on, and the second `endwhile` jumps back to the
**first** loop. That loop runs again, one pass at a time, while its condition is true, and the
program may never end.)",
            .bad = R"(G21 G90
#<x> = 0
o100 while [#<x> LT 40]
  G81 X#<x> Y0 Z-5 R2 F80
  #<x> = [#<x> + 10]
o100 endwhile
#<y> = 10
o100 while [#<y> LT 40]
  G81 X0 Y#<y> Z-5 R2 F80
  #<y> = [#<y> + 10]
o100 endwhile
G80
M2
)",
            .good = R"(G21 G90
#<x> = 0
o100 while [#<x> LT 40]
  G81 X#<x> Y0 Z-5 R2 F80
  #<x> = [#<x> + 10]
o100 endwhile
#<y> = 10
o110 while [#<y> LT 40]
  G81 X0 Y#<y> Z-5 R2 F80
  #<y> = [#<y> + 10]
o110 endwhile
G80
M2
)",
            .fix = R"(Give the second loop a label of its own: on its first line, its last line, and every `break` and
`continue` of the loop.)",
            .level_reason =
                "Error if a run gets to both blocks: the program stops at the second. Warning if no run does.",
            .interpreter = "duplicate O-word label: 'o100 while [#<y> LT 40]' - defined in line N",
            .options = "",
        },
    .check = check,
    .label_reused = true,
};

}  // namespace owlint::rules::ow103
