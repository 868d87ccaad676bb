// OW609 set-and-read-on-line: a parameter is set and then read on one line.
// Depends on: all values of a line are read before any of its assignments is made; a new name is 0 for the rest of its line
// (measured: `#1=5`, then `#1=6 G0 X#1` moves to 5).
#include <algorithm>

#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow609 {
namespace {

// Depth is bounded by the length of a line.
bool reads(const Program& p, ExprId id, flow::ParameterId of) {
  const Expr& expr = p.syntax.exprs[id];
  if (expr.op == Operator::kExistsNumbered) return false;
  if (expr.op == Operator::kNamed) return of.named && expr.name() == of.id;
  if (expr.op == Operator::kParameter && !of.named) {
    const Expr& number = p.syntax.exprs[expr.left()];
    if (number.op == Operator::kNumber && number.value() == of.id) return true;
  }
  return any_operand(expr, [&](ExprId operand) { return reads(p, operand, of); });
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const StatementId id : in.index.several_items) {
    const std::span<const Item> items = p.syntax.items_of(p.at(id));
    for (uint32_t i = 0; i + 1 < items.size(); ++i) {
      const Item& set = items[i];
      flow::ParameterId parameter{set.target_name, true};
      if (set.target != kNoExpr) {
        const Expr& number = p.syntax.exprs[set.target];
        if (number.op != Operator::kNumber) continue;
        parameter = {static_cast<uint32_t>(number.value()), false};
      } else if (set.target_name == kNoName) {
        continue;
      }
      for (uint32_t k = i + 1; k < items.size(); ++k) {
        if (!reads(p, items[k].value, parameter)) continue;
        const std::string words = parameter_words(p, parameter);
        Finding& f = out.add(
            item_span(p, id, k),
            "this reads the old value of " + words + ": the value set on this line counts from the next line on");
        f.related.push_back({item_span(p, id, i), "set here", nullptr});
        f.help = "set " + words + " on a line of its own, before this line";
        f.reach = in.flow.reach(id);
        break;
      }
    }
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW609",
    .name = "set-and-read-on-line",
    .summary = "a parameter set and read on one line: the line reads the old value",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A line that first sets a parameter and then reads it: `#1=6 G0 X#1`. A read before the assignment,
or in the assigned value itself, is normal and not reported.)",
            .why = R"(LinuxCNC reads all values of a line before it sets anything. The move goes to the **old** value; a
new name is 0. There is no message.)",
            .bad = R"(G21 G90
#1 = 5
G0 Y#1
#1 = 60 G0 X#1
M2
)",
            .good = R"(G21 G90
#1 = 5
G0 Y#1
#1 = 60
G0 X#1
M2
)",
            .fix = R"(Write the assignment on a line of its own, before this line.)",
            .level_reason = "Warning: the program runs with the old value.",
            .interpreter = "",
            .options = "",
            .moves = "X5",
            .moves_good = "X60",
        },
    .check = check,
};

}  // namespace owlint::rules::ow609
