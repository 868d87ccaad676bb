// OW108 loop-end-mismatch: an `endwhile` or `endrepeat` whose label was not opened by its own kind of loop.
// Depends on: both look their label up when executed; an unknown label, or a label of another kind, is an error.
#include "rules/driver/block_helpers.h"

namespace owlint::rules::ow108 {
namespace {

void check(const Input& in, Reporter& out) {
  check_parts(
      in, out, [](Keyword k) { return k == Keyword::kEndwhile || k == Keyword::kEndrepeat; }, "`while` or `repeat`");
}

}  // namespace

extern const Rule kRule{
    .code = "OW108",
    .name = "loop-end-mismatch",
    .summary = "`endrepeat` or `endwhile` with a label that does not belong to a `repeat` or `while`",
    .group = Group::kAbortList,
    .level = Severity::kError,
    .page =
        {
            .what = R"(An `endwhile` or `endrepeat` that closes another kind of block: `endwhile` for a `repeat`, for a
`do` (which ends with `while`) or for an `if`, or with a label that no line opens.)",
            .why =
                R"(The interpreter stops at the line after the first pass. A label that no line opens gives `undefined
O-word label: 'o101 endrepeat'`.

Under FEATURE 0x20 (`OWORD_WARNONLY`) an unknown label **crashes** LinuxCNC. With the label of
another kind of block it jumps back to the first line of that block; for `if` and `do` this never
ends.)",
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
            .fix =
                R"(Close `repeat` with `endrepeat`, `while` with `endwhile`, and `do` with `while`, each with the label
of its first line.)",
            .level_reason = "Error: the program stops here. Warning if no run gets to this line.",
            .interpreter = "no matching label: 'o100 endwhile' (found 'repeat' in line N)",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow108
