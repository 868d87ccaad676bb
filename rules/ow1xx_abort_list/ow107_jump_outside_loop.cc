// OW107 jump-outside-loop: a `break` or `continue` whose label is not that of a `while` or `do`.
// Depends on: both look their label up when executed; it is an error unless a `while` or `do` opened
// it. A loop that has ended still counts.
#include "rules/driver/block_helpers.h"

namespace owlint::rules::ow107 {
namespace {

void check(const Input& in, Reporter& out) {
  check_parts(
      in, out, [](Keyword k) { return k == Keyword::kBreak || k == Keyword::kContinue; }, "`while` or `do`");
}

}  // namespace

extern const Rule kRule{
    .code = "OW107",
    .name = "jump-outside-loop",
    .summary = "`break` or `continue` with a label that does not belong to a `while` or `do`",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A `break` or `continue` with the label of an `if` (usually the `if` around it), of a `repeat`, or
with a label that no line opens. `repeat` has no `break` and no `continue`.)",
            .why = R"(The interpreter stops at the line, but only in the pass that gets there: when the workpiece is
missing, when the tool is broken, at the tenth part. An unknown label gives `undefined O-word label:
'o101 break'`. The label of a loop that has already ended is accepted; the interpreter then looks
for the end of that loop further down, and stops at the end of the file.

Under FEATURE 0x20 (`OWORD_WARNONLY`) an unknown label **crashes** LinuxCNC. With the label of an
`if` the jump only goes to the `endif`, and the loop goes on. With the label of a `repeat`, `break`
leaves the `repeat` and `continue` begins its next pass.)",
            .bad = R"(G21 G90
G0 X0 Y0 Z5
#<x> = 0
o100 while [#<x> LT 100]
  G0 X#<x>
  G38.3 Z-10 F50
  o110 if [#5070 EQ 0]
    o110 break
  o110 endif
  G1 Z[#5063 - 2] F80
  G0 Z5
  #<x> = [#<x> + 20]
o100 endwhile
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X0 Y0 Z5
#<x> = 0
o100 while [#<x> LT 100]
  G0 X#<x>
  G38.3 Z-10 F50
  o110 if [#5070 EQ 0]
    o100 break
  o110 endif
  G1 Z[#5063 - 2] F80
  G0 Z5
  #<x> = [#<x> + 20]
o100 endwhile
G0 Z5
M2
)",
            .fix = R"(Write the label of the loop that the program should leave or continue. To leave a `repeat` early,
change it into a `while` with a counter.)",
            .level_reason = "Error: the program stops here. Warning if no run gets to this line.",
            .interpreter = "no matching while/do label: 'o110 break' (found 'if' in line N)",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow107
