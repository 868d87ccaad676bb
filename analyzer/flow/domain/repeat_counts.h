// The domain of the passes that running `repeat` loops have left.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "analyzer/flow/domain/definers.h"

namespace owlint::flow {

/// Passes that are left. Numbers below kManyLeft are exact; Limits::counted_passes is the largest that is kept.
using PassCount = uint8_t;
inline constexpr PassCount kManyLeft = 16;  ///< running, the number is not known
inline constexpr PassCount kAnyCount = 17;  ///< running or not

/// By label, for those loops that may be running. The order for each label: an exact number and "not running" are lowest,
/// kManyLeft holds all exact numbers, kAnyCount holds everything. A join is the least count that holds both sides:
/// commutative, associative and idempotent. Chains have at most three members, so they need no widening.
class RepeatCounts {
 public:
  static constexpr int kNotRunning = -1;

  /// kNotRunning, or a PassCount.
  int of(FullLabel label) const;
  /// `count`: kNotRunning or a PassCount.
  void set(FullLabel label, int count);
  uint64_t hash(uint64_t seed) const;
  bool operator==(const RepeatCounts&) const = default;
  const std::vector<std::pair<FullLabel, PassCount>>& all() const { return counts_; }

 private:
  friend RepeatCounts join(const RepeatCounts& a, const RepeatCounts& b);

  std::vector<std::pair<FullLabel, PassCount>> counts_;  // sorted
};

RepeatCounts join(const RepeatCounts& a, const RepeatCounts& b);

}  // namespace owlint::flow
