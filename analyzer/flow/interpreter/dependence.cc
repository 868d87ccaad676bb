#include "analyzer/flow/interpreter/dependence.h"

#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

void Dependences::note_number(long number, Dependence& out) const {
  const bool local = number < kFirstGlobalNumber;
  out.circumstances.push_back(tracked_.number_matters(number) ? 'r' : '-');
  if (local) out.circumstances.push_back(tracked_.is_read(number) ? 'a' : '-');
  out.circumstances.push_back(refinement_.is_compared(static_cast<uint32_t>(number) | (local ? 0 : kGlobalKey)) ? 'c'
                                                                                                                : '-');
  (local ? out.locals : out.globals).push_back(static_cast<uint32_t>(number));
}

void Dependences::note_name(NameId name, Dependence& out) const {
  const bool global = tracked_.is_global(name);
  out.circumstances.push_back(tracked_.name_matters(name) ? 'r' : '-');
  out.circumstances.push_back(tracked_.is_assigned(name) || tracked_.is_asked_for(name) ? 'k' : '-');
  out.circumstances.push_back(refinement_.is_compared(tracked_.key_of_name(name)) ? 'c' : '-');
  (global ? out.globals : out.locals).push_back((global ? kGlobalNames : kLocalNames) + name);
}

// Depth is bounded by the length of a line.
void Dependences::note(ExprId id, Dependence& out) const {
  const Expr& expr = syntax_.exprs[id];
  const ConditionId tested = remembered_.condition(id);
  out.circumstances.push_back(tested.id != 0 ? 'f' : '-');
  if (tested.id != 0 && tested.global) out.global_outcomes = true;
  if (expr.op == Operator::kNumber) return;
  if (expr.op == Operator::kNamed || expr.op == Operator::kExistsNamed) return note_name(expr.name(), out);
  if (expr.op == Operator::kParameter) {
    const std::optional<long> index = literal_integer(syntax_.exprs, expr.left());
    if (!index || *index < 1 || *index > kLastNumber) {
      out.known = false;
      return;
    }
    return note_number(*index, out);
  }
  for_each_operand(expr, [&](ExprId operand) { note(operand, out); });
}

bool Dependences::note_assignments(const Statement& s, Dependence& out) const {
  for (const Item& item : syntax_.items_of(s)) {
    if (!out.known) break;
    note(item.value, out);
    if (item.target_name != kNoName) {
      if (tracked_.is_global(item.target_name)) return false;
      note_name(item.target_name, out);
    }
    if (item.target == kNoExpr) continue;
    const std::optional<long> index = literal_integer(syntax_.exprs, item.target);
    if (!index || *index < 1 || *index >= kFirstGlobalNumber) return false;
    note_number(*index, out);
  }
  return out.known;
}

}  // namespace owlint::flow
