// OW107 jump-outside-loop: a `break` or `continue` whose label is not that of a `while` or `do`.
// Rests on: both look their label up when executed and refuse it unless it was opened by `while`
// or `do`. A loop that is over still counts as opened.
#include "rules/blocks.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  check_parts(in, out, [](Keyword k) { return k == Keyword::kBreak || k == Keyword::kContinue; }, "`while` or `do`");
}

}  // namespace

extern const Rule kOw107{
    .code = "OW107",
    .name = "jump-outside-loop",
    .summary = "a label on `break` or `continue` that does not point to a matching `while` or `do`",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page = {
        .what = R"(A `break` or `continue` with the label of an `if` (usually the one it stands in), of a `repeat`, or
of nothing at all. There is no `break` and no `continue` for `repeat`.)",
        .why = R"(The interpreter stops at the line, but only on the pass that gets there: the missing blank, the
broken tool, the tenth part. An unknown label gives `undefined O-word label: 'o101 break'`. The
label of a loop that has already ended is accepted; the interpreter then looks for the end of that
loop further down and runs into the end of the file.

Under FEATURE 0x20 (`OWORD_WARNONLY`) an unknown label **crashes** LinuxCNC. On an `if` the jump
only goes to the `endif` and the loop runs on; on a `repeat`, `break` happens to leave it and
`continue` to begin its next pass.)",
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
        .fix = R"(Write the label of the loop to be left. To leave a `repeat` early, make it a `while` with a counter.)",
        .interpreter = "no matching while/do label: 'o110 break' (found 'if' in line N)",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
