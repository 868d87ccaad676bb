#include "analyzer/flow/interpreter/remembered_conditions.h"

#include <algorithm>

#include "analyzer/machine/predefined.h"

namespace owlint::flow {
namespace {

struct Reads {
  std::vector<ParameterKey> keys;
  bool global = false, local = false;
  bool trackable = true;
  bool changes = false;  ///< it reads what can change while the program runs
};

/// Structure of an expression as a number, and what it reads. Depth is bounded by the length of a line.
uint64_t describe(const Syntax& syntax, ExprId id, Reads& reads) {
  const Expr& expr = syntax.exprs[id];
  const uint64_t hash = static_cast<uint64_t>(expr.op) + 1;
  const auto note = [&](ParameterKey key) {
    (is_global(key) ? reads.global : reads.local) = true;
    reads.keys.push_back(key);
    return mix(hash, key);
  };
  switch (expr.op) {
    case Operator::kNumber: return mix(hash, std::hash<double>()(expr.value()));
    case Operator::kNamed:
      if (!fixed_by_machine(syntax.names.text(expr.name()))) {
        reads.changes = true;
        if (may_be_predefined(syntax.names.text(expr.name()))) reads.trackable = false;
      }
      return note(key_of_name(syntax, expr.name()));
    case Operator::kParameter: {
      reads.changes = true;
      const ParameterKey key = key_of_number(syntax, expr.left());
      const ParameterKey number = key & ~kGlobalKey;
      const auto text = static_cast<long>(number);
      if (text >= 1 && (text < kFirstVolatileNumber || is_answer(text))) return note(key);
      reads.trackable = false;
      return hash;
    }
    case Operator::kExistsNamed:
    case Operator::kExistsNumbered: reads.trackable = false; return hash;
    default: break;
  }
  const uint64_t left = mix(hash, describe(syntax, expr.left(), reads));
  return expr.right() == kNoExpr ? left : mix(left, describe(syntax, expr.right(), reads));
}

struct Test {
  uint64_t structure = 0;
  uint64_t around = 0;  ///< the structure of the line's condition, if this is a part of it
  ExprId condition = kNoExpr;
  bool negated = false;

