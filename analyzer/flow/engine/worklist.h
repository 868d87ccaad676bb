// The states that wait to be executed. The foremost line comes first, so that all states that meet there are joined before
// the lines after it are executed.
#pragma once

#include <queue>
#include <vector>

#include "analyzer/flow/domain/state.h"

namespace owlint::flow {

class Worklist {
 public:
  void add(State state);
  bool empty() const { return queue_.empty(); }
  /// The line of the state that is next; there must be one.
  StatementId position() const { return queue_.top().position; }
  /// The next one; of those at one line the first that was added.
  State take();

 private:
  struct Entry {
    StatementId position;
    uint64_t order;
    uint32_t slot;
    bool operator<(const Entry& other) const {
      return position != other.position ? position > other.position : order > other.order;
    }
  };
  std::priority_queue<Entry> queue_;
  std::vector<State> slots_;
  std::vector<uint32_t> free_;
  uint64_t order_ = 0;
};

}  // namespace owlint::flow
