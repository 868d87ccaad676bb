// Which parameters matter: those on which a condition, label, count, argument or value can depend. Only they are tracked.
#include <algorithm>
#include <span>
#include <utility>

#include "analyzer/flow/interpreter/evaluator.h"
#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

bool Evaluator::mark_number(long number) {
  if (number <= 0 || number > kLastNumber || relevant_number_[number]) return false;
  tracked_numbers_.push_back(static_cast<uint32_t>(number));
  return relevant_number_[number] = true;
}

/// Marks the parameters that an expression reads; true when one of them is new. Recursion is bounded by the length of
/// one line.
bool Evaluator::mark(ExprId id) {
  const Expr& expr = syntax_.exprs[id];
  if (expr.op == Operator::kNumber) return false;
  if (expr.op == Operator::kNamed || expr.op == Operator::kExistsNamed) {
    if (relevant_name_[expr.name()]) return false;
    return relevant_name_[expr.name()] = true;
  }
  double number = 0;
  long index = 0;
  bool grew = false;
  if (expr.op == Operator::kParameter) {
    if (literal_value(syntax_.exprs, expr.left(), &number)) return to_integer(number, &index) && mark_number(index);
    grew = !std::exchange(computed_reads_, true);
  }
  if (expr.left() != kNoExpr && mark(expr.left())) grew = true;
  if (expr.right() != kNoExpr && mark(expr.right())) grew = true;
  return grew;
}

/// A parameter whose value decides whether an operation fails.
void Evaluator::mark_operand(ExprId id) {
  if (const ParameterKey key = key_if_kept(id); key != kComputedKey) compared_.emplace_back(key, kCanFail);
  mark(id);
}

/// Marks what decides whether a value can be computed.
void Evaluator::mark_what_can_fail(ExprId id) {
  const Expr& expr = syntax_.exprs[id];
  double number = 0;
  switch (expr.op) {
    case Operator::kNumber:
    case Operator::kNamed:
    case Operator::kExistsNamed: return;
    case Operator::kParameter:
      if (!literal_value(syntax_.exprs, expr.left(), &number)) mark(expr.left());
      return;
    case Operator::kDivide:
      if (!literal_value(syntax_.exprs, expr.right(), &number)) mark(expr.right());
      break;
    case Operator::kSqrt:
    case Operator::kLn:
    case Operator::kAcos:
    case Operator::kAsin: mark_operand(expr.left()); return;
    case Operator::kPower: mark(id); return;
    default: break;
  }
  mark_what_can_fail(expr.left());
  if (expr.right() != kNoExpr) mark_what_can_fail(expr.right());
}

void Evaluator::note_fallible(ExprId id, std::vector<ExprId>& out) const {
  const Expr& expr = syntax_.exprs[id];
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
      if (literal_value(syntax_.exprs, expr.left(), &number)) return;
      out.push_back(id);
      break;
    case Operator::kDivide:
      if (!literal_value(syntax_.exprs, expr.right(), &number)) out.push_back(id);
      break;
    case Operator::kPower: out.push_back(id); break;
    default: break;
  }
  note_fallible(expr.left(), out);
  if (expr.right() != kNoExpr) note_fallible(expr.right(), out);
}

void Evaluator::note_fallible(const Statement& s, std::vector<ExprId>& out) const {
  for (uint32_t i = 0; i < s.value_count; ++i) note_fallible(syntax_.values[s.first + i], out);
  for (uint32_t i = 0; i < s.item_count; ++i) note_fallible(syntax_.items[s.first + i].value, out);
}

void Evaluator::find_relevant() {
  for (const Expr& expr : syntax_.exprs) {
    if (expr.op == Operator::kExistsNamed) asked_for_[expr.name()] = true;
    if (expr.op == Operator::kNamed && expr.target && !kept_[expr.name()]) {
      kept_[expr.name()] = true;
      if (global_name(expr.name())) globals_.push_back(expr.name());
    }
    double number = 0;
    if (expr.op != Operator::kParameter || !literal_value(syntax_.exprs, expr.left(), &number)) continue;
    if (number >= 1 && number < kFirstGlobalNumber) read_argument_[static_cast<size_t>(number)] = true;
  }
  for (const ExprId value : syntax_.values) mark(value);
  for (const Item& item : syntax_.items) mark_what_can_fail(item.value);
  for (const Statement& s : syntax_.statements) {
    if (s.label_expr != kNoExpr) mark(s.label_expr);
  }
  // An assignment to a parameter that matters makes what it reads matter.
  bool grew = true;
  for (int round = 0; grew && round < limits_.tracking_rounds; ++round) {
    grew = false;
    for (const Item& item : syntax_.items) {
      double number = 0;
      long index = 0;
      bool matters = item.target_name != kNoName && relevant_name_[item.target_name];
      if (item.target != kNoExpr) {
        if (!literal_value(syntax_.exprs, item.target, &number)) {
          computed_targets_ = true;
          matters = true;
          grew |= mark(item.target);
        } else if (to_integer(number, &index) && index > 0 && index <= kLastNumber) {
          // What is read by a computed number may be any of them.
          grew |= computed_reads_ && mark_number(index);
          matters = relevant_number_[index];
        }
      }
      if (matters) grew |= mark(item.value);
    }
  }
  if ((computed_targets_ || computed_reads_) && tracked_numbers_.size() > limits_.tracked_numbers) {
    relevant_number_.assign(kLastNumber + 1, false);
    tracked_numbers_.clear();
    computed_reads_ = false;
  }
}

bool Evaluator::will_fail(std::span<const ExprId> operations, const Parameters& p) const {
  return std::ranges::any_of(operations, [&](ExprId id) {
    const StopKind stop = evaluate(id, p, false, false, nullptr).fails;
    return stop == StopKind::kValueFails || stop == StopKind::kParameterRange;
  });
}

}  // namespace owlint::flow
