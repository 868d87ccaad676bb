// OW508 endless-loop: a loop that no run leaves.
// Depends on: the interpreter has no limit on passes and reads ahead of the machine, so it never
// ends.
#include <algorithm>

#include "analyzer/syntax/line_parser.h"
#include "rules/driver/blocks.h"

namespace owlint::rules {
namespace {

/// A line after the end of the loop that ends it once more.
StatementId second_end(const Input& in, BlockId block) {
  if (block == kNoBlock || in.program.blocks[block].end == kNoStatement) return kNoStatement;
  const Block& loop = in.program.blocks[block];
  for (const StatementId id : in.index.stray_parts) {
    if (id > loop.end && in.program.at(id).label == loop.label && in.program.region_of[id] == loop.region &&
        loops_again(in, id))
      return id;
  }
  return kNoStatement;
}

/// Whether the loop goes on until a value is met exactly, which something in it computes.
bool waits_for_equal(const Program& p, StatementId opener) {
  const BlockId block = p.block_of[opener];
  const StatementId test = p.at(opener).is(Keyword::kDo) && block != kNoBlock ? p.blocks[block].end : opener;
  if (test == kNoStatement || !p.at(test).is(Keyword::kWhile) || p.at(test).value_count != 1) return false;
  const Expr& condition = p.syntax.exprs[p.syntax.values[p.at(test).first]];
  if (condition.op != Operator::kNe) return false;
  const Expr& left = p.syntax.exprs[condition.left()];
  const StatementId end =
      block == kNoBlock ? opener : std::min<StatementId>(p.blocks[block].end, static_cast<StatementId>(p.size()));
  for (StatementId id = opener; id < end; ++id) {
    const Statement& s = p.at(id);
    for (uint32_t i = 0; s.has_items() && i < s.item_count; ++i) {
      const Item& item = p.syntax.items[s.first + i];
      if (left.op == Operator::kNamed && item.target_name == left.name()) return true;
      double number = 0;
      double assigned = 0;
      if (left.op == Operator::kParameter && item.target != kNoExpr &&
          literal_value(p.syntax.exprs, left.left(), &number) &&
          literal_value(p.syntax.exprs, item.target, &assigned) && number == assigned)
        return true;
    }
  }
  return false;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kEndlessLoop) continue;
    const Statement& s = p.at(h.statement);
    // A `do` in a `do` with its label is OW510.
    const auto nested = [&](const Block& b) {
      return b.kind == Keyword::kDo && b.label == s.label && b.opener > h.statement &&
          p.block_of[h.statement] != kNoBlock && b.opener < p.blocks[p.block_of[h.statement]].end;
    };
    if (s.is(Keyword::kDo) && std::ranges::any_of(p.blocks, nested)) continue;
    const BlockId block = p.block_of[h.statement];
    const StatementId again = second_end(in, block);
    if (again != kNoStatement) {
      const std::string end = p.head(again);
      Finding& f = out.add(p.at(again).head_span(),
                           "a second `" + end + "` goes back to `" + p.head(h.statement) + "` on line " +
                               std::to_string(s.line) + ", again and again");
      relate(f, p, h.statement, "it goes back here");
      relate(f, p, p.blocks[block].end, "the loop has already ended here");
      f.help = "remove the line, or give it the label of the loop that it ends";
      f.unproven = h.not_always;
      f.reach = h.reach;
      f.never_ends = true;
      continue;
    }
    const std::string who = h.not_always ? "some runs never leave" : "no run leaves";
    Finding& f = out.add(s.head_span(), who + " the loop that begins with `" + p.head(h.statement) + "`");
    f.unproven = h.not_always;
    if (block != kNoBlock && p.blocks[block].end != kNoStatement)
      relate(f, p, p.blocks[block].end, "the loop goes back from here");
    f.help = "change the value that the condition tests inside the loop, or leave the loop with `break`";
    if (waits_for_equal(p, h.statement))
      f.help = "compare with `GT` or `LT` instead of `NE`: the steps may jump over the value";
    f.reach = h.reach;
    f.never_ends = true;
  }
}

}  // namespace

extern const Rule kOw508{
    .code = "OW508",
    .name = "endless-loop",
    .summary = "a loop that no run leaves",
    .group = Group::kHazards,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A `while` or `do` whose condition does not change inside the loop, and that has no `break`, `return`
or program end: the counter is never changed, or another one is changed, or the condition is
constant. A second `endwhile` or `endrepeat` for a loop that has already ended has the same effect.

If some runs leave the loop and others never do, it is a warning.)",
            .why =
                R"(LinuxCNC gives no message. If the loop has moves, the machine repeats them until somebody stops it.
If it has none, the screen freezes, and the preview of the program never finishes loading.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
            .bad = R"(G21 G90
G0 X0 Y0 Z5
#<z> = 0
o100 while [#<z> GT -10]
  G1 Z#<z> F80
  G1 X50 F300
  G0 Z5
  G0 X0
o100 endwhile
M2
)",
            .good = R"(G21 G90
G0 X0 Y0 Z5
#<z> = 0
o100 while [#<z> GT -10]
  #<z> = [#<z> - 2]
  G1 Z#<z> F80
  G1 X50 F300
  G0 Z5
  G0 X0
o100 endwhile
M2
)",
            .fix = R"(Change the value that the condition tests, in every pass. If the program is meant to run until the
operator stops it, suppress the finding with a reason.)",
            .level_reason = "Error: the program never ends.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules
