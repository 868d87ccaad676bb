// Calls whose outcome an earlier analysis has found, and those of this one whose outcome may be kept for the next: memoisation
// of calls, for editors. Only calls that begin like none before in this analysis are looked up.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "analyzer/flow/engine/call_keys.h"
#include "analyzer/flow/engine/known_calls.h"
#include "analyzer/flow/engine/partitions.h"
#include "analyzer/flow/engine/trace.h"

namespace owlint::flow {

class Calls;

class CallMemo {
 public:
  /// All must outlive it.
  CallMemo(KnownCalls& known, const Linked& linked, const AbstractMachine& machine, const Precision& precision)
      : known_(known), keys_(linked, machine), program_(linked.program()), precision_(precision) {}

  /// The outcome of a call; null if it is not known. Then the call is recorded, if it is one that can be kept.
  const CallOutcome* find(ContextId context, const Context& callee, const State& entry);
  /// A state in a call is executed.
  void count_step(ContextId context);
  /// Something in a call is reported, so its outcome cannot be kept.
  void disturb(ContextId context);

  /// Of the finished analysis: the recorded calls whose outcome can be kept. They have one exit, and nothing on the way that
  /// is reported at the sub's lines. `stuck`: records in loops that a run may not leave.
  std::vector<LearnedCall> learned(const Calls& calls, const Partitions& partitions, Trace& trace,
                                   const std::vector<bool>& stuck);

 private:
  struct Recorded {
    std::string key;
    State entry;
    size_t level;
    uint64_t steps = 0;
    bool disturbed = false;
    std::vector<bool> lines;
  };
  Recorded* recorded(ContextId context) { return context < recorded_.size() ? recorded_[context].get() : nullptr; }

  KnownCalls& known_;
  CallKeys keys_;
  const Program& program_;
  const Precision& precision_;
  std::vector<std::unique_ptr<Recorded>> recorded_;  // by context
};

}  // namespace owlint::flow
