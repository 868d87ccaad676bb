#include "analyzer/flow/interpreter/kept_values.h"

#include "analyzer/flow/facts/accesses.h"

namespace owlint::flow {
namespace {

class KeptValues {
 public:
  KeptValues(const Syntax& syntax, const Parameters& in, Evaluator& evaluator)
      : syntax_(syntax), in_(in), evaluator_(evaluator) {}

  bool keeps(const Item& item) const {
    const ParameterKey target = key_of_target(syntax_, item);
    if (target == kComputedKey) return false;
    if (is_target(item.value, target)) return true;
    const Expr& value = syntax_.exprs[item.value];
    switch (value.op) {
      case Operator::kPlus:
        return (is_target(value.left(), target) && is(value.right(), 0)) ||
            (is_target(value.right(), target) && is(value.left(), 0));
      case Operator::kMinus: return is_target(value.left(), target) && is(value.right(), 0);
      case Operator::kTimes:
        return (is_target(value.left(), target) && is(value.right(), 1)) ||
            (is_target(value.right(), target) && is(value.left(), 1));
      case Operator::kDivide: return is_target(value.left(), target) && is(value.right(), 1);
      default: return false;
    }
  }

 private:
  bool is_target(ExprId id, ParameterKey target) const {
    const Expr& expr = syntax_.exprs[id];
    if (expr.op == Operator::kNamed) return key_of_name(syntax_, expr.name()) == target;
    return expr.op == Operator::kParameter && key_of_number(syntax_, expr.left()) == target;
  }
  bool is(ExprId id, double number) const {
    const ValueId value = evaluator_.evaluate(id, in_).value;
    return KnownValues::is_constant(value) && evaluator_.values().value(value) == number;
  }

  const Syntax& syntax_;
  const Parameters& in_;
  Evaluator& evaluator_;
};

}  // namespace

bool keeps_values(const Syntax& syntax, const Statement& line, const Parameters& in, Evaluator& evaluator) {
  const KeptValues values(syntax, in, evaluator);
  bool any = false;
  for (const Item& item : syntax.items_of(line)) {
    if (!assigns(item)) continue;
    any = true;
    if (!values.keeps(item)) return false;
  }
  return any;
}

}  // namespace owlint::flow
