// What the outcome of lines depends on: the parameters in them, and what is tracked of these because of lines elsewhere.
#include <bit>

#include "analyzer/flow/interpreter/evaluator.h"
#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

void Evaluator::note_number(long number, Dependence& out) const {
  const bool local = number < kFirstGlobalNumber;
  out.circumstances.push_back(relevant_number_[number] ? 'r' : '-');
  if (local) out.circumstances.push_back(read_argument_[number] ? 'a' : '-');
  out.circumstances.push_back(is_compared(static_cast<uint32_t>(number) | (local ? 0 : kGlobalKey)) ? 'c' : '-');
  (local ? out.locals : out.globals).push_back(static_cast<uint32_t>(number));
}

void Evaluator::note_name(NameId name, Dependence& out) const {
  const bool global = global_name(name);
  out.circumstances.push_back(relevant_name_[name] ? 'r' : '-');
  out.circumstances.push_back(kept_[name] || asked_for_[name] ? 'k' : '-');
  out.circumstances.push_back(is_compared(key_of_name(name)) ? 'c' : '-');
  (global ? out.globals : out.locals).push_back((global ? kGlobalNames : kLocalNames) + name);
}

// Depth is bounded by the length of a line.
void Evaluator::note(ExprId id, Dependence& out) const {
  const Expr& expr = syntax_.exprs[id];
  const Fact tested = fact(id);
  out.circumstances.push_back(tested.id != 0 ? 'f' : '-');
  if (tested.id != 0 && tested.global) out.global_facts = true;
  if (expr.op == Operator::kNumber) return;
  if (expr.op == Operator::kNamed || expr.op == Operator::kExistsNamed) return note_name(expr.name(), out);
  if (expr.op == Operator::kParameter) {
    double number = 0;
    long index = 0;
    const bool literal = literal_value(syntax_.exprs, expr.left(), &number) && to_integer(number, &index) &&
        index >= 1 && index <= kLastNumber;
    if (!literal) {
      out.known = false;
      return;
    }
    return note_number(index, out);
  }
  if (expr.left() != kNoExpr) note(expr.left(), out);
  if (expr.right() != kNoExpr) note(expr.right(), out);
}

bool Evaluator::note_assignments(const Statement& s, Dependence& out) const {
  for (uint32_t i = 0; i < s.item_count && out.known; ++i) {
    const Item& item = syntax_.items[s.first + i];
    note(item.value, out);
    if (item.target_name != kNoName) {
      if (global_name(item.target_name)) return false;
      note_name(item.target_name, out);
    }
    if (item.target == kNoExpr) continue;
    double number = 0;
    long index = 0;
    const bool own = literal_value(syntax_.exprs, item.target, &number) && to_integer(number, &index) && index >= 1 &&
        index < kFirstGlobalNumber;
    if (!own) return false;
    note_number(index, out);
  }
  return out.known;
}

uint64_t Evaluator::machine_values() const {
  uint64_t out = 0;
  for (NameId name = 0; name < kinds_.size(); ++name) {
    const std::string_view text = syntax_.names.text(name);
    if (!may_be_predefined(text)) continue;
    out = mix(out, static_cast<uint64_t>(kinds_[name]));
    if (const auto number = ini_number(text, profile_)) out = mix(out, std::bit_cast<uint64_t>(*number));
  }
  return out;
}

}  // namespace owlint::flow
