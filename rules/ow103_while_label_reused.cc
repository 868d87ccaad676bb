// OW103 while-label-reused: a `while` whose label already belongs to another block of the same scope that is not
// a `do`.
// Rests on: a `while` met with a label from another line is refused unless that label was opened
// by `do`, because `while` is also what closes a `do`.
#include "rules/blocks.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) { check_label_reused(in, out, Keyword::kWhile); }

}  // namespace

extern const Rule kOw103{
    .code = "OW103",
    .name = "while-label-reused",
    .summary = "a label on `while` that is defined elsewhere and does not refer to a `do`",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page = {
        .what = R"(A `while` whose label was already used for another block of the same sub or main program. The same
happens to the `while` that closes a `do`, if the label of that `do` was used for something else
before: `do` itself never complains.)",
        .why = R"(LinuxCNC remembers every label until the program ends, with the line that opened it. A `while` on a
label from another line stops the program, also if the earlier block is finished or was skipped.
Only a label opened by `do` is let through, because `while` closes it.

Under FEATURE 0x20 (`OWORD_WARNONLY`) it goes on, and the second `endwhile` jumps back to the
**first** loop: that loop is run again, a pass at a time, if its condition holds, and the program
may never end.)",
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
        .fix = R"(Give the second loop a label of its own on its opening line, its end, and every `break` and
`continue` that belongs to it.)",
        .interpreter = "duplicate O-word label: 'o100 while [#<y> LT 40]' - defined in line N",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
