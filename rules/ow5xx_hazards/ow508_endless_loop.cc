// OW508 endless-loop: a loop that no run leaves.
// Depends on: the interpreter has no limit on passes and reads ahead of the machine, so it never
// ends.
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "analyzer/syntax/line_parser.h"
#include "rules/driver/block_helpers.h"
#include "rules/driver/wrong_ends.h"

namespace owlint::rules::ow508 {
namespace {

/// A line after the end of the loop that ends it once more.
StatementId second_end(const Input& in, BlockId block) {
  if (block == kNoBlock || in.program.blocks[block].end == kNoStatement) return kNoStatement;
  const Block& loop = in.program.blocks[block];
  for (const StatementId id : in.index.stray_parts) {
    if (id > loop.end && ended_again(in.program, block, id) != nullptr && loops_again(in, id)) return id;
  }
  return kNoStatement;
}

/// What a loop's `NE` waits for, which something in the loop computes.
struct Wait {
  std::string what;  ///< the value, as it is written
  int step = 0;      ///< 1: the loop counts up, -1: down, 0: not known
  int ahead = 0;     ///< 1: the value is above the one that the loop begins with, -1: below, 0: not known
};

/// Whether a line assigns the parameter of an expression, and from what.
const Item* assignment(const Program& p, const Statement& s, const Expr& parameter) {
  for (const Item& item : p.syntax.items_of(s)) {
    if (parameter.op == Operator::kNamed && item.target_name == parameter.name()) return &item;
    double number = 0;
    double assigned = 0;
    if (parameter.op == Operator::kParameter && item.target != kNoExpr &&
        literal_value(p.syntax.exprs, parameter.left(), &number) &&
        literal_value(p.syntax.exprs, item.target, &assigned) && number == assigned)
      return &item;
  }
  return nullptr;
}

/// Whether a value is `[#1 + 2]` or the like, with the parameter: in which direction it counts.
int step_of(const Program& p, ExprId value, const Expr& parameter) {
  const auto same = [&](ExprId id) {
    const Expr& e = p.syntax.exprs[id];
    double a = 0;
    double b = 0;
    if (e.op != parameter.op) return false;
    if (e.op == Operator::kNamed) return e.name() == parameter.name();
    return e.op == Operator::kParameter && literal_value(p.syntax.exprs, e.left(), &a) &&
        literal_value(p.syntax.exprs, parameter.left(), &b) && a == b;
  };
  const Expr& e = p.syntax.exprs[value];
  if (e.op != Operator::kPlus && e.op != Operator::kMinus) return 0;
  const bool second = e.op == Operator::kPlus && same(e.right());
  double step = 0;
  if ((!second && !same(e.left())) || !literal_value(p.syntax.exprs, second ? e.left() : e.right(), &step)) return 0;
  const int sign = step > 0 ? 1 : step < 0 ? -1 : 0;
  return e.op == Operator::kMinus ? -sign : sign;
}

/// The line with the condition of a loop.
StatementId condition_of(const Program& p, StatementId opener) {
  const BlockId block = p.block_of[opener];
  return p.at(opener).is(Keyword::kDo) && block != kNoBlock ? p.blocks[block].end : opener;
}

/// The condition of a loop; null where it has none.
const Expr* tested(const Program& p, StatementId opener) {
  const StatementId test = condition_of(p, opener);
  if (test == kNoStatement || !p.at(test).is(Keyword::kWhile) || p.at(test).value_count != 1) return nullptr;
  return &p.syntax.exprs[p.syntax.values_of(p.at(test)).front()];
}

/// How often the lines of a loop assign a parameter, and in which direction the only one of them counts.
struct Counting {
  size_t assignments = 0;
  int step = 0;
};

Counting counting(const Program& p, StatementId opener, const Expr& parameter) {
  const BlockId block = p.block_of[opener];
  const StatementId end =
      block == kNoBlock ? opener : std::min<StatementId>(p.blocks[block].end, static_cast<StatementId>(p.size()));
  Counting out;
  for (StatementId id = opener; id < end; ++id) {
    if (const Item* item = assignment(p, p.at(id), parameter))
      out.step = out.assignments++ == 0 ? step_of(p, item->value, parameter) : 0;
  }
  return out;
}

/// Whether the loop goes on until a value is met exactly.
std::optional<Wait> waits_for_equal(const Program& p, StatementId opener) {
  const Expr* const condition = tested(p, opener);
  if (condition == nullptr || condition->op != Operator::kNe) return std::nullopt;
  double value = 0;
  const bool turned = literal_value(p.syntax.exprs, condition->left(), &value);  // `1 NE #1`
  const Expr& left = p.syntax.exprs[turned ? condition->right() : condition->left()];
  const Counting counted = counting(p, opener, left);
  if (counted.assignments == 0) return std::nullopt;
  Wait wait;
  wait.step = counted.step;
  if (!turned && !literal_value(p.syntax.exprs, condition->right(), &value)) return wait;
  wait.what = fmt::format("{}", value);
  // The nearest line above, if nothing lies between that may assign another value.
  double start = 0;
  for (StatementId id = opener; id-- > 0;) {
    const Statement& s = p.at(id);
    if (s.kind != LineKind::kWords) break;
    const Item* item = assignment(p, s, left);
    if (item == nullptr) continue;
    if (literal_value(p.syntax.exprs, item->value, &start)) wait.ahead = value > start ? 1 : value < start ? -1 : 0;
    break;
  }
  return wait;
}

/// How to correct a loop that changes what its condition tests, and yet goes on. Empty if it changes nothing of that.
std::string of_condition(const Program& p, StatementId opener) {
  const Expr* const condition = tested(p, opener);
  if (condition == nullptr) return {};
  const bool greater = condition->op == Operator::kGt || condition->op == Operator::kGe;
  if (greater || condition->op == Operator::kLt || condition->op == Operator::kLe) {
    for (const auto& [side, sign] : {std::pair(condition->left(), 1), std::pair(condition->right(), -1)}) {
      const int away = greater ? sign : -sign;  // the direction in which the condition stays true
      if (counting(p, opener, p.syntax.exprs[side]).step == away)
        return "count the other way: with each pass the condition is further from being false";
    }
  }
  std::vector<const Expr*> parts{condition};
  while (!parts.empty()) {
    const Expr& e = *parts.back();
    parts.pop_back();
    if (counting(p, opener, e).assignments > 0)
      return "correct the condition or the steps: the loop changes the value, but the condition stays true";
    for_each_operand(e, [&](ExprId id) { parts.push_back(&p.syntax.exprs[id]); });
  }
  return {};
}

/// How to correct a loop that passes the value that ends it.
std::string past_value(const Wait& wait) {
  const std::string value = wait.what.empty() ? "the value" : wait.what;
  if (wait.step == 0) return "compare with `GT` or `LT` instead of `NE`: the steps may jump over " + value;
  if (wait.ahead == -wait.step) return "count the other way: the steps lead away from " + value;
  return std::string("write `") + (wait.step > 0 ? "LT" : "GT") + "` instead of `NE`: the steps " +
      (wait.ahead == 0 ? "may jump over " : "jump over ") + value;
}

/// `while [#<_task> EQ 1]`: the loop is meant to run until the operator stops it. In the preview, which passes it, the name is 0.
bool asks_for_preview(const Program& p, StatementId opener) {
  const StatementId test = condition_of(p, opener);
  if (test == kNoStatement || !p.at(test).is(Keyword::kWhile)) return false;
  std::vector<ExprId> parts(p.syntax.values_of(p.at(test)).begin(), p.syntax.values_of(p.at(test)).end());
  while (!parts.empty()) {
    const Expr& e = p.syntax.exprs[parts.back()];
    parts.pop_back();
    if (e.op == Operator::kNamed && p.name(e.name()) == "_task") return true;
    for_each_operand(e, [&](ExprId id) { parts.push_back(id); });
  }
  return false;
}

/// The comment above the loop's end with which the preview ends, `(AXIS,stop)`: then the loop is meant to run until the operator
/// stops it. Empty if there is none. The preview knows it in this spelling alone.
Span end_of_preview(const Program& p, StatementId opener) {
  const BlockId block = p.block_of[opener];
  if (block == kNoBlock || p.blocks[block].end == kNoStatement) return {};
  const std::string_view above = p.source->slice({0, p.at(p.blocks[block].end).offset});
  for (const std::string_view comment : {"(AXIS,stop)", "(PREVIEW,stop)"}) {
    if (const size_t at = above.rfind(comment); at != std::string_view::npos) return {at, at + comment.size()};
  }
  return {};
}

/// `while [1]`, `while [1 EQ 1]`.
bool is_always_true(const Program& p, StatementId opener) {
  if (tested(p, opener) == nullptr) return false;
  double value = 0;
  return literal_value(p.syntax.exprs, p.syntax.values_of(p.at(condition_of(p, opener))).front(), &value) && value != 0;
}

/// The `continue` that makes a `repeat` begin again; null if none does.
const Hazard* stale_continue(const Input& in, BlockId block) {
  if (block == kNoBlock || in.program.blocks[block].kind != Keyword::kRepeat) return nullptr;
  const StatementId end = in.program.blocks[block].end;
  const auto found = std::ranges::find_if(in.flow.hazards, [&](const Hazard& h) {
    return h.kind == HazardKind::kStaleContinue && h.other == end && h.other_elsewhere.program == nullptr;
  });
  return found == in.flow.hazards.end() ? nullptr : &*found;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kEndlessLoop || asks_for_preview(p, h.statement)) continue;
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
      const Block& ended = *ended_again(p, block, again);
      Finding& f = out.add(p.at(again).head_span(),
                           "a second `" + end + "` goes back to `" + p.head(ended.opener) + "` on line " +
                               std::to_string(p.at(ended.opener).line) + ", again and again");
      relate(f, p, ended.opener, "it goes back here");
      relate(f, p, ended.end, "the loop has already ended here");
      f.help = "remove the line, or give it the label of the loop that it ends";
      f.unproven = h.not_always;
      f.reach = h.reach;
      f.never_ends = true;
      continue;
    }
    Finding& f = out.add(s.head_span(),
                         "the loop that begins with `" + p.head(h.statement) +
                             (h.not_always ? "` never ends on some runs" : "` never ends"));
    f.unproven = h.not_always;
    if (block != kNoBlock && p.blocks[block].end != kNoStatement)
      relate(f, p, p.blocks[block].end, "the loop goes back from here");
    f.help = of_condition(p, h.statement);
    if (f.help.empty())
      f.help = "change the value that the condition tests inside the loop, or leave the loop with `break`";
    if (s.is(Keyword::kRepeat)) f.help = "leave the loop: `repeat` has no other end than its last pass";
    if (const Hazard* stale = stale_continue(in, block)) {
      f.message += ": a `continue` in a `do` loop makes it begin its passes again";
      relate(in, f, place_of(in, stale->statement, {}), "this `continue` still has an effect at the end of the passes");
      f.help = "skip the rest of the `do` loop with an `if` instead";
    }
    if (const std::optional<Wait> wait = waits_for_equal(p, h.statement)) f.help = past_value(*wait);
    if (is_always_true(p, h.statement))
      f.help =
          "leave the loop with `break`; if it is meant to run until the operator stops it, write `while [#<_task> EQ "
          "1]`, "
          "which the preview passes";
    if (const Span stop = end_of_preview(p, h.statement); stop.end > stop.begin) {
      f.message += ": it runs until the operator stops it";
      f.related.push_back({stop, "the preview ends here", nullptr});
      f.unproven = f.uncertain = true;
    }
    f.reach = h.reach;
    f.never_ends = true;
  }
}

}  // namespace

extern const Rule kRule{
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
If it has none, the screen freezes, and the preview of the program never finishes loading.)",
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
operator stops it, write `while [#<_task> EQ 1]`: `#<_task>` is 1 when the machine runs the program,
and 0 in the preview, which skips the loop. owlint does not report such a loop. Or end the preview with
`(AXIS,stop)` above the loop or in it.)",
            .level_reason =
                "Error: the program never ends. Info if `(AXIS,stop)` ends the preview: then it is meant to "
                "run until the operator stops it.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow508
