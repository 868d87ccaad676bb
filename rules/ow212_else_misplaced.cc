// OW212 else-misplaced: a second `else`, or an `elseif` after `else`, in one `if`.
// Rests on: once a branch was executed, every further part of the same `if` is skipped; nobody
// counts the `else` lines.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (BlockId block = 0; block < p.blocks.size(); ++block) {
    StatementId first_else = kNoStatement;
    for (const StatementId part : p.parts[block]) {
      if (first_else == kNoStatement) {
        if (p.at(part).is(Keyword::kElse)) first_else = part;
        continue;
      }
      Finding& f = out.add(p.at(part).head_span(), "`" + p.head(part) + "` comes after the `else` on line " + std::to_string(p.at(first_else).line) + ": its lines never run");
      relate(f, p, first_else, "the `else` stands here");
      f.help = p.at(part).is(Keyword::kElse) ? "keep one `else`, as the last branch" : "move the `elseif` before the `else`";
      f.reach = in.flow.reach(part);
    }
  }
}

}  // namespace

extern const Rule kOw212{
    .code = "OW212",
    .name = "else-misplaced",
    .summary = "a second `else`, or `elseif` after `else`",
    .group = Group::kBlocks,
    .level = Severity::kWarning,
    .page = {
        .what = R"(An `if` with two `else` parts, or with an `elseif` below its `else`. Mostly an inner `if` was meant,
or a label is wrong.)",
        .why = R"(LinuxCNC says nothing. Some branch above has always been taken by then, so the lines below can never
run: whatever should happen there does not happen.)",
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
        .fix = R"(Put the `elseif` parts first and one `else` last, or give an inner `if` its own label.)",
        .interpreter = "",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
