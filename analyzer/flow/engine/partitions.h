// The states that were seen at each line. Those in one situation (same call, same skip, and while lines are skipped the same flag
// `executed`) are a partition: its states are kept apart while they are few, and joined into one when they are many. So the cost
// grows with the program, never with the number of its paths.
#pragma once

#include <deque>
#include <memory>
#include <memory_resource>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analyzer/flow/engine/separation.h"

namespace owlint::flow {

struct Partition {
  StatementId position;
  uint32_t number;
  uint32_t rank;  ///< how many partitions at this line were there before
  ContextId context;
  FullLabel skip;
  NameId defining;
  bool seek;
  bool looped;
  uint8_t executed;  ///< while lines are skipped: the branch that was taken has assigned what the others have not
  uint32_t next;     ///< the partition at this line that was there before
  std::pmr::vector<std::pair<uint64_t, RecordId>> seen;   ///< the states that were executed, by hash
  std::unique_ptr<State> joined;                          ///< the join of those that were not kept apart
  std::pmr::vector<std::pair<RecordId, Branch>> parents;  ///< records whose states wait in `joined`, and their branches
  bool waits;                                             ///< `joined` has grown and is to be executed

  /// The record of an equal state; kNoRecord if there was none.
  RecordId find(uint64_t hash) const;
};

class Partitions {
 public:
  /// `machine`, `separation` and `memory` must outlive it. There are many small partitions; they are freed with `memory`.
  Partitions(const Program& program, AbstractMachine& machine, Separation& separation, const Precision& precision,
             std::pmr::memory_resource& memory)
      : machine_(machine),
        separation_(separation),
        precision_(precision),
        memory_(memory),
        heads_(program.size() + 1, kNone) {}

  /// The partition of a state; a new one if there was none.
  Partition& at(const State& state);
  /// Whether one more state is not kept apart in its partition.
  bool joins(const State& state, const Partition& partition) {
    return separation_.joins(state, state.position, partition.seen.size(), precision_.now().states);
  }
  /// Joins a state with those of its partition that are not kept apart.
  void join(State state, Partition& partition);
  /// The partitions in which something was joined since the last time, by number.
  std::vector<uint32_t> take_joined() { return std::exchange(joined_, {}); }

  Partition& operator[](uint32_t number) { return all_[number]; }
  const std::deque<Partition>& all() const { return all_; }
  /// States that were joined with loss of precision.
  uint64_t joined_states() const { return joined_states_; }

 private:
  static constexpr uint32_t kNone = UINT32_MAX;

  AbstractMachine& machine_;
  Separation& separation_;
  const Precision& precision_;
  std::pmr::memory_resource& memory_;
  std::vector<uint32_t> heads_;                               // by position: the partition that came last
  std::deque<Partition> all_;                                 // a deque: growing moves nothing
  std::unordered_multimap<uint64_t, uint32_t> by_situation_;  // at lines that have many
  std::vector<uint32_t> joined_;
  uint64_t joined_states_ = 0;
};

}  // namespace owlint::flow