  auto operator<=>(const Test&) const = default;
};

bool joins(const Expr& expr) { return expr.op == Operator::kAnd || expr.op == Operator::kOr; }

/// Of two conditions that are opposites, such as `a EQ b` and `a NE b`, one is described as the other, negated. `a` alone is
/// `a NE 0`, but for numbers next to 0, for which LinuxCNC's `NE` has a tolerance.
Test describe_test(const Syntax& syntax, ExprId condition, Reads& reads) {
  const Expr& expr = syntax.exprs[condition];
  const auto both = [&](Operator op, bool swapped) {
    const uint64_t left = describe(syntax, expr.left(), reads), right = describe(syntax, expr.right(), reads);
    const uint64_t hash = static_cast<uint64_t>(op) + 1;
    return swapped ? mix(mix(hash, right), left) : mix(mix(hash, left), right);
  };
  switch (expr.op) {
    case Operator::kEq: return {both(Operator::kEq, false), 0, condition, false};
    case Operator::kNe: return {both(Operator::kEq, false), 0, condition, true};
    case Operator::kGt: return {both(Operator::kGt, false), 0, condition, false};
    case Operator::kLe: return {both(Operator::kGt, false), 0, condition, true};
    case Operator::kLt: return {both(Operator::kGt, true), 0, condition, false};
    case Operator::kGe: return {both(Operator::kGt, true), 0, condition, true};
    default: break;
  }
  const uint64_t zero = mix(static_cast<uint64_t>(Operator::kNumber) + 1, std::hash<double>()(0.0));
  return {mix(mix(static_cast<uint64_t>(Operator::kEq) + 1, describe(syntax, condition, reads)), zero), 0, condition,
          true};
}

/// The tests of a line: its condition, and what it joins. Depth is bounded by the length of a line.
void add_tests(const Syntax& syntax, ExprId condition, uint64_t around, std::vector<Test>& tests) {
  Reads reads;
  Test test = describe_test(syntax, condition, reads);
  test.around = around;
  if (reads.trackable && reads.local != reads.global) tests.push_back(test);
  const Expr& expr = syntax.exprs[condition];
  if (!joins(expr)) return;
  const uint64_t whole = around != 0 ? around : test.structure;
  add_tests(syntax, expr.left(), whole, tests);
  add_tests(syntax, expr.right(), whole, tests);
}

/// Whether what one of these tests has found decides another one: parts of one condition come out together.
bool are_apart(std::span<const Test> alike) {
  return alike.size() > 1 && (alike[1].around == 0 || alike.front().around != alike.back().around);
}

}  // namespace

RememberedConditions::RememberedConditions(const Syntax& syntax, const Limits& limits, PersistentMap::Pool& pool)
    : syntax_(syntax), pool_(pool) {
  find_tests(limits);
  for (const auto& [key, ids] : conditions_of_) {
    if (is_global(key) && is_answer(static_cast<long>(key & ~kGlobalKey))) answers_.push_back(key);
  }
}

void RememberedConditions::find_tests(const Limits& limits) {
  std::vector<Test> tests;
  const std::span all(syntax_.statements);
  for (const Statement& s : all.first(std::min(all.size(), limits.remembered_statements))) {
    const bool is_test = s.is(Keyword::kIf) || s.is(Keyword::kElseif) || s.is(Keyword::kWhile);
    if (is_test && s.value_count > 0) add_tests(syntax_, syntax_.values_of(s).front(), 0, tests);
  }
  std::ranges::sort(tests);
  uint32_t next = 1;
  for (size_t first = 0, end = 0; first < tests.size(); first = end) {
    while (end < tests.size() && tests[end].structure == tests[first].structure) ++end;
    Reads reads;
    describe(syntax_, tests[first].condition, reads);
    // Tested in one place only, an outcome decides nothing later, but for what is the same in the next pass and call; to
    // remember it would only tell states apart.
    if (reads.changes && !are_apart(std::span(tests).subspan(first, end - first))) continue;
    const bool crowded = std::ranges::any_of(
        reads.keys, [&](ParameterKey key) { return conditions_of_[key].size() >= limits.conditions_of_one; });
    if (crowded) continue;
    const ConditionId id{next++, is_global(reads.keys.front()), false};
    for (const ParameterKey key : reads.keys) conditions_of_[key].push_back(id.id);
    for (size_t i = first; i < end; ++i) {
      const ExprId condition = tests[i].condition;
      if (condition >= conditions_.size()) conditions_.resize(std::max<size_t>(condition + 1, conditions_.size() * 2));
      conditions_[condition] = {id.id, id.global, tests[i].negated};
    }
  }
}

// Depth is bounded by the length of a line.
Outcome RememberedConditions::known(const Parameters& p, ExprId condition) const {
  const ConditionId id = this->condition(condition);
  const auto kept = id.id == 0 ? Outcome::kNotKnown
                               : static_cast<Outcome>((id.global ? p.global_outcomes : p.local_outcomes).get(id.id));
  if (kept != Outcome::kNotKnown) return (kept == Outcome::kTrue) != id.negated ? Outcome::kTrue : Outcome::kFalse;
  const Expr& expr = syntax_.exprs[condition];
  if (!joins(expr)) return Outcome::kNotKnown;
  const Outcome decides = expr.op == Operator::kAnd ? Outcome::kFalse : Outcome::kTrue;
  const Outcome left = known(p, expr.left());
  if (left == decides) return decides;
  const Outcome right = known(p, expr.right());
  return right == decides || left == right ? right : Outcome::kNotKnown;
}

// Depth is bounded by the length of a line.
void RememberedConditions::learn(Parameters& p, ExprId condition, bool truth) {
  if (coarse_) return;
  if (const ConditionId id = this->condition(condition); id.id != 0) {
    const Outcome outcome = truth != id.negated ? Outcome::kTrue : Outcome::kFalse;
    (id.global ? p.global_outcomes : p.local_outcomes).set(pool_, id.id, static_cast<uint32_t>(outcome));
  }
  const Expr& expr = syntax_.exprs[condition];
  if (!joins(expr)) return;
  const bool all = truth == (expr.op == Operator::kAnd);
  // Of `[#1 AND #2]`, false where `#1` is true, it is `#2` that is false.
  const Outcome passes = truth ? Outcome::kFalse : Outcome::kTrue;
  const Outcome left = known(p, expr.left()), right = known(p, expr.right());
  if (all || right == passes) learn(p, expr.left(), truth);
  if (all || left == passes) learn(p, expr.right(), truth);
}

void RememberedConditions::forget(Parameters& p, ParameterKey key) {
  for (const uint32_t id : conditions_of(key))
    (is_global(key) ? p.global_outcomes : p.local_outcomes).set(pool_, id, 0);
}

void RememberedConditions::forget_answers(Parameters& p) {
  for (const ParameterKey key : answers_) forget(p, key);
}

}  // namespace owlint::flow
