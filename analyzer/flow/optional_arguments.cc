#include "analyzer/flow/optional_arguments.h"

#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

OptionalArguments::OptionalArguments(const Program& program) : program_(program) {
  for (StatementId id = 0; id < program.size(); ++id) {
    const Statement& s = program.at(id);
    const bool condition = s.is(Keyword::kIf) || s.is(Keyword::kElseif) || s.is(Keyword::kWhile);
    if (condition && s.value_count > 0) note(program.region_of[id], program.syntax.values[s.first]);
  }
}

// Depth is bounded by the length of a line, here and below.
void OptionalArguments::note(RegionId region, ExprId condition) {
  const Expr& expr = program_.syntax.exprs[condition];
  if (expr.op == Operator::kNumber) return;
  if (expr.op == Operator::kNamed) {
    tested_.insert(key(region, expr.name()));
    return;
  }
  if (expr.op == Operator::kExistsNamed) return;
  if (expr.left() != kNoExpr) note(region, expr.left());
  if (expr.right() != kNoExpr) note(region, expr.right());
}

bool OptionalArguments::reads(ExprId value, uint32_t number) const {
  const Expr& expr = program_.syntax.exprs[value];
  double index = 0;
  if (expr.op == Operator::kNumber || expr.op == Operator::kNamed || expr.op == Operator::kExistsNamed) return false;
  if (expr.op == Operator::kParameter && literal_value(program_.syntax.exprs, expr.left(), &index)) return index == number;
  return (expr.left() != kNoExpr && reads(expr.left(), number)) || (expr.right() != kNoExpr && reads(expr.right(), number));
}

bool OptionalArguments::copies(StatementId line, uint32_t number) const {
  const Statement& s = program_.at(line);
  if (s.kind != LineKind::kWords) return false;
  bool copied = false;
  for (uint32_t i = 0; i < s.item_count; ++i) {
    const Item& item = program_.syntax.items[s.first + i];
    if (!reads(item.value, number)) continue;
    const bool whole = program_.syntax.exprs[item.value].op == Operator::kParameter;
    if (!whole || item.target_name == kNoName || !tested_.contains(key(program_.region_of[line], item.target_name))) return false;
    copied = true;
  }
  return copied;
}

}  // namespace owlint::flow
