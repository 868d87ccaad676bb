// From the analysis to its results: what each stop and each hazard is due to, and how it is reached. While the iteration runs,
// the events of single states are collected; what only the fixpoint shows comes at the end.
#pragma once

#include <map>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

#include "analyzer/flow/engine/iteration.h"
#include "analyzer/flow/verdicts/hazards.h"
#include "analyzer/flow/verdicts/limit_hazards.h"
#include "analyzer/flow/verdicts/mode_hazards.h"
#include "analyzer/flow/verdicts/stops.h"

namespace owlint::flow {

class Verdicts final : public Events {
 public:
  /// `analysis` must outlive it.
  explicit Verdicts(Iteration& analysis)
      : analysis_(analysis),
        program_(analysis.program()),
        trace_(*analysis.trace()),
        stops_(analysis.linked(), trace_),
        mode_hazards_(analysis),
        limit_hazards_(analysis.machine().machine_words()) {
    analysis.machine().set_watch(&mode_hazards_);
    if (analysis.machine().machine_words().has_limits) analysis.machine().set_watch(&limit_hazards_);
  }

  void stop(const State& at, StopReport report) override;
  void hazard(const State& at, HazardReport report) override;
  void end(const State& at) override;
  void end_of_file(const State& at) override;

  /// Once, after the iteration has run.
  FlowResult finish();

 private:
  /// A call that did not pass an argument which its sub reads.
  struct NotPassed {
    ContextId context;
    uint32_t number;
    StatementId read;
  };

  bool find_origin(const State& at, Hazard& hazard);
  void find_arguments_not_passed();
  void find_endless_recursions();
  void doubt_undefined_name(FlowStop& stop);
  FlowStop finished(Stops::Found& found, size_t* paths);

  Iteration& analysis_;
  const Program& program_;
  Trace& trace_;
  Stops stops_;
  Hazards hazards_;
  ModeHazards mode_hazards_;
  LimitHazards limit_hazards_;
  std::vector<NotPassed> not_passed_;
  std::unordered_set<RecordId> warned_;             // records with an error that FEATURE 0x20 turned into a message
  std::unordered_set<StatementId> run_own_helper_;  // calls that some run leads to the sub of their own file
  std::unordered_set<RecordId> keep_values_;        // records of assignments that change nothing
  std::vector<std::pair<ContextId, StatementId>> deepest_;  // calls beyond LinuxCNC's depth
  std::map<std::pair<HazardKind, StatementId>, size_t> origins_;
  bool ends_ = false;          // some run comes to a program end without an error
  bool may_go_round_ = false;  // some loop may not be left: then no stop is that of every run
};

}  // namespace owlint::flow
