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
  ExprId condition = kNoExpr;
  bool negated = false;

  auto operator<=>(const Test&) const = default;
};

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
    case Operator::kEq: return {both(Operator::kEq, false), condition, false};
    case Operator::kNe: return {both(Operator::kEq, false), condition, true};
    case Operator::kGt: return {both(Operator::kGt, false), condition, false};
    case Operator::kLe: return {both(Operator::kGt, false), condition, true};
    case Operator::kLt: return {both(Operator::kGt, true), condition, false};
    case Operator::kGe: return {both(Operator::kGt, true), condition, true};
    default: break;
  }
  const uint64_t zero = mix(static_cast<uint64_t>(Operator::kNumber) + 1, std::hash<double>()(0.0));
  return {mix(mix(static_cast<uint64_t>(Operator::kEq) + 1, describe(syntax, condition, reads)), zero), condition,
          true};
}

}  // namespace

RememberedConditions::RememberedConditions(const Syntax& syntax, const Limits& limits, PersistentMap::Pool& pool)
    : pool_(pool) {
  std::vector<Test> tests;
  Reads reads;
  for (const Statement& s :
       std::span(syntax.statements).first(std::min(syntax.statements.size(), limits.remembered_statements))) {
    const bool is_test = s.is(Keyword::kIf) || s.is(Keyword::kElseif) || s.is(Keyword::kWhile);
    if (!is_test || s.value_count == 0) continue;
    const ExprId condition = syntax.values_of(s).front();
    reads = {std::move(reads.keys)};
    reads.keys.clear();
    const Test test = describe_test(syntax, condition, reads);
    if (reads.trackable && reads.local != reads.global) tests.push_back(test);
  }
  std::ranges::sort(tests);
  uint32_t next = 1;
  for (size_t first = 0, end = 0; first < tests.size(); first = end) {
    while (end < tests.size() && tests[end].structure == tests[first].structure) ++end;
    reads = {std::move(reads.keys)};
    reads.keys.clear();
    describe(syntax, tests[first].condition, reads);
    // Tested in one place only, an outcome decides nothing later, but for what is the same in the next pass and call; to
    // remember it would only tell states apart.
    if (end - first < 2 && reads.changes) continue;
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
  for (const auto& [key, ids] : conditions_of_) {
    if (is_global(key) && is_answer(static_cast<long>(key & ~kGlobalKey))) answers_.push_back(key);
  }
}

Outcome RememberedConditions::known(const Parameters& p, ConditionId condition) {
  if (condition.id == 0) return Outcome::kNotKnown;
  const auto kept = static_cast<Outcome>((condition.global ? p.global_outcomes : p.local_outcomes).get(condition.id));
  if (!condition.negated || kept == Outcome::kNotKnown) return kept;
  return kept == Outcome::kTrue ? Outcome::kFalse : Outcome::kTrue;
}

void RememberedConditions::learn(Parameters& p, ConditionId condition, bool truth) {
  if (condition.id == 0 || coarse_) return;
  const Outcome outcome = truth != condition.negated ? Outcome::kTrue : Outcome::kFalse;
  (condition.global ? p.global_outcomes : p.local_outcomes).set(pool_, condition.id, static_cast<uint32_t>(outcome));
}

void RememberedConditions::forget(Parameters& p, ParameterKey key) {
  for (const uint32_t id : conditions_of(key))
    (is_global(key) ? p.global_outcomes : p.local_outcomes).set(pool_, id, 0);
}

void RememberedConditions::forget_answers(Parameters& p) {
  for (const ParameterKey key : answers_) forget(p, key);
}

}  // namespace owlint::flow
