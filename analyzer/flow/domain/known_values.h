// The domain of values: whether something was assigned, and what: a constant, a range, a set (of a mode's values), or a place
// (where the machine stands). Constants come from literals and arithmetic on them, ranges from conditions and from joined
// constants. All else that parameters hold is unknown, so that both outcomes of a condition are followed.
#pragma once

#include <cstdint>
#include <deque>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analyzer/flow/domain/ranges.h"
#include "analyzer/syntax/place.h"

namespace owlint::flow {

// The lattice, from its top; what is indented is below. A join goes up to the first value that is above both. There is no
// bottom, since a state that no run reaches does not exist.
//
//   kMaybeNotReturned
//     kNotReturned, kCleared
//     kMaybeUnassigned
//       kUnassigned
//       kUnknown
//         kNotPassed
//         ranges, the wider ones above
//           constants
//         sets of modes, the larger ones above
//         places, those of which less is known above

/// A value in a state's parameter maps. Constants are numbered from kFirstConstant, ranges from kFirstRange, sets from
/// kFirstSet, places from kFirstPlace.
using ValueId = uint32_t;
inline constexpr ValueId kUnassigned = 0;        ///< not assigned on any path so far
inline constexpr ValueId kUnknown = 1;           ///< assigned, value not known
inline constexpr ValueId kMaybeUnassigned = 2;   ///< assigned on some paths
inline constexpr ValueId kNotPassed = 3;         ///< #n of a sub whose call passes fewer arguments: it is 0
inline constexpr ValueId kNotReturned = 4;       ///< `#<_value>` after a call that returned nothing: it is 0
inline constexpr ValueId kCleared = 5;           ///< the same if an earlier call had returned something
inline constexpr ValueId kMaybeNotReturned = 6;  ///< one of these on some paths
inline constexpr ValueId kFirstConstant = 7;
inline constexpr ValueId kFirstRange = 1U << 31;
inline constexpr ValueId kFirstSet = 3U << 30;
inline constexpr ValueId kFirstPlace = 7U << 29;

/// Some numbers from 0 to 63, for the modes of the machine.
struct KnownSet {
  uint64_t members = 0;  ///< one bit each
  bool open = false;     ///< it is not known of each that some run has it
  bool operator==(const KnownSet&) const = default;
};

/// Constants, ranges, sets and places by number.
class KnownValues {
 public:
  ValueId intern(double value);
  /// A range is widened to the thresholds first; one that contains all numbers is kUnknown.
  ValueId intern(const Range& range);
  ValueId intern(const KnownSet& set);
  ValueId intern(const Place& place);
  static bool is_set(ValueId id) { return id >= kFirstSet && id < kFirstPlace; }
  static bool is_place(ValueId id) { return id >= kFirstPlace; }
  const KnownSet& set(ValueId id) const { return sets_[id - kFirstSet]; }
  const Place& place(ValueId id) const { return places_[id - kFirstPlace]; }
  static bool is_constant(ValueId id) { return id >= kFirstConstant && id < kFirstRange; }
  double value(ValueId id) const { return constants_[id - kFirstConstant]; }
  Range range(ValueId id) const;
  /// What is known after two paths are joined: the least value that holds both. Two constants or ranges make the range over
  /// both, widened to the thresholds, two sets the set of what is in one of them, and two places what is known in both.
  /// Commutative, associative and idempotent; as there are few thresholds, a value that is joined with more and more others comes
  /// to rest.
  ValueId join(ValueId a, ValueId b);
  void set_thresholds(Thresholds thresholds) { thresholds_ = std::move(thresholds); }
  const Thresholds& thresholds() const { return thresholds_; }

 private:
  ValueId join_places(ValueId a, ValueId b);

  std::vector<double> constants_;
  std::unordered_map<uint64_t, ValueId> ids_;  ///< of all but the first few
  std::vector<Range> ranges_;
  std::unordered_map<uint64_t, std::vector<ValueId>> range_ids_;
  std::vector<KnownSet> sets_;
  std::unordered_map<uint64_t, ValueId> set_ids_[2];  ///< by whether they are open
  std::deque<Place> places_;
  std::unordered_map<uint64_t, std::vector<ValueId>> place_ids_;
  std::unordered_map<uint64_t, ValueId>
      joined_places_;  ///< by two of them: in loops and calls the same ones meet again
  Thresholds thresholds_;
};

}  // namespace owlint::flow
