// OW108 loop-end-mismatch: an `endwhile` or `endrepeat` whose label was not opened by its own kind of loop.
// Rests on: both look their label up when executed; an unknown label or one of another kind is
// refused.
#include "rules/blocks.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  check_parts(in, out, [](Keyword k) { return k == Keyword::kEndwhile || k == Keyword::kEndrepeat; }, "`while` or `repeat`");
}

}  // namespace

extern const Rule kOw108{
    .code = "OW108",
    .name = "loop-end-mismatch",
    .summary = "a label on `endrepeat` or `endwhile` without its `repeat` or `while`",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page = {
        .what = R"(An `endwhile` or `endrepeat` that closes something else than its own kind: `endwhile` on a `repeat`,
on a `do` (which ends with `while`) or on an `if`, or with a label that opens nothing.)",
        .why = R"(The interpreter stops at the line after the first pass. A label that opens nothing gives
`undefined O-word label: 'o101 endrepeat'`.

Under FEATURE 0x20 (`OWORD_WARNONLY`) an unknown label **crashes** LinuxCNC; one of another kind
makes it jump back to that block's opening line, which for `if` and `do` never ends.)",
        .bad = R"(G21 G90
G0 X0 Y0 Z5
o100 repeat [4]
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endwhile
M2
)",
        .good = R"(G21 G90
G0 X0 Y0 Z5
o100 repeat [4]
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
M2
)",
        .fix = R"(Close `repeat` with `endrepeat`, `while` with `endwhile`, `do` with `while`, each with the label of
its opening line.)",
        .interpreter = "no matching label: 'o100 endwhile' (found 'repeat' in line N)",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
