#include "analyzer/flow/summaries/liveness.h"

#include <algorithm>

namespace owlint::flow {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

}  // namespace

Liveness::Liveness(const ControlFlow& flow, const Accesses& accesses, bool keeps_numbers, const Limits& limits)
    : flow_(flow), accesses_(accesses) {
  if (!flow.known()) return;
  for (const ParameterKey key : accesses.all_reads()) {
    if (!is_global(key)) keys_.push_back(key);
  }
  std::ranges::sort(keys_);
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  for (const ParameterKey key : accesses.all_reads()) uses_.push_back(bit(key));
  for (const auto& write : accesses.all_writes()) kills_.push_back(bit(write.key));
  words_ = keys_.size() / 64 + 1;
  if (flow.nodes().size() * words_ > limits.liveness_words) return;
  live_.assign(flow.nodes().size() * words_, 0);
  numbers_.assign(words_, 0);
  for (uint32_t at = 0; at < keys_.size(); ++at) {
    if (is_own_number(keys_[at])) numbers_[at / 64] |= 1ULL << (at % 64);
  }
  exit_.assign(words_, 0);
  if (keeps_numbers) exit_ = numbers_;
  for (int i = 0; i < limits.liveness_sweeps && !known_; ++i) known_ = !sweep();
}

/// kNone for globals, and for what is never read.
uint32_t Liveness::bit(ParameterKey key) const {
  const auto found = std::ranges::lower_bound(keys_, key);
  return found != keys_.end() && *found == key ? static_cast<uint32_t>(found - keys_.begin()) : kNone;
}

/// Goes over all lines once, the last first; returns whether something new was found.
bool Liveness::sweep() {
  bool grew = false;
  std::vector<uint64_t> live(words_);
  const auto& nodes = flow_.nodes();
  for (NodeId id = static_cast<NodeId>(nodes.size()); id-- > 0;) {
    std::ranges::fill(live, 0);
    for (const NodeId next : nodes[id].next) {
      if (next == kNowhere) continue;
      const uint64_t* from = next == kExit ? exit_.data() : &live_[next * words_];
      for (size_t w = 0; w < words_; ++w) live[w] |= from[w];
    }
    for (uint32_t i = accesses_.first_write(id); i < accesses_.first_write(id + 1); ++i) {
      if (const uint32_t bit = kills_[i]; bit != kNone) live[bit / 64] &= ~(1ULL << (bit % 64));
    }
    for (uint32_t i = accesses_.first_read(id); i < accesses_.first_read(id + 1); ++i) {
      if (const uint32_t bit = uses_[i]; bit != kNone) live[bit / 64] |= 1ULL << (bit % 64);
    }
    for (size_t w = 0; w < words_; ++w) {
      if (accesses_.reads_any(id)) live[w] |= numbers_[w];
      uint64_t& known = live_[id * words_ + w];
      grew |= (live[w] & ~known) != 0;
      known |= live[w];
    }
  }
  return grew;
}

bool Liveness::before(NodeId node, ParameterKey key) const {
  const uint32_t at = bit(key);
  if (at == kNone) return false;
  const uint64_t word = node == kExit ? exit_[at / 64] : live_[node * words_ + at / 64];
  return (word >> (at % 64) & 1) != 0;
}

bool Liveness::after(NodeId node, ParameterKey key) const {
  return std::ranges::any_of(flow_.nodes()[node].next,
                             [&](NodeId next) { return next != kNowhere && before(next, key); });
}

}  // namespace owlint::flow
