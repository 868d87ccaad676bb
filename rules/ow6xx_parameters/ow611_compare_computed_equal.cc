// OW611 compare-computed-equal: `EQ` or `NE` on values that are computed with fractions.
// Depends on: EQ is true for numbers that differ by less than 0.0001 (measured); sums of fractions drift by less or
// more than that.
#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow611 {
namespace {

/// Parameters that are assigned something computed with fractions.
struct Computed {
  explicit Computed(const Program& p) {
    for (const Item& item : p.syntax.items) {
      if ((item.target_name == kNoName && item.target == kNoExpr) || !computes_fraction(p, item.value)) continue;
      if (item.target_name != kNoName)
        names.insert(item.target_name);
      else if (p.syntax.exprs[item.target].op == Operator::kNumber)
        numbers.insert(static_cast<long>(p.syntax.exprs[item.target].value()));
    }
  }
  std::unordered_set<NameId> names;
  std::unordered_set<long> numbers;
};

/// Whether one side of a comparison is computed so, here or where its parameter is assigned.
bool computed(const Program& p, const Computed& by, ExprId side) {
  const Expr& expr = p.syntax.exprs[side];
  if (expr.op == Operator::kNamed) return by.names.contains(expr.name());
  if (expr.op == Operator::kParameter) {
    const Expr& number = p.syntax.exprs[expr.left()];
    return number.op == Operator::kNumber && by.numbers.contains(static_cast<long>(number.value()));
  }
  return computes_fraction(p, side);
}

// Depth is bounded by the length of a line.
bool compares(const Program& p, const Computed& by, ExprId id) {
  const Expr& expr = p.syntax.exprs[id];
  if (expr.op == Operator::kEq || expr.op == Operator::kNe)
    return any_operand(expr, [&](ExprId side) { return computed(p, by, side); });
  if (expr.op != Operator::kAnd && expr.op != Operator::kOr && expr.op != Operator::kXor) return false;
  return any_operand(expr, [&](ExprId operand) { return compares(p, by, operand); });
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  if (in.index.tests.empty()) return;
  const Computed by(p);
  for (const StatementId id : in.index.tests) {
    const Statement& s = p.at(id);
    if (!compares(p, by, p.syntax.values_of(s).front())) continue;
    Finding& f = out.add(
        s.head_span(), "`" + p.head(id) + "` tests whether a computed value is equal: `EQ` is true only within 0.0001");
    f.help = "compare with `LT` or `GT`, or test the distance: `[ABS[#1 - #2] LT 0.001]`";
    f.reach = in.flow.reach(id);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW611",
    .name = "compare-computed-equal",
    .summary = "`EQ` or `NE` on computed values",
    .group = Group::kDataFlow,
    .level = Severity::kInfo,
    .page =
        {
            .what =
                R"(A condition with `EQ` or `NE` on a value that is a quotient, a root, an angle or a sum of fractions.)",
            .why = R"(Numbers such as 1/3 or 25.4/20 are rounded, and steps of them do not reach their end exactly. For
LinuxCNC two numbers are equal if they differ by less than 0.0001. If a step misses the end by more,
the loop goes past it, and a loop with `NE` never ends. In the first program below, the step is 1/3
rounded to four digits and the end is 10, so `EQ` is never true. The loop ends only because of its
first condition.)",
            .bad = R"(G21 G90
#<z> = 0
#<found> = 0
o100 while [#<z> LT 10]
  #<z> = [#<z> + 0.3333]
  o110 if [#<z> EQ 10]
    #<found> = 1
  o110 endif
o100 endwhile
G0 X[#<found> * 50]
M2
)",
            .good = R"(G21 G90
#<z> = 0
#<found> = 0
o100 while [#<z> LT 10]
  #<z> = [#<z> + 0.3333]
  o110 if [#<z> GE 10]
    #<found> = 1
  o110 endif
o100 endwhile
G0 X[#<found> * 50]
M2
)",
            .fix = R"(Compare with `LT`, `LE`, `GT` or `GE`, count passes in whole numbers, or test the distance.)",
            .level_reason = "Info: the comparison works in most programs, but should be checked.",
            .interpreter = "",
            .options = "--extend-select OW611",
            .moves = "X0",
            .moves_good = "X50",
        },
    .check = check,
};

}  // namespace owlint::rules::ow611
