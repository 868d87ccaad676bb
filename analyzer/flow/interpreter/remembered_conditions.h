// Conditions that must come out the same (see ConditionId): structurally equal conditions share an id, and assigning any
// parameter that a condition reads forgets its outcome. What AND and OR join are conditions, too: `[#1 AND #2]` is true only
// where `[#1]` is.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "analyzer/flow/domain/known_parameters.h"
#include "analyzer/flow/facts/accesses.h"
#include "analyzer/flow/limits.h"
#include "analyzer/syntax/statement.h"

namespace owlint::flow {

/// What a state knows of a condition; the values are those of the maps in Parameters.
enum class Outcome : uint8_t { kNotKnown = 0, kTrue = 1, kFalse = 2 };

class RememberedConditions {
 public:
  RememberedConditions(const Syntax& syntax, const Limits& limits, PersistentMap::Pool& pool);

  /// From now on outcomes are not remembered: for very large programs.
  void set_coarse() { coarse_ = true; }
  ConditionId condition(ExprId expression) const {
    return expression < conditions_.size() ? conditions_[expression] : ConditionId{};
  }
  /// From the outcome of the same condition, or from those that it joins.
  Outcome known(const Parameters& p, ExprId condition) const;
  void learn(Parameters& p, ExprId condition, bool truth);
  /// A parameter is assigned.
  void forget(Parameters& p, ParameterKey key);
  /// The machine's inputs are asked.
  void forget_answers(Parameters& p);

 private:
  void find_tests(const Limits& limits);
  /// Those that read a parameter.
  std::span<const uint32_t> conditions_of(ParameterKey key) const {
    const auto found = conditions_of_.find(key);
    return found == conditions_of_.end() ? std::span<const uint32_t>() : found->second;
  }

  const Syntax& syntax_;
  PersistentMap::Pool& pool_;
  std::vector<ConditionId> conditions_;  // by condition, as far as there are any
  std::unordered_map<ParameterKey, std::vector<uint32_t>> conditions_of_;
  std::vector<ParameterKey> answers_;  // of the keys of `conditions_of_`
  bool coarse_ = false;
};

}  // namespace owlint::flow
