#include "analyzer/flow/domain/known_parameters.h"

namespace owlint::flow {

uint64_t Parameters::hash(uint64_t seed) const {
  for (const PersistentMap* map : {&locals, &globals, &local_outcomes, &global_outcomes}) seed = mix(seed, map->hash());
  return mix(seed, outside ? 1 : 0);
}

Parameters join(const Parameters& a, const Parameters& b, KnownValues& values, PersistentMap::Pool& pool) {
  const auto joined = [&](uint32_t, uint32_t x, uint32_t y) { return values.join(x, y); };
  const auto same = [](uint32_t, uint32_t x, uint32_t y) { return x == y ? x : 0; };
  Parameters out;
  out.locals = PersistentMap::merge(pool, a.locals, b.locals, joined);
  out.globals = PersistentMap::merge(pool, a.globals, b.globals, joined);
  out.local_outcomes = PersistentMap::merge(pool, a.local_outcomes, b.local_outcomes, same);
  out.global_outcomes = PersistentMap::merge(pool, a.global_outcomes, b.global_outcomes, same);
  out.outside = a.outside || b.outside;
  return out;
}

}  // namespace owlint::flow
