#include "analyzer/flow/interpreter/tracked_parameters.h"

#include <utility>

#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/codes.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {

TrackedParameters::TrackedParameters(const Syntax& syntax, const Profile& profile, const Limits& limits)
    : syntax_(syntax),
      number_matters_(kLastNumber + 1),
      name_matters_(syntax.names.size()),
      argument_is_read_(kFirstGlobalNumber),
      assigned_(syntax.names.size()),
      asked_for_(syntax.names.size()) {
  kinds_.reserve(syntax.names.size());
  for (NameId name = 0; name < syntax.names.size(); ++name)
    kinds_.push_back(name_kind(syntax.names.text(name), profile));
  find_uses();
  find_what_matters(limits);
  for (uint32_t n = 1; n < kFirstGlobalNumber; ++n) {
    if (number_matters_[n] || argument_is_read_[n]) arguments_.push_back(n);
  }
}

ParameterKey TrackedParameters::key_of(ExprId side) const {
  const Expr& expr = syntax_.exprs[side];
  if (expr.op == Operator::kNamed) return key_of_name(expr.name());
  if (expr.op != Operator::kParameter) return kComputedKey;
  const ParameterKey key = key_of_number(syntax_, expr.left());
  const ParameterKey number = key & ~kGlobalKey;
  return number >= 1 && number < kFirstVolatileNumber ? key : kComputedKey;
}

ParameterKey TrackedParameters::lasting_key_of(ExprId side) const {
  const Expr& expr = syntax_.exprs[side];
  return expr.op == Operator::kNamed && kind(expr.name()) > NameKind::kGlobal ? kComputedKey : key_of(side);
}

bool TrackedParameters::mark_number(long number) {
  if (number <= 0 || number > kLastNumber || number_matters_[number]) return false;
  numbers_.push_back(static_cast<uint32_t>(number));
  return number_matters_[number] = true;
}

/// Marks the parameters that an expression reads; true when one of them is new. Recursion is bounded by the length of
/// one line.
bool TrackedParameters::mark(ExprId id) {
  const Expr& expr = syntax_.exprs[id];
  if (expr.op == Operator::kNumber) return false;
  if (expr.op == Operator::kNamed || expr.op == Operator::kExistsNamed) {
    if (name_matters_[expr.name()]) return false;
    return name_matters_[expr.name()] = true;
  }
  double number = 0;
  long index = 0;
  bool grew = false;
  if (expr.op == Operator::kParameter) {
    if (literal_value(syntax_.exprs, expr.left(), &number)) return to_integer(number, &index) && mark_number(index);
    grew = !std::exchange(computes_reads_, true);
  }
  for_each_operand(expr, [&](ExprId operand) { grew |= mark(operand); });
  return grew;
}

/// A parameter whose value decides whether an operation fails.
void TrackedParameters::mark_operand(ExprId id) {
  if (const ParameterKey key = lasting_key_of(id); key != kComputedKey) operands_.push_back(key);
  mark(id);
}

/// Marks what decides whether a value can be computed.
void TrackedParameters::mark_what_can_fail(ExprId id) {
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
  for_each_operand(expr, [this](ExprId operand) { mark_what_can_fail(operand); });
}

void TrackedParameters::find_uses() {
  for (const Expr& expr : syntax_.exprs) {
    if (expr.op == Operator::kExistsNamed) asked_for_[expr.name()] = true;
    if (expr.op == Operator::kNamed && expr.target && !assigned_[expr.name()]) {
      assigned_[expr.name()] = true;
      if (is_global(expr.name())) assigned_globals_.push_back(expr.name());
    }
    double number = 0;
    if (expr.op != Operator::kParameter || !literal_value(syntax_.exprs, expr.left(), &number)) continue;
    if (number >= 1 && number < kFirstGlobalNumber) argument_is_read_[static_cast<size_t>(number)] = true;
  }
}

void TrackedParameters::find_what_matters(const Limits& limits) {
  for (const ExprId value : syntax_.values) mark(value);
  for (const Item& item : syntax_.items) mark_what_can_fail(item.value);
  for (const ModeWord& word : syntax_.mode_words) {
    if (word.computed != kNoExpr && (syntax_.asks_place || (letter_set({&word.letter, 1}) & kPlaceLetters) == 0))
      mark(word.computed);
  }
  for (const LineError& error : syntax_.errors) {
    for (ExprId read = error.read_from; read < error.read_to; ++read) mark_what_can_fail(read);
    if (error.first_value != kNoExpr) mark(error.first_value);
  }
  for (const Statement& s : syntax_.statements) {
    if (s.label_expr != kNoExpr) mark(s.label_expr);
    if (!s.has_error()) continue;
    // Where a word has a number that it may not have, the line stops before its mistake further on is read.
    for (const Item& item : syntax_.items_of(s)) {
      if (item.letter != 0 && refuses_numbers(item.letter)) mark(item.value);
    }
  }
  // An assignment to a parameter that matters makes what it reads matter.
  for (int round = 0; round < limits.tracking_rounds && spread(); ++round) {
  }
  if ((computes_targets_ || computes_reads_) && numbers_.size() > limits.tracked_numbers) {
    number_matters_.assign(kLastNumber + 1, false);
    numbers_.clear();
    computes_reads_ = false;
  }
}

/// Once over all assignments; true if a parameter has come to matter.
bool TrackedParameters::spread() {
  bool grew = false;
  for (const Item& item : syntax_.items) {
    double number = 0;
    long index = 0;
    bool matters = item.target_name != kNoName && name_matters_[item.target_name];
    if (item.target != kNoExpr) {
      if (!literal_value(syntax_.exprs, item.target, &number)) {
        computes_targets_ = true;
        matters = true;
        grew |= mark(item.target);
      } else if (to_integer(number, &index) && index > 0 && index <= kLastNumber) {
        // What is read by a computed number may be any of them.
        grew |= computes_reads_ && mark_number(index);
        matters = number_matters_[index];
      }
    }
    if (matters) grew |= mark(item.value);
  }
  return grew;
}

}  // namespace owlint::flow
