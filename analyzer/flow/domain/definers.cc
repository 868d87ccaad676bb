#include "analyzer/flow/domain/definers.h"

namespace owlint::flow {
namespace {

constexpr uint32_t kSetMark = 0x80000000U;

}  // namespace

Definers::Set Definers::get(uint32_t packed) const {
  if (packed == 0) return {{}, true};
  if (packed == kElsewhere) return {{}, false};
  if ((packed & kSetMark) != 0) return sets_[packed & ~kSetMark];
  Set set{{}, (packed & 1) != 0};
  set.lines.push_back((packed >> 1) - 1);
  return set;
}

uint32_t Definers::pack(Set set) {
  if (set.lines.empty()) return 0;
  if (set.lines.size() == 1) return one(*set.lines.begin()) | (set.undefined ? 1 : 0);
  uint64_t hash = set.undefined ? 1 : 0;
  for (const StatementId line : set.lines) hash = mix(hash, line);
  for (;; ++hash) {  // a set with the same hash by accident takes the next one
    const auto [entry, added] = ids_.try_emplace(hash, static_cast<uint32_t>(sets_.size()) | kSetMark);
    if (added) {
      sets_.push_back(set);
      return entry->second;
    }
    const Set& known = sets_[entry->second & ~kSetMark];
    if (known.undefined == set.undefined && std::ranges::equal(known.lines, set.lines)) return entry->second;
  }
}

uint32_t Definers::join(uint32_t a, uint32_t b) {
  if (a == b) return a;
  const Set left = get(a);
  const Set right = get(b);
  Set out;
  out.undefined = left.undefined || right.undefined;
  std::ranges::set_union(left.lines, right.lines, std::back_inserter(out.lines));
  out.lines.shorten();
  return pack(out);
}

PersistentMap Definers::join(PersistentMap::Pool& pool, const PersistentMap& a, const PersistentMap& b) {
  return PersistentMap::merge(pool, a, b, [this](uint32_t, uint32_t x, uint32_t y) { return join(x, y); });
}

uint32_t Definers::without_undefined(uint32_t packed) {
  Set set = get(packed);
  set.undefined = false;
  return pack(set);
}

}  // namespace owlint::flow
