#include "analyzer/flow/interpreter/fallible.h"

#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {
namespace {

/// Depth is bounded by the length of a line.
void add_in(const Syntax& syntax, ExprId id, std::vector<ExprId>& out) {
  const Expr& expr = syntax.exprs[id];
  double number = 0;
  switch (expr.op) {
    case Operator::kNumber:
    case Operator::kNamed:
    case Operator::kExistsNamed: return;
    case Operator::kParameter:
    case Operator::kSqrt:
    case Operator::kLn:
    case Operator::kAcos:
    case Operator::kAsin:
      if (literal_value(syntax.exprs, expr.left(), &number)) return;
      out.push_back(id);
      break;
    case Operator::kDivide:
      if (!literal_value(syntax.exprs, expr.right(), &number)) out.push_back(id);
      break;
    case Operator::kPower: out.push_back(id); break;
    default: break;
  }
  for_each_operand(expr, [&](ExprId operand) { add_in(syntax, operand, out); });
}

}  // namespace

void add_fallible(const Syntax& syntax, const Statement& s, std::vector<ExprId>& out) {
  for (const ExprId value : syntax.values_of(s)) add_in(syntax, value, out);
  for (const Item& item : syntax.items_of(s)) add_in(syntax, item.value, out);
}

}  // namespace owlint::flow
