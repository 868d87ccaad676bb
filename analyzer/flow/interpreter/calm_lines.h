// Which lines are harmless by themselves, whatever the values of parameters are: they cannot stop, and jump only within
// their own loop. calm.cc joins them to stretches.
#pragma once

#include <vector>

#include "analyzer/flow/facts/structured.h"
#include "analyzer/flow/interpreter/evaluator.h"

namespace owlint::flow {

/// What an expression may do if every parameter is unknown.
struct Look {
  bool safe = true;  ///< it cannot fail
  bool constant = false;
  double value = 0;  ///< of a constant
};

class CalmLines {
 public:
  CalmLines(const Program& program, const Structure& structure, const TrackedParameters& tracked,
            const Evaluator& evaluator);

  /// For a part of a block: harmless if the whole block is. Not for calls and subs.
  bool harmless(StatementId id) const;
  /// Whether a line matters even while lines are skipped.
  bool stop_when_skipped(StatementId id) const;
  /// How far out the jumps in a block lead: the first line of the outermost loop that a line in it leaves or continues.
  StatementId jumps_to(BlockId block) const { return jumps_to_[block]; }
  Look look(ExprId id) const;
  /// The number of a parameter whose index is safe and constant.
  uint32_t number_of(ExprId index) const;

 private:
  void find_escapes();
  bool harmless_words(const Statement& s) const;

  const Program& program_;
  const Structure& structure_;
  const TrackedParameters& tracked_;
  const Evaluator& evaluator_;
  // `break` and `do` together leave flags (OW501, OW509), so a program's stretches have only one of the two.
  bool jumps_ = false;
  bool do_loops_ = false;
  std::vector<StatementId> jumps_to_;  // by block
};

}  // namespace owlint::flow
