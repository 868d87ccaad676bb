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
  add_in(syntax, expr.left(), out);
  if (expr.right() != kNoExpr) add_in(syntax, expr.right(), out);
}

}  // namespace

void add_fallible(const Syntax& syntax, const Statement& s, std::vector<ExprId>& out) {
  for (uint32_t i = 0; i < s.value_count; ++i) add_in(syntax, syntax.values[s.first + i], out);
  for (uint32_t i = 0; i < s.item_count; ++i) add_in(syntax, syntax.items[s.first + i].value, out);
}

}  // namespace owlint::flow
