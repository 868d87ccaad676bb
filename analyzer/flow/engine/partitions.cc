#include "analyzer/flow/engine/partitions.h"

#include <algorithm>

namespace owlint::flow {

RecordId Partition::find(uint64_t hash) const {
  const auto found = std::ranges::find(seen, hash, &std::pair<uint64_t, RecordId>::first);
  return found == seen.end() ? kNoRecord : found->second;
}

Partition& Partitions::at(const State& state) {
  constexpr uint32_t kFew = 8;  // more at one line are not gone through one by one
  const uint8_t executed = state.skip == kNoLabel ? uint8_t{0} : state.flags.executed;
  const auto hash = [](ContextId context, FullLabel skip, NameId defining, uint8_t taken, bool seek, bool looped,
                       StatementId position) {
    return mix(mix(mix(mix(position, context), skip), defining),
               static_cast<uint64_t>(taken) << 2 | static_cast<uint64_t>(seek) << 1 | static_cast<uint64_t>(looped));
  };
  const auto hash_of = [&](const Partition& p) {
    return hash(p.context, p.skip, p.defining, p.executed, p.seek, p.looped, p.position);
  };
  const auto fits = [&](const Partition& p) {
    return p.position == state.position && p.context == state.context && p.skip == state.skip &&
        p.defining == state.defining && p.seek == state.seek && p.looped == state.looped && p.executed == executed;
  };
  uint32_t& head = heads_[state.position];
  const uint32_t rank = head == kNone ? 0 : all_[head].rank + 1;
  if (rank <= kFew) {
    for (uint32_t i = head; i != kNone; i = all_[i].next) {
      if (fits(all_[i])) return all_[i];
    }
  } else {
    const auto [first, last] = by_situation_.equal_range(
        hash(state.context, state.skip, state.defining, executed, state.seek, state.looped, state.position));
    for (auto found = first; found != last; ++found) {
      if (fits(all_[found->second])) return all_[found->second];
    }
  }
  const auto number = static_cast<uint32_t>(all_.size());
  all_.push_back({state.position, number, rank, state.context, state.skip, state.defining, state.seek, state.looped,
                  executed, head, std::pmr::vector<std::pair<uint64_t, RecordId>>(&memory_), nullptr,
                  std::pmr::vector<std::pair<RecordId, Branch>>(&memory_), false});
  head = number;
  if (rank == kFew) {
    for (uint32_t i = head; i != kNone; i = all_[i].next) by_situation_.emplace(hash_of(all_[i]), i);
  } else if (rank > kFew) {
    by_situation_.emplace(hash_of(all_[number]), number);
  }
  return all_.back();
}

void Partitions::join(State state, Partition& partition) {
  ++joined_states_;
  if (state.record != kNoRecord) partition.parents.emplace_back(state.record, state.branch);
  if (partition.joined == nullptr) {
    partition.joined = std::make_unique<State>(std::move(state));
  } else {
    State joined = machine_.states().join(*partition.joined, state);
    joined.record = state.record;
    joined.branch = state.branch;
    *partition.joined = std::move(joined);
  }
  if (!partition.waits) joined_.push_back(partition.number);
  partition.waits = true;
}

}  // namespace owlint::flow
