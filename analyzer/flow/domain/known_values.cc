// Constants and ranges by number, and what is known where two paths meet.
#include <algorithm>
#include <bit>
#include <cmath>

#include "analyzer/flow/domain/known_values.h"
#include "analyzer/flow/domain/persistent_map.h"

namespace owlint::flow {

namespace {

/// Of the numbers that mostly tell places apart.
uint64_t hash(const Place& place) {
  uint64_t sum = place.keeps_height ? 1 : 0;
  const auto add = [&sum](Coordinate number) {
    for (const double of : {number.value, number.other})
      sum = mix(sum, std::isnan(of) ? 1 : std::bit_cast<uint64_t>(of));
  };
  for (const Coordinate& axis : place.at.axes) add(axis);
  for (const Coordinate& number : {place.clearance, place.bottom, place.height, place.tool[Axis::kZ]}) add(number);
  return sum;
}

}  // namespace

ValueId KnownValues::intern(double value) {
  constexpr size_t kFew = 16;  // as many as most programs have: to look through them is faster than to hash
  const uint64_t bits = std::bit_cast<uint64_t>(value);
  const auto next = [this] { return static_cast<ValueId>(constants_.size()) + kFirstConstant; };
  for (size_t i = 0; i < std::min(constants_.size(), kFew); ++i) {
    if (std::bit_cast<uint64_t>(constants_[i]) == bits) return static_cast<ValueId>(i) + kFirstConstant;
  }
  if (constants_.size() >= kFew) {
    const auto [entry, added] = ids_.try_emplace(bits, next());
    if (!added) return entry->second;
  }
  constants_.push_back(value);
  return next() - 1;
}

ValueId KnownValues::intern(const Range& range) {
  if (range.is_empty()) return kUnknown;
  if (range.is_one()) return intern(range.low);
  const Range wide = thresholds_.widened(range);
  if (wide.is_all()) return kUnknown;
  std::vector<ValueId>& alike = range_ids_[mix(std::bit_cast<uint64_t>(wide.low), std::bit_cast<uint64_t>(wide.high))];
  for (const ValueId id : alike) {
    if (ranges_[id - kFirstRange] == wide) return id;
  }
  alike.push_back(kFirstRange + static_cast<ValueId>(ranges_.size()));
  ranges_.push_back(wide);
  return alike.back();
}

ValueId KnownValues::intern(const KnownSet& set) {
  const auto [entry, added] =
      set_ids_[set.open ? 1 : 0].try_emplace(set.members, kFirstSet + static_cast<ValueId>(sets_.size()));
  if (added) sets_.push_back(set);
  return entry->second;
}

ValueId KnownValues::intern(const Place& place) {
  std::vector<ValueId>& alike = place_ids_[hash(place)];
  for (const ValueId id : alike) {
    if (this->place(id) == place) return id;
  }
  alike.push_back(kFirstPlace + static_cast<ValueId>(places_.size()));
  places_.push_back(place);
  return alike.back();
}

Range KnownValues::range(ValueId id) const {
  if (id >= kFirstSet) return {};
  if (id >= kFirstRange) return ranges_[id - kFirstRange];
  return is_constant(id) ? Range::of(value(id)) : Range();
}

ValueId KnownValues::join_places(ValueId a, ValueId b) {
  const uint64_t both = static_cast<uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
  const auto [known, added] = joined_places_.try_emplace(both, kUnknown);
  if (added) known->second = intern(owlint::join(place(a), place(b)));
  return known->second;
}

ValueId KnownValues::join(ValueId a, ValueId b) {
  if (a == b) return a;
  const auto not_returned = [](ValueId v) { return v >= kNotReturned && v <= kMaybeNotReturned; };
  if (not_returned(a) || not_returned(b)) return kMaybeNotReturned;
  const auto assigned = [](ValueId v) { return v != kUnassigned && v != kMaybeUnassigned; };
  if (!assigned(a) || !assigned(b)) return kMaybeUnassigned;
  if (is_set(a) && is_set(b)) return intern(KnownSet{set(a).members | set(b).members, set(a).open || set(b).open});
  if (is_place(a) && is_place(b)) return join_places(a, b);
  if (a >= kFirstSet || b >= kFirstSet) return kUnknown;
  return a >= kFirstConstant && b >= kFirstConstant ? intern(hull(range(a), range(b))) : kUnknown;
}

}  // namespace owlint::flow
