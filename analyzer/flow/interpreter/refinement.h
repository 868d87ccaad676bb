// What the outcome of a condition says about the parameters in it: after `if [#1 GT 5]` #1 is greater than 5. Only where it
// can matter: it tells states apart that a parameter compared once would not.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "analyzer/flow/interpreter/evaluator.h"

namespace owlint::flow {

class Refinement {
 public:
  /// Also gives `evaluator`'s values their thresholds: the numbers that conditions compare with. All must outlive it.
  Refinement(const Syntax& syntax, const TrackedParameters& tracked, const Limits& limits, Evaluator& evaluator,
             PersistentMap::Pool& pool);

  /// From now on nothing is concluded: for very large programs.
  void set_coarse() { coarse_ = true; }
  /// Applies what the outcome of a condition says about the parameters that it compares.
  void refine(Parameters& p, ExprId condition, bool truth);
  /// Whether outcomes say something about a parameter.
  bool is_compared(ParameterKey key) const {
    return std::ranges::binary_search(compared_, key, {}, &std::pair<ParameterKey, uint8_t>::first);
  }
  /// Adds the parameters that a condition reads, by their keys. Whether its outcomes are followed
  /// exactly: what it compares are parameters with numbers, and they keep their values.
  bool followed(ExprId condition, std::vector<ParameterKey>& reads) const;

 private:
  /// How a parameter is compared: once, more than once, in the condition of a `while`; and that it is set to something that is
  /// no plain number, so that it may count, or that an operation can fail for its value.
  enum Comparison : uint8_t { kOnce = 1, kMoreThanOnce = 2, kByLoop = 4, kComputed = 8, kCanFail = 16 };

  void find_compared(const Limits& limits);
  ParameterKey counted_key_of(ExprId side, std::vector<double>& numbers) const;
  std::vector<std::vector<double>> numbers_passed() const;
  std::vector<double> compared_numbers(ExprId other, bool of_while);
  void count_comparisons(ExprId id, bool of_while, std::vector<double>& thresholds);
  uint8_t* compared(ParameterKey key);
  /// The key of a parameter that keeps its value in spite of code that owlint does not follow.
  ParameterKey trusted_key_of(ExprId side) const;
  void narrow(Parameters& p, ExprId side, Operator op, ExprId other, bool truth);
  void find_existing(Parameters& p, ExprId condition, bool truth);
  bool tells_existence(const Expr& comparison, bool truth, NameId* name) const;

  const Syntax& syntax_;
  const TrackedParameters& tracked_;
  Evaluator& evaluator_;
  PersistentMap::Pool& pool_;
  std::vector<std::pair<ParameterKey, uint8_t>> compared_;  // sorted, each parameter once
  std::vector<std::vector<double>> passed_;                 // by argument; empty until asked for
  bool coarse_ = false;
};

}  // namespace owlint::flow
