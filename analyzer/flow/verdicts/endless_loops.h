// Loops without an end: those that no run leaves, those in which a run may go round for ever, and under FEATURE 0x20 ways round
// that an error which became a message makes.
#pragma once

#include <unordered_set>
#include <vector>

#include "analyzer/flow/engine/iteration.h"
#include "analyzer/flow/verdicts/hazards.h"

namespace owlint::flow {

class EndlessLoops {
 public:
  /// Of a finished analysis; all must outlive it. `warned`: records with an error that FEATURE 0x20 turned into a message;
  /// `keep_values`: those of assignments that change nothing.
  EndlessLoops(const Iteration& analysis, const std::unordered_set<RecordId>& warned,
               const std::unordered_set<RecordId>& keep_values, Hazards& hazards)
      : analysis_(analysis),
        program_(analysis.program()),
        trace_(*analysis.trace()),
        warned_(warned),
        keep_values_(keep_values),
        hazards_(hazards) {}

  /// Once: adds the hazards.
  void find();
  /// By record: it is in a loop that a run may not leave though others do.
  const std::vector<bool>& stuck() const { return stuck_; }
  /// There are such loops, or messages that lead round and round.
  bool may_go_round() const { return may_go_round_; }

 private:
  void find_idle();
  void find_closed();
  void find_stuck();
  void add(StatementId loop, bool is_left);
  bool is_around(StatementId loop, StatementId inner) const;
  std::vector<uint32_t> passed_well() const;

  const Iteration& analysis_;
  const Program& program_;
  Trace& trace_;
  const std::unordered_set<RecordId>& warned_;
  const std::unordered_set<RecordId>& keep_values_;
  Hazards& hazards_;
  std::vector<bool> stuck_;
  bool may_go_round_ = false;
};

}  // namespace owlint::flow
