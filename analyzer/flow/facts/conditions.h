// What the outcome of a condition says about the values that it compares.
#pragma once

#include "analyzer/flow/domain/ranges.h"
#include "analyzer/syntax/statement.h"

namespace owlint::flow {

/// Calls `visit(side, op, other, truth)` for all comparisons whose outcome follows from the outcome of the condition, once for
/// each side; `other` is kNoExpr for `[#1]`, which is compared with 0. Depth is bounded by the length of a line.
template <typename Visit>
void for_known_comparisons(const ExprPool& exprs, ExprId condition, bool truth, const Visit& visit) {
  const Expr& expr = exprs[condition];
  if (expr.op == Operator::kAnd || expr.op == Operator::kOr) {
    if (truth != (expr.op == Operator::kAnd)) return;
    for_known_comparisons(exprs, expr.left(), truth, visit);
    for_known_comparisons(exprs, expr.right(), truth, visit);
  } else if (is_comparison(expr.op)) {
    visit(expr.left(), expr.op, expr.right(), truth);
    visit(expr.right(), mirrored(expr.op), expr.left(), truth);
  } else if (!truth && (expr.op == Operator::kNamed || expr.op == Operator::kParameter)) {
    visit(condition, Operator::kEq, kNoExpr, true);
  }
}

/// Whether a condition compares with numbers alone, as `[[#1 GT 0] AND [#2 LT 5]]` does.
bool compares_with_numbers(const Syntax& syntax, ExprId condition);

}  // namespace owlint::flow
