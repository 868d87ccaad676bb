// OW212 else-misplaced: a second `else`, or an `elseif` after `else`, in one `if`.
// Depends on: after one branch has run, all other branches of the `if` are skipped; LinuxCNC does
// not count the `else` lines.
#include "rules/driver/stops.h"

namespace owlint::rules::ow212 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (BlockId block = 0; block < p.blocks.size(); ++block) {
    StatementId first_else = kNoStatement;
    for (const StatementId part : p.parts[block]) {
      if (first_else == kNoStatement) {
        // An `else` with a condition was meant as an `elseif`, which another rule says.
        if (p.at(part).is(Keyword::kElse) && !p.at(part).has_bracket) first_else = part;
        continue;
      }
      Finding& f = out.add(p.at(part).head_span(),
                           "`" + p.head(part) + "` comes after the `else` on line " +
                               std::to_string(p.at(first_else).line) + ": its lines never run");
      relate(f, p, first_else, "the `else` is here");
      f.help =
          p.at(part).is(Keyword::kElse) ? "keep one `else`, as the last branch" : "move the `elseif` before the `else`";
      f.reach = in.flow.reach(part);
    }
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW212",
    .name = "else-misplaced",
    .summary = "a second `else`, or an `elseif` after `else`",
    .group = Group::kBlocks,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(An `if` with two `else` lines, or with an `elseif` after its `else`. Usually an inner `if` was
intended, or a label is wrong.)",
            .why =
                R"(LinuxCNC gives no message. One of the branches above has always been taken, so the lines below never
run.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  G0 Z5
o100 else
  G0 Z20
o100 elseif [#5063 LT -9]
  G0 Z50
o100 endif
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  G0 Z5
o100 elseif [#5063 LT -9]
  G0 Z50
o100 else
  G0 Z20
o100 endif
M2
)",
            .fix = R"(Put the `elseif` branches first and one `else` last, or give an inner `if` a label of its own.)",
            .level_reason = "Warning: LinuxCNC skips the branch without a message, and the program runs on.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
    .fades = true,
};

}  // namespace owlint::rules::ow212
