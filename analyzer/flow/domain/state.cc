#include "analyzer/flow/domain/state.h"

namespace owlint::flow {

uint64_t State::hash() const {
  uint64_t h = mix(position, skip);
  h = mix(h, defining);
  h = mix(h,
          static_cast<uint64_t>(flags.hash()) | static_cast<uint64_t>(seek) << 32 |
              static_cast<uint64_t>(looped) << 33 | static_cast<uint64_t>(joined) << 34 |
              static_cast<uint64_t>(mixed) << 35);
  h = mix(h, table.hash());
  h = parameters.hash(h);
  return counts.hash(h);
}

State StateDomain::join(const State& a, const State& b) {
  State out = a;
  out.looped = a.looped && b.looped;  // alike, as all of where the run is
  out.joined = true;
  out.mixed = a.mixed && b.mixed;
  out.flags = flow::join(a.flags, b.flags);
  out.table = definers_.join(pool_, a.table, b.table);
  out.counts = flow::join(a.counts, b.counts);
  out.parameters = flow::join(a.parameters, b.parameters, values_, pool_);
  return out;
}

}  // namespace owlint::flow
