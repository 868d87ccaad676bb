#include "analyzer/flow/domain/repeat_counts.h"

#include <algorithm>

#include "analyzer/flow/domain/persistent_map.h"

namespace owlint::flow {
namespace {

using Entry = std::pair<FullLabel, PassCount>;

}  // namespace

int RepeatCounts::of(FullLabel label) const {
  const auto found = std::ranges::find(counts_, label, &Entry::first);
  return found == counts_.end() ? kNotRunning : found->second;
}

void RepeatCounts::set(FullLabel label, int count) {
  const auto found = std::ranges::lower_bound(counts_, label, {}, &Entry::first);
  const bool present = found != counts_.end() && found->first == label;
  if (count == kNotRunning) {
    if (present) counts_.erase(found);
  } else if (present) {
    found->second = static_cast<PassCount>(count);
  } else {
    counts_.insert(found, {label, static_cast<PassCount>(count)});
  }
}

uint64_t RepeatCounts::hash(uint64_t seed) const {
  for (const auto& [label, count] : counts_) seed = mix(seed, static_cast<uint64_t>(label) << 8 | count);
  return seed;
}

RepeatCounts join(const RepeatCounts& a, const RepeatCounts& b) {
  if (a == b) return a;
  RepeatCounts out;
  auto left = a.counts_.begin();
  auto right = b.counts_.begin();
  while (left != a.counts_.end() || right != b.counts_.end()) {
    if (right == b.counts_.end() || (left != a.counts_.end() && left->first < right->first)) {
      out.counts_.emplace_back((left++)->first, kAnyCount);
    } else if (left == a.counts_.end() || right->first < left->first) {
      out.counts_.emplace_back((right++)->first, kAnyCount);
    } else {
      PassCount count = left->second;
      if (left->second != right->second)
        count = left->second == kAnyCount || right->second == kAnyCount ? kAnyCount : kManyLeft;
      out.counts_.emplace_back(left->first, count);
      ++left;
      ++right;
    }
  }
  return out;
}

}  // namespace owlint::flow
