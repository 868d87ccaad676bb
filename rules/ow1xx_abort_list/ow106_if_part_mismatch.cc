// OW106 if-part-mismatch: an `else`, `elseif` or `endif` whose label belongs to a loop, or (`endif`) to nothing.
// Depends on: the three look their label up when executed; it is an error unless an `if` opened it.
#include "rules/driver/block_helpers.h"

namespace owlint::rules::ow106 {
namespace {

void check(const Input& in, Reporter& out) {
  check_parts(
      in, out, [](Keyword k) { return k == Keyword::kEndif; }, "`if`");
}

}  // namespace

extern const Rule kRule{
    .code = "OW106",
    .name = "if-part-mismatch",
    .summary = "`else`, `elseif` or `endif` with a label that does not belong to an `if`",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page =
        {
            .what = R"(An `else`, `elseif` or `endif` with the label of a `while`, `do` or `repeat`, or an `endif` whose
label no line opens. Usually it has the number of the outer block instead of the inner one.)",
            .why = R"(The interpreter looks up which kind of line opened the label, and stops if it was not an `if`.
`else` and `elseif` give the message below. An `endif` with a loop's label gives
`no matching label: '#100' (found 'while' in line N): 'o100 endif'`; an `endif` with an unknown
label gives `undefined O-word label: 'o101 endif'`. In lines that the interpreter skips, it does not
check this.

Under FEATURE 0x20 (`OWORD_WARNONLY`) an unknown label **crashes** LinuxCNC. An `endif` with a
loop's label is ignored. An `else` or `elseif` with a loop's label leaves that loop early, or the
program never ends.)",
            .bad = R"(G21 G90
#<x> = 0
o100 while [#<x> LT 40]
  o110 if [#<x> LT 20]
    G81 X#<x> Y0 Z-5 R2 F80
  o100 else
    G81 X#<x> Y0 Z-8 R2 F80
  o110 endif
  #<x> = [#<x> + 10]
o100 endwhile
G80
M2
)",
            .good = R"(G21 G90
#<x> = 0
o100 while [#<x> LT 40]
  o110 if [#<x> LT 20]
    G81 X#<x> Y0 Z-5 R2 F80
  o110 else
    G81 X#<x> Y0 Z-8 R2 F80
  o110 endif
  #<x> = [#<x> + 10]
o100 endwhile
G80
M2
)",
            .fix = R"(Use the label of the `if` that the line belongs to.)",
            .level_reason = "Error: the program stops here. Warning if no run gets to this line.",
            .interpreter = "no matching 'if' label: 'o100 else' (found 'while' in line N)",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow106
