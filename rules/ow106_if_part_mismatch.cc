// OW106 if-part-mismatch: an `else`, `elseif` or `endif` whose label belongs to a loop, or (`endif`) to nothing.
// Rests on: the three look their label up when executed and refuse it unless it was opened by
// `if`.
#include "rules/blocks.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  check_parts(in, out, [](Keyword k) { return k == Keyword::kEndif; }, "`if`");
}

}  // namespace

extern const Rule kOw106{
    .code = "OW106",
    .name = "if-part-mismatch",
    .summary = "a label on `else`, `elseif` or `endif` that does not point to a matching `if`",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page = {
        .what = R"(A part of an `if` with the label of a `while`, `do` or `repeat`, or an `endif` whose label opens
nothing: mostly the number of the surrounding block instead of the inner one.)",
        .why = R"(The interpreter looks up what the label was opened as and stops if it was not `if`. `else` and
`elseif` give the message shown below; `endif` on a loop's label gives
`no matching label: '#100' (found 'while' in line N): 'o100 endif'`, `endif` on an unknown label
`undefined O-word label: 'o101 endif'`. A line that is passed over while another label is being
skipped to is not looked at.

Under FEATURE 0x20 (`OWORD_WARNONLY`) an unknown label **crashes** LinuxCNC; an `endif` on a loop's
label is passed over; an `else` or `elseif` on one leaves that loop early, or never ends.)",
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
        .interpreter = "no matching 'if' label: 'o100 else' (found 'while' in line N)",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
