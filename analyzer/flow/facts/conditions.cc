#include "analyzer/flow/facts/conditions.h"

#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

// Depth is bounded by the length of a line.
bool compares_with_numbers(const Syntax& syntax, ExprId condition) {
  const Expr& expr = syntax.exprs[condition];
  if (expr.op == Operator::kAnd || expr.op == Operator::kOr)
    return compares_with_numbers(syntax, expr.left()) && compares_with_numbers(syntax, expr.right());
  double number = 0;
  return is_comparison(expr.op) &&
      (literal_value(syntax.exprs, expr.left(), &number) || literal_value(syntax.exprs, expr.right(), &number));
}

}  // namespace owlint::flow
