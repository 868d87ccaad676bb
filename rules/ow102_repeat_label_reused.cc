// OW102 repeat-label-reused: a `repeat` whose label already belongs to another block of the same scope.
// Rests on: a label is defined when its opening line is first met and stays so for the whole run;
// a `repeat` met with a label from another line is refused.
#include "rules/blocks.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) { check_label_reused(in, out, Keyword::kRepeat); }

}  // namespace

extern const Rule kOw102{
    .code = "OW102",
    .name = "repeat-label-reused",
    .summary = "a label on `repeat` that is defined elsewhere",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page = {
        .what = R"(A `repeat` whose label was already used for another `repeat`, `while`, `do` or `if` of the same sub
(or of the main program). It does not help that the earlier block is finished.)",
        .why = R"(LinuxCNC remembers every label, with the line that opened it, until the program ends. When it meets
a `repeat` with a label that belongs to another line it stops, also if the earlier block was
skipped. It is silent only if no run meets both lines.

Under FEATURE 0x20 (`OWORD_WARNONLY`) it goes on and the second `endrepeat` jumps back to the
**first** block: both are then run for ever.)",
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
        .fix = R"(Give the second block a label of its own, on its `repeat` and its `endrepeat`. Labels are local to a
sub, so the same number may appear in another sub.)",
        .interpreter = "duplicate O-word label: 'o100 repeat [4]' - defined in line N",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
