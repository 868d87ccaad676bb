// Conditions that must come out the same: see Fact in values.h. Structurally equal conditions share an id; assigning
// any parameter that a condition reads forgets its outcome.
#include <algorithm>
#include <span>

#include "analyzer/flow/values.h"
#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"

namespace owlint::flow {
namespace {

// A parameter that more conditions than this read would make every assignment to it expensive.
constexpr size_t kMaxFactsOfOne = 64;

struct Reads {
  std::vector<uint32_t> local, global;
  bool trackable = true;
};

/// Structure of an expression as a number, and what it reads. Depth is bounded by the length of a line.
uint64_t describe(const Syntax& syntax, ExprId id, Reads& reads) {
  const Expr& expr = syntax.exprs[id];
  uint64_t hash = static_cast<uint64_t>(expr.op) + 1;
  switch (expr.op) {
    case Operator::kNumber:
      return mix(hash, std::hash<double>()(expr.value()));
    case Operator::kNamed: {
      const std::string_view text = syntax.names.text(expr.name());
      const bool global = text.starts_with("_");
      if (predefined_name(text) || machine_name(text)) reads.trackable = false;
      (global ? reads.global : reads.local).push_back((global ? kGlobalNames : kLocalNames) + expr.name());
      return mix(hash, expr.name());
    }
    case Operator::kParameter: {
      double number = 0;
      long index = 0;
      const bool known = literal_value(syntax.exprs, expr.left(), &number) && to_integer(number, &index);
      if (!known || index < 1 || index >= kFirstVolatileNumber) {
        reads.trackable = false;
        return hash;
      }
      (index < kFirstGlobalNumber ? reads.local : reads.global).push_back(static_cast<uint32_t>(index));
      return mix(hash, static_cast<uint64_t>(index));
    }
    case Operator::kExistsNamed: case Operator::kExistsNumbered:
      reads.trackable = false;
      return hash;
    default:
      break;
  }
  hash = mix(hash, describe(syntax, expr.left(), reads));
  return expr.right() == kNoExpr ? hash : mix(hash, describe(syntax, expr.right(), reads));
}

}  // namespace

void Evaluator::find_facts() {
  struct Test {
    std::vector<ExprId> conditions;
    Reads reads;
  };
  std::unordered_map<uint64_t, Test> tests;
  std::vector<uint64_t> order;
  // The detailed analysis of a very large program does not get further than this.
  constexpr size_t kMaxStatements = 100'000;
  for (const Statement& s : std::span(syntax_.statements).first(std::min(syntax_.statements.size(), kMaxStatements))) {
    const bool is_test = s.is(Keyword::kIf) || s.is(Keyword::kElseif) || s.is(Keyword::kWhile);
    if (!is_test || s.value_count == 0) continue;
    const ExprId condition = syntax_.values[s.first];
    Reads reads;
    const uint64_t hash = describe(syntax_, condition, reads);
    if (!reads.trackable || reads.local.empty() == reads.global.empty()) continue;
    Test& test = tests[hash];
    if (test.conditions.empty()) order.push_back(hash);
    test.conditions.push_back(condition);
    test.reads = std::move(reads);
  }
  uint32_t next = 1;
  for (const uint64_t hash : order) {
    const Test& test = tests[hash];
    // Tested in one place only, an outcome decides nothing later; remembering it would only tell states apart.
    if (test.conditions.size() < 2) continue;
    const bool global = test.reads.local.empty();
    const auto& keys = global ? test.reads.global : test.reads.local;
    const bool crowded = std::ranges::any_of(keys, [&](uint32_t key) { return facts_of_[global][key].size() >= kMaxFactsOfOne; });
    if (crowded) continue;
    const Fact fact{next++, global};
    for (const uint32_t key : keys) facts_of_[global][key].push_back(fact.id);
    for (const ExprId condition : test.conditions) {
      if (condition >= facts_.size()) facts_.resize(std::max<size_t>(condition + 1, facts_.size() * 2));
      facts_[condition] = fact;
    }
  }
}

Fact Evaluator::fact(ExprId condition) const {
  return condition < facts_.size() ? facts_[condition] : Fact{};
}

int Evaluator::known(const Parameters& p, Fact fact) {
  return fact.id == 0 ? 0 : static_cast<int>((fact.global ? p.global_facts : p.local_facts).get(fact.id));
}

void Evaluator::learn(Parameters& p, Fact fact, bool truth) const {
  if (fact.id != 0 && !coarse_) (fact.global ? p.global_facts : p.local_facts).set(pool_, fact.id, truth ? 1 : 2);
}

void Evaluator::forget_facts(Parameters& p, uint32_t key, bool global) const {
  const auto found = facts_of_[global].find(key);
  if (found == facts_of_[global].end()) return;
  for (const uint32_t id : found->second) (global ? p.global_facts : p.local_facts).set(pool_, id, 0);
}

void Evaluator::call_outside(Parameters& p) {
  p.outside = true;
  p.globals = {};
  p.global_facts = {};
}

}  // namespace owlint::flow
