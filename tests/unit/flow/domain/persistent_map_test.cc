// The flow room's map against std::map, with random operations.
#include <map>
#include <random>

#include <catch2/catch.hpp>

#include "analyzer/flow/domain/persistent_map.h"

using owlint::flow::PersistentMap;

namespace persistent_map_test {
namespace {

struct Pair {
  PersistentMap map;
  std::map<uint32_t, uint32_t> model;

  void set(PersistentMap::Pool& pool, uint32_t key, uint32_t value) {
    map.set(pool, key, value);
    if (value == 0) {
      model.erase(key);
    } else {
      model[key] = value;
    }
  }

  void check() const {
    for (const auto& [key, value] : model) REQUIRE(map.get(key) == value);
  }
};

/// Mostly small keys, so that maps have keys in common; some as large as they get.
uint32_t random_key(std::mt19937& random) {
  const uint32_t limits[] = {8, 40, 5000, UINT32_MAX};
  return std::uniform_int_distribution<uint32_t>(0, limits[random() % 4])(random);
}

uint32_t join(uint32_t key, uint32_t a, uint32_t b) { return key % 3 == 0 ? 0 : a > b ? a : b; }

}  // namespace

TEST_CASE("a persistent map does what a map does", "[map]") {
  std::mt19937 random(20240607);
  for (int round = 0; round < 200; ++round) {
    PersistentMap::Pool pool;
    std::vector<Pair> maps(1);
    for (int step = 0; step < 120; ++step) {
      const size_t at = random() % maps.size();
      switch (random() % 8) {
        case 0:
          maps.push_back(maps[at]);  // a copy, to go its own way
          break;
        case 1: {
          const size_t other = random() % maps.size();
          Pair merged;
          merged.map = PersistentMap::merge(pool, maps[at].map, maps[other].map, join);
          for (const auto& [key, value] : maps[at].model) {
            const auto found = maps[other].model.find(key);
            const uint32_t right = found == maps[other].model.end() ? 0 : found->second;
            const uint32_t result = value == right ? value : join(key, value, right);
            if (result != 0) merged.model[key] = result;
          }
          for (const auto& [key, value] : maps[other].model) {
            if (!maps[at].model.contains(key) && join(key, 0, value) != 0) merged.model[key] = join(key, 0, value);
          }
          maps.push_back(merged);
          break;
        }
        default: maps[at].set(pool, random_key(random), random() % 4);
      }
      const uint32_t probe = random_key(random);
      const auto found = maps[at].model.find(probe);
      REQUIRE(maps[at].map.get(probe) == (found == maps[at].model.end() ? 0 : found->second));
    }
    for (const Pair& pair : maps) {
      pair.check();
      // The same content, written in another order, hashes alike; copies were not touched by later writes.
      Pair again;
      for (auto entry = pair.model.rbegin(); entry != pair.model.rend(); ++entry)
        again.set(pool, entry->first, entry->second);
      REQUIRE(again.map.hash() == pair.map.hash());
    }
    for (size_t i = 0; i + 1 < maps.size(); ++i) {
      REQUIRE((maps[i].map.hash() == maps[i + 1].map.hash()) == (maps[i].model == maps[i + 1].model));
    }
  }
}

TEST_CASE("merging with an equal map asks nothing", "[map]") {
  PersistentMap::Pool pool;
  PersistentMap a;
  a.set(pool, 3, 7);
  a.set(pool, 70000, 1);
  PersistentMap b;
  b.set(pool, 70000, 1);
  b.set(pool, 3, 7);
  const auto merged = PersistentMap::merge(pool, a, b, [](uint32_t, uint32_t, uint32_t) -> uint32_t {
    FAIL("asked");
    return 0;
  });
  CHECK(merged.get(3) == 7);
  CHECK(merged.get(70000) == 1);
  CHECK(merged.get(4) == 0);
}

}  // namespace persistent_map_test
