#include "analyzer/flow/engine/worklist.h"

#include <utility>

namespace owlint::flow {

void Worklist::add(State state) {
  uint32_t slot = 0;
  const StatementId position = state.position;
  if (free_.empty()) {
    slot = static_cast<uint32_t>(slots_.size());
    slots_.push_back(std::move(state));
  } else {
    slot = free_.back();
    free_.pop_back();
    slots_[slot] = std::move(state);
  }
  queue_.push({position, order_++, slot});
}

State Worklist::take() {
  const uint32_t slot = queue_.top().slot;
  queue_.pop();
  free_.push_back(slot);
  return std::move(slots_[slot]);
}

}  // namespace owlint::flow
