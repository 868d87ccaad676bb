// Constants and ranges by number, and what is known where two paths meet.
#include <algorithm>
#include <bit>

#include "analyzer/flow/domain/known_values.h"
#include "analyzer/flow/domain/persistent_map.h"

namespace owlint::flow {

ValueId KnownValues::intern(double value) {
  constexpr size_t kFew = 16;  // as many as most programs have: to look through them is faster than to hash
  if (value == 0) value = 0;   // -0 is 0
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

Range KnownValues::range(ValueId id) const {
  if (is_set(id)) return {};
  if (id >= kFirstRange) return ranges_[id - kFirstRange];
  return is_constant(id) ? Range::of(value(id)) : Range();
}

ValueId KnownValues::join(ValueId a, ValueId b) {
  if (a == b) return a;
  const auto not_returned = [](ValueId v) { return v >= kNotReturned && v <= kMaybeNotReturned; };
  if (not_returned(a) || not_returned(b)) return kMaybeNotReturned;
  const auto assigned = [](ValueId v) { return v != kUnassigned && v != kMaybeUnassigned; };
  if (!assigned(a) || !assigned(b)) return kMaybeUnassigned;
  if (is_set(a) && is_set(b)) return intern(KnownSet{set(a).members | set(b).members, set(a).open || set(b).open});
  if (is_set(a) || is_set(b)) return kUnknown;
  return a >= kFirstConstant && b >= kFirstConstant ? intern(hull(range(a), range(b))) : kUnknown;
}

}  // namespace owlint::flow
