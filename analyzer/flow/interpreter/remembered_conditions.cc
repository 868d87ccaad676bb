// Conditions that must come out the same: see Fact in values.h. Structurally equal conditions share an id; assigning
// any parameter that a condition reads forgets its outcome.
#include <algorithm>
#include <span>

#include "analyzer/flow/interpreter/evaluator.h"
#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

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
      if (number >= 1 && number < kFirstVolatileNumber) return note(key);
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

}  // namespace

void Evaluator::find_facts() {
  std::vector<std::pair<uint64_t, ExprId>> tests;  // structure, condition
  Reads reads;
  for (const Statement& s :
       std::span(syntax_.statements).first(std::min(syntax_.statements.size(), limits_.remembered_statements))) {
    const bool is_test = s.is(Keyword::kIf) || s.is(Keyword::kElseif) || s.is(Keyword::kWhile);
    if (!is_test || s.value_count == 0) continue;
    const ExprId condition = syntax_.values[s.first];
    reads = {std::move(reads.keys)};
    reads.keys.clear();
    const uint64_t hash = describe(syntax_, condition, reads);
    if (reads.trackable && reads.local != reads.global) tests.emplace_back(hash, condition);
  }
  std::ranges::sort(tests);
  uint32_t next = 1;
  for (size_t first = 0, end = 0; first < tests.size(); first = end) {
    while (end < tests.size() && tests[end].first == tests[first].first) ++end;
    reads = {std::move(reads.keys)};
    reads.keys.clear();
    describe(syntax_, tests[first].second, reads);
    // Tested in one place only, an outcome decides nothing later, but for what is the same in the next pass and call; to
    // remember it would only tell states apart.
    if (end - first < 2 && reads.changes) continue;
    const bool crowded = std::ranges::any_of(
        reads.keys, [&](ParameterKey key) { return facts_of_[key].size() >= limits_.conditions_of_one; });
    if (crowded) continue;
    const Fact fact{next++, is_global(reads.keys.front())};
    for (const ParameterKey key : reads.keys) facts_of_[key].push_back(fact.id);
    for (size_t i = first; i < end; ++i) {
      const ExprId condition = tests[i].second;
      if (condition >= facts_.size()) facts_.resize(std::max<size_t>(condition + 1, facts_.size() * 2));
      facts_[condition] = fact;
    }
  }
}

Fact Evaluator::fact(ExprId condition) const { return condition < facts_.size() ? facts_[condition] : Fact{}; }

int Evaluator::known(const Parameters& p, Fact fact) {
  return fact.id == 0 ? 0 : static_cast<int>((fact.global ? p.global_facts : p.local_facts).get(fact.id));
}

void Evaluator::learn(Parameters& p, Fact fact, bool truth) const {
  if (fact.id != 0 && !coarse_) (fact.global ? p.global_facts : p.local_facts).set(pool_, fact.id, truth ? 1 : 2);
}

void Evaluator::forget_facts(Parameters& p, ParameterKey key) const {
  if (facts_of_.empty()) return;
  const auto found = facts_of_.find(key);
  if (found == facts_of_.end()) return;
  for (const uint32_t id : found->second) (is_global(key) ? p.global_facts : p.local_facts).set(pool_, id, 0);
}

void Evaluator::call_outside(Parameters& p) {
  p.outside = true;
  p.globals = {};
  p.global_facts = {};
}

}  // namespace owlint::flow
