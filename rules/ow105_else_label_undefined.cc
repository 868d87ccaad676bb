// OW105 else-label-undefined: an `else` or `elseif` whose label no block has defined on the way to it.
// Rests on: an `else` that is not the target of a skip looks its label up; unknown labels are
// refused. While another label is being skipped to, the line is passed over silently.
#include "rules/blocks.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  check_parts(in, out, [](Keyword k) { return k == Keyword::kElse || k == Keyword::kElseif; }, "`if`");
}

}  // namespace

extern const Rule kOw105{
    .code = "OW105",
    .name = "else-label-undefined",
    .summary = "an undefined label on `else` or `elseif`",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page = {
        .what = R"(An `else` or `elseif` whose label opens nothing in this sub or main program: a typing error in the
number, or an `else` whose `if` line is gone.)",
        .why = R"(If the condition is true, the interpreter gets to the `else`, does not know its label and stops,
after the first branch has been cut. If it is false, the interpreter is looking for the `if`'s own
label, passes over the wrong `else` and runs **neither branch**, without a word.

Under FEATURE 0x20 (`OWORD_WARNONLY`) LinuxCNC **crashes** at this line.)",
        .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 0]
  G0 Z5
o101 else
  G0 Z20
o100 endif
M2
)",
        .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 0]
  G0 Z5
o100 else
  G0 Z20
o100 endif
M2
)",
        .fix = R"(Write the label of the `if` that the branch belongs to.)",
        .interpreter = "undefined O-word label: 'o101 else'",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
