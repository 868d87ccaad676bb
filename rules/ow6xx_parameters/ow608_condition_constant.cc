// OW608 condition-constant: a condition that is the same every time, and the branch that never runs.
// Depends on: a condition that is 0 is false, any other is true.
#include <optional>

#include <fmt/format.h>

#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow608 {
namespace {

bool same_parameter(const Syntax& syntax, ExprId a, ExprId b) {
  const Expr& left = syntax.exprs[a];
  const Expr& right = syntax.exprs[b];
  if (left.op != right.op) return false;
  if (left.op == Operator::kNamed) return left.name() == right.name();
  if (left.op != Operator::kParameter) return false;
  const flow::ParameterKey key = flow::key_of_number(syntax, left.left());
  return key != flow::kComputedKey && key == flow::key_of_number(syntax, right.left());
}

// Depth is bounded by the length of a line.
bool divides_by(const Syntax& syntax, ExprId id, ExprId parameter) {
  const Expr& expr = syntax.exprs[id];
  bool found = expr.op == Operator::kDivide && same_parameter(syntax, expr.right(), parameter);
  for_each_operand(expr, [&](ExprId operand) { found = found || divides_by(syntax, operand, parameter); });
  return found;
}

/// `if [#<count> GT 0]` before a division by `#<count>`, with an `else`: it is there for other numbers.
bool guards_division(const Program& p, StatementId id) {
  const Statement& s = p.at(id);
  const BlockId block = p.block_of[id];
  if (!s.is(Keyword::kIf) || s.value_count != 1 || block == kNoBlock || p.parts[block].empty()) return false;
  const Expr& condition = p.syntax.exprs[p.syntax.values_of(s).front()];
  if (condition.op != Operator::kGt && condition.op != Operator::kNe) return false;
  const Expr& limit = p.syntax.exprs[condition.right()];
  if (limit.op != Operator::kNumber || limit.value() < 0) return false;
  for (StatementId line = id + 1; line < p.parts[block].front(); ++line) {
    for (const Item& item : p.syntax.items_of(p.at(line))) {
      if (item.value != kNoExpr && divides_by(p.syntax, item.value, condition.left())) return true;
    }
    for (const ExprId value : p.syntax.values_of(p.at(line))) {
      if (divides_by(p.syntax, value, condition.left())) return true;
    }
  }
  return false;
}

/// `[#1 EQ 5 OR 6]`: a number that an `AND` or `OR` joins to a comparison.
std::optional<double> joined_number(const Syntax& syntax, ExprId condition, std::string_view* joint) {
  std::optional<double> number;
  const Expr* expr = &syntax.exprs[condition];
  while (expr->op == Operator::kAnd || expr->op == Operator::kOr) {
    const Expr& right = syntax.exprs[expr->right()];
    if (right.op == Operator::kNumber) {
      number = right.value();
      *joint = expr->op == Operator::kAnd ? "AND" : "OR";
    }
    expr = &syntax.exprs[expr->left()];
  }
  return expr->op >= Operator::kEq && expr->op <= Operator::kLe ? number : std::nullopt;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  if (p.syntax.runs_python) return;  // which may set what the conditions read
  for (const flow::FixedCondition& c : in.data.fixed()) {
    const Statement& s = p.at(c.statement);
    const std::string head = "`" + p.head(c.statement) + "`";
    if (c.same_as != kNoStatement) {
      Finding& f = out.add(s.head_span(), head + " is never true: a branch before it has the same condition");
      relate(f, p, c.same_as, "this branch runs instead");
      f.help = "change one of the two conditions";
      f.reach = in.flow.reach(c.statement);
      continue;
    }
    if (c.truth && guards_division(p, c.statement)) continue;
    const std::string says = s.is(Keyword::kWhile) && !c.truth ? "is always false: the loop makes no more passes"
        : c.truth                                              ? "is always true"
                                                               : "is always false: its lines never run";
    Finding& f = out.add(s.head_span(), "the condition of " + head + " " + says);
    f.help = "check the comparison: the direction, the number, the parameter";
    std::string_view joint;
    if (const auto number = joined_number(p.syntax, p.syntax.values_of(s).front(), &joint)) {
      f.message += fmt::format(", for `{:g}` beside `{}` is compared with nothing", *number, joint);
      f.help = fmt::format("write a whole comparison on each side of `{}`", joint);
    }
    f.reach = in.flow.reach(c.statement);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW608",
    .name = "condition-constant",
    .summary = "a condition that is the same every time; a branch that never runs",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A condition whose result is already known, from an earlier condition or from an assignment: an inner
`if` that contradicts the outer one, an `elseif` with the condition of a branch above it, a `while`
whose counter starts on the wrong side.

`[1]` and `[0]` are not reported, because they are written on purpose. Nor is a number that is set
once in the program, for the user to change.)",
            .why = R"(LinuxCNC evaluates the condition and goes the same way every time, without a message. The lines of
the other branch never run: in the first program below the machine stays at X0.)",
            .bad = R"(G21 G90
#1 = 0
G0 X0 Z5
o100 while [#1 GT 5]
  #1 = [#1 + 1]
  G0 X[#1 * 10]
o100 endwhile
M2
)",
            .good = R"(G21 G90
#1 = 0
G0 X0 Z5
o100 while [#1 LT 5]
  #1 = [#1 + 1]
  G0 X[#1 * 10]
o100 endwhile
M2
)",
            .fix = R"(Reverse the comparison, or compare with another number or parameter.)",
            .level_reason = "Warning: the program runs, but a part of it never runs, or always.",
            .interpreter = "",
            .options = "",
            .moves = "X0",
            .moves_good = "X50",
        },
    .check = check,
};

}  // namespace owlint::rules::ow608
