// OW318 word-unreadable: a letter without a value: text, or a word of another language.
// Depends on: a word is a letter and a value; anything else on a line is an error when the line is executed.
#include <algorithm>

#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const LineError& error = *p.syntax.error(p.at(stop.statement));
    const std::string text(p.source->slice(error.span));
    // `XY5`: of two letters, both are probably words.
    const std::string letter = text.size() <= 2 ? text.substr(0, 1) : std::string();
    Finding& f = out.add(error.span, "`" + text + "` is not a G-code word: a word is a letter and a number");
    f.help = "write text in a comment: `(text)`";
    if (!letter.empty()) {
      f.message = "`" + letter + "` has no number";
      f.help = "write a number after `" + letter + "`";
    }
    explain_idiom(in, stop.statement, f);
    return &f;
  });
}

}  // namespace

extern const Rule kOw318{
    .code = "OW318",
    .name = "word-unreadable",
    .summary = "text, or a word of another language, in a program",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A line with text outside a comment, or with words of another control or of BASIC: `GOTO 20`, `END1`,
`GOSUB`, `THEN`, a title above the program. owlint checks lines with two letters in a row, and says
what LinuxCNC has instead.)",
            .why = R"(A word is a letter and a value. The interpreter stops when it executes such a line, with `Unknown
word where unary operation could be` or `Unknown word starting with e`. In a skipped branch there is
no message.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
GOTO 90
G1 Z-2 F80
N90 G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
o100 if [#5070 EQ 1]
  G1 Z-2 F80
o100 endif
G0 Z5
M2
)",
            .fix =
                R"(Write text in a comment. Replace a jump by an `if` or a loop, and a loop of another control by `o100
while`.)",
            .level_reason = "Error if a run gets here: the program stops. Warning if no run does.",
            .interpreter = "Unknown word where unary operation could be",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules
