// OW105 else-label-undefined: an `else` or `elseif` whose label no block has defined on the way to it.
// Depends on: an `else` that is not the target of a skip looks its label up; an unknown label is
// an error. While the interpreter skips to another label, it ignores the line.
#include "rules/driver/block_helpers.h"

namespace owlint::rules::ow105 {
namespace {

void check(const Input& in, Reporter& out) {
  check_parts(
      in, out, [](Keyword k) { return k == Keyword::kElse || k == Keyword::kElseif; }, "`if`");
}

}  // namespace

extern const Rule kRule{
    .code = "OW105",
    .name = "else-label-undefined",
    .summary = "`else` or `elseif` with a label that no `if` has",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(An `else` or `elseif` whose label no line opens in this sub or main program: a typing error in the
number, or the `if` line is gone.)",
            .why = R"(If the condition is true, the interpreter runs the first branch, gets to the `else`, does not know
its label, and stops. If the condition is false, the interpreter looks for the label of the `if`,
skips the wrong `else`, and runs **neither branch**, without a message.

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
            .level_reason = "Error: the program stops here. Warning if no run gets to this line.",
            .interpreter = "undefined O-word label: 'o101 else'",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow105
