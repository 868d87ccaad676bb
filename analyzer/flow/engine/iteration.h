// The fixpoint iteration: runs the machine over all branch outcomes until nothing new appears. It owns the parts of the analysis
// and hands what happens on the way to those who make the results of it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/flow/engine/calls.h"
#include "analyzer/flow/engine/partitions.h"
#include "analyzer/flow/engine/precision.h"
#include "analyzer/flow/engine/trace.h"
#include "analyzer/flow/engine/worklist.h"

namespace owlint::flow {

/// With what machines a program begins. kAlsoNew: those of kAny, and by itself one that was just started, where it makes a
/// difference; what only that one does is not proven.
enum class Machines : uint8_t { kAny, kAlsoNew };

/// What happens in runs, as the iteration comes across it.
class Events {
 public:
  virtual ~Events() = default;
  /// The interpreter stops at a line.
  virtual void stop(const State& at, StopReport report) = 0;
  /// Something runs, but not as written.
  virtual void hazard(const State& at, HazardReport report) = 0;
  /// The program ends without an error.
  virtual void end(const State& at) = 0;
  /// A file ends, and the program does not.
  virtual void end_of_file(const State& at) = 0;

  // For those who watch the fixpoint.
  /// A state is executed; its `record` is its own.
  virtual void executed(const State&) {}
  /// A state is joined with others of its partition and not kept apart.
  virtual void joined(const State&, const Partition&) {}
};

class Iteration final : private Listener {
 public:
  /// All must outlive it; `known` may be null. `modes`: those that are followed even if they decide nothing.
  Iteration(const Linked& linked, const Profile& profile, Detail detail, KnownCalls* known, const Limits& limits,
            ModeMask modes = 0);
  Iteration(const Iteration&) = delete;
  Iteration& operator=(const Iteration&) = delete;
  ~Iteration() override = default;

  /// Once. Afterwards the fixpoint is in the parts below.
  void run(Events& events, Machines machines = Machines::kAny);

  const Linked& linked() const { return linked_; }
  const Program& program() const { return program_; }
  const Profile& profile() const { return profile_; }
  const Limits& limits() const { return limits_; }
  const Precision& precision() const { return precision_; }
  const Partitions& partitions() const { return partitions_; }
  const Calls& calls() const { return calls_; }
  AbstractMachine& machine() { return machine_; }
  const AbstractMachine& machine() const { return machine_; }
  const std::shared_ptr<Trace>& trace() const { return trace_; }
  /// The numbers that are 0 on a machine that was just started, if the program begins with one by itself.
  const std::vector<uint32_t>& unset() const { return unset_; }
  /// Of the finished analysis, see CallMemo; none where calls are not kept.
  std::shared_ptr<std::vector<LearnedCall>> learned_calls(const std::vector<bool>& stuck);
  /// Names of called subs that were computed on the way, sorted.
  std::vector<std::string> computed_calls() const;
  FlowStatistics statistics() const;

 private:
  void successor(State state) override;
  void stop(const State& at, StopReport report) override;
  void hazard(const State& at, HazardReport report) override;
  void end(const State& at) override { events_->end(at); }
  void call(const State& at, State entry, Context callee, int repeats) override;
  void leave(const State& at) override;

  void start(Machines machines);
  void start_new_machine(State state);
  void arrive(State state);
  void execute(State state, Partition& partition, uint64_t hash);
  void execute_joined(Partition& partition);
  void follow_precision();
  void mark_executed(const CalmStretch& stretch);

  const Linked& linked_;
  const Program& program_;
  const Profile& profile_;
  const Limits& limits_;
  bool passes_over_;     ///< stretches of harmless lines are one step, where it is coarse
  bool coarse_ = false;  ///< the machine is
  PersistentMap::Pool pool_;
  AbstractMachine machine_;
  Precision precision_;
  std::pmr::monotonic_buffer_resource memory_;
  std::shared_ptr<Trace> trace_;
  Separation separation_;
  Worklist worklist_;
  Partitions partitions_;
  std::optional<CallMemo> memo_;
  Calls calls_;
  std::vector<bool> marked_;  ///< by opener: the sub is called from a stretch, and its lines are marked as executed
  std::vector<uint32_t> unset_;
  Events* events_ = nullptr;
};

}  // namespace owlint::flow
