// What rules ask of the finished flow: whether runs get to a line. It remembers questions and answers: an editor keeps the
// calls that nobody asked about, and only so much work is done for all questions. For one thread.
#pragma once

#include <map>
#include <memory>

#include "analyzer/flow/engine/trace.h"
#include "analyzer/flow/limits.h"

namespace owlint::flow {

class Reachability {
 public:
  /// `trace`: finished.
  Reachability(std::shared_ptr<const Trace> trace, const Limits& limits)
      : trace_(std::move(trace)), reach_records_(limits.reach_records) {}

  /// Whether runs get to a statement and execute it: never, on some runs, on every run.
  Reach reach(StatementId statement);
  /// Whether reach() was asked about a statement from `first` to before `last`.
  bool asked(StatementId first, StatementId last) const;
  /// Whether an answer needed lines that were not analysed.
  bool missed() const { return missed_ || trace_->missed(); }

 private:
  std::shared_ptr<const Trace> trace_;
  size_t reach_records_;  // see Limits
  std::map<StatementId, Reach> answers_;
  size_t work_ = 0;  // records that were looked at
  bool missed_ = false;
};

}  // namespace owlint::flow
