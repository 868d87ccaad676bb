// The domains of a state are lattices, and so is their product: where paths meet, it does not matter in which order, and chains
// come to rest.
#include <limits>
#include <random>

#include <catch2/catch.hpp>

#include "analyzer/flow/domain/known_values.h"
#include "analyzer/flow/domain/state.h"

using namespace owlint::flow;

namespace {

/// Values of all kinds, over a domain with these thresholds.
class Values {
 public:
  explicit Values(uint32_t seed) : random_(seed) { known.set_thresholds(Thresholds({-5, 0, 1, 2.5, 10, 100})); }

  ValueId any() {
    const auto kind = random_() % 10;
    if (kind < 2) return static_cast<ValueId>(random_() % kFirstConstant);
    if (kind < 7) return known.intern(number());
    const double a = kind == 7 ? -std::numeric_limits<double>::infinity() : number();
    const double b = kind == 8 ? std::numeric_limits<double>::infinity() : number();
    return known.intern(Range{std::min(a, b), std::max(a, b), false, false});
  }
  double number() {
    static constexpr double kOften[] = {0, 1, 2, 2.5, -5, 10, 50, 100, 1e6, -1e6};
    return kOften[random_() % std::size(kOften)];
  }
  /// Values of a mode.
  ValueId set() { return known.intern(KnownSet{1 + random_() % 31, random_() % 3 == 0}); }
  /// Where the machine stands.
  ValueId place() {
    owlint::Place place = random_() % 5 == 0 ? owlint::Place::unknown() : owlint::Place::started();
    for (const size_t axis : {0, 1, 2}) {
      if (random_() % 2 == 0) place.at[axis] = owlint::Coordinate::of(number());
    }
    if (random_() % 4 == 0) place.lose_point();
    place.keeps_height = random_() % 2 == 0;
    place.height = owlint::Coordinate::of(number());
    place.chosen_tool = static_cast<int32_t>(random_() % 3);
    return known.intern(place);
  }
  /// a ≤ b: b holds whatever a holds.
  bool leq(ValueId a, ValueId b) { return known.join(a, b) == b; }

  KnownValues known;

 private:
  std::mt19937 random_;
};

/// States whose parts are all of a few kinds, so that many of them meet.
class States {
 public:
  explicit States(uint32_t seed) : values(seed), random_(seed) {}

  State any() {
    State out;
    out.joined = random_() % 2 == 0;
    out.mixed = random_() % 4 == 0;
    out.flags = {flag(), flag(), flag(), flag()};
    for (FullLabel label = 1; label <= kLabels; ++label) {
      if (random_() % 2 == 0) out.table.set(pool, label, definers_of_one());
      if (random_() % 3 == 0) out.counts.set(label, static_cast<int>(random_() % (kAnyCount + 1)));
    }
    out.parameters = parameters();
    return out;
  }
  Parameters parameters() {
    Parameters out;
    for (uint32_t key = 1; key <= kKeys; ++key) {
      if (random_() % 2 == 0) out.locals.set(pool, key, values.any());
      if (random_() % 2 == 0) out.globals.set(pool, key + 31, values.any());
      out.local_outcomes.set(pool, key, static_cast<uint32_t>(random_() % 3));
      out.global_outcomes.set(pool, key, static_cast<uint32_t>(random_() % 3));
    }
    out.outside = random_() % 4 == 0;
    return out;
  }

  State join(const State& a, const State& b) { return domain.join(a, b); }
  Parameters join(const Parameters& a, const Parameters& b) { return owlint::flow::join(a, b, values.known, pool); }

  /// Part by part, not by the hash.
  static bool equal(const Parameters& a, const Parameters& b) {
    for (uint32_t key = 0; key <= kKeys + 31; ++key) {
      if (a.locals.get(key) != b.locals.get(key) || a.globals.get(key) != b.globals.get(key) ||
          a.local_outcomes.get(key) != b.local_outcomes.get(key) ||
          a.global_outcomes.get(key) != b.global_outcomes.get(key))
        return false;
    }
    return a.outside == b.outside;
  }
  /// `joined` is no part of what a state holds.
  static bool equal(const State& a, const State& b) {
    for (FullLabel label = 0; label <= kLabels; ++label) {
      if (a.table.get(label) != b.table.get(label)) return false;
    }
    return a.mixed == b.mixed && a.flags == b.flags && a.counts == b.counts && equal(a.parameters, b.parameters);
  }
  /// a ≤ b: b holds whatever a holds.
  template <typename Part>
  bool leq(const Part& a, const Part& b) {
    return equal(join(a, b), b);
  }

  Values values;
  Definers definers;
  PersistentMap::Pool pool;
  StateDomain domain{values.known, definers, pool};

 private:
  static constexpr FullLabel kLabels = 5;
  static constexpr uint32_t kKeys = 8;

  uint8_t flag() { return static_cast<uint8_t>(1 + random_() % 7); }
  uint32_t definers_of_one() {
    uint32_t out =
        random_() % 6 == 0 ? Definers::kElsewhere : Definers::one(static_cast<owlint::StatementId>(random_() % 9));
    for (uint32_t more = random_() % 4; more > 0; --more)
      out = definers.join(out, random_() % 5 == 0 ? 0 : Definers::one(static_cast<owlint::StatementId>(random_() % 9)));
    return out;
  }

  std::mt19937 random_;
};

/// What every join has to be, for two and three parts of a kind.
template <typename Part>
void check_lattice(States& states, const Part& a, const Part& b, const Part& c) {
  REQUIRE(States::equal(states.join(a, a), a));
  REQUIRE(States::equal(states.join(a, b), states.join(b, a)));
  REQUIRE(States::equal(states.join(states.join(a, b), c), states.join(a, states.join(b, c))));
  REQUIRE(states.leq(a, states.join(a, b)));
  REQUIRE(states.leq(b, states.join(a, b)));
  REQUIRE(states.leq(states.join(a, c), states.join(states.join(a, b), c)));  // a ≤ a ∨ b
}

}  // namespace

TEST_CASE("joins are commutative, associative and idempotent", "[lattice]") {
  Values values(20261129);
  KnownValues& known = values.known;
  for (int i = 0; i < 20'000; ++i) {
    const ValueId a = values.any();
    const ValueId b = values.any();
    const ValueId c = values.any();
    INFO("values " << a << ", " << b << ", " << c);
    REQUIRE(known.join(a, a) == a);
    REQUIRE(known.join(a, b) == known.join(b, a));
    REQUIRE(known.join(known.join(a, b), c) == known.join(a, known.join(b, c)));
  }
}

TEST_CASE("a join holds both of its sides, and keeps their order", "[lattice]") {
  Values values(7);
  KnownValues& known = values.known;
  for (int i = 0; i < 20'000; ++i) {
    const ValueId a = values.any();
    const ValueId b = values.any();
    const ValueId c = values.any();
    INFO("values " << a << ", " << b << ", " << c);
    const ValueId joined = known.join(a, b);
    REQUIRE(values.leq(a, joined));
    REQUIRE(values.leq(b, joined));
    if (values.leq(a, b)) REQUIRE(values.leq(known.join(a, c), known.join(b, c)));
    if (!KnownValues::is_constant(a) || !KnownValues::is_constant(b)) continue;
    const Range range = known.range(joined);
    REQUIRE(range.has(known.value(a)));
    REQUIRE(range.has(known.value(b)));
  }
}

TEST_CASE("the values of a mode and the places of the machine are lattices", "[lattice]") {
  Values values(13);
  KnownValues& known = values.known;
  for (int i = 0; i < 5'000; ++i) {
    const auto any = [&] { return i % 2 == 0 ? values.set() : values.place(); };
    const ValueId a = any();
    const ValueId b = any();
    const ValueId c = any();
    INFO("values " << a << ", " << b << ", " << c);
    const ValueId joined = known.join(a, b);
    REQUIRE(known.join(a, a) == a);
    REQUIRE(joined == known.join(b, a));
    REQUIRE(known.join(joined, c) == known.join(a, known.join(b, c)));
    REQUIRE(values.leq(a, joined));
    REQUIRE(values.leq(b, joined));
    if (i % 2 != 0) continue;
    REQUIRE((known.set(joined).members & known.set(a).members) == known.set(a).members);
    REQUIRE(known.set(joined).open == (known.set(a).open || known.set(b).open));
  }
}

TEST_CASE("a value that grows in each pass of a loop comes to rest", "[lattice]") {
  Values values(3);
  KnownValues& known = values.known;
  for (const double step : {1.0, 0.25, -3.0, 1e-3}) {
    ValueId value = known.intern(0);
    double now = 0;
    int changes = 0;
    for (int pass = 0; pass < 10'000; ++pass) {
      now += step;
      const ValueId next = known.join(value, known.intern(now));
      changes += next == value ? 0 : 1;
      value = next;
    }
    INFO("step " << step);
    CHECK(changes <=
          2 * static_cast<int>(known.thresholds().numbers().size()) + 2);  // each end may rest below and at a threshold
    CHECK(known.range(value).has(now));
  }
}

TEST_CASE("what states know of parameters is a lattice", "[lattice]") {
  States states(20261130);
  for (int i = 0; i < 3'000; ++i) {
    const Parameters a = states.parameters();
    const Parameters b = states.parameters();
    check_lattice(states, a, b, states.parameters());
    const Parameters joined = states.join(a, b);
    // Only what both know stays known.
    for (uint32_t fact = 1; fact <= 8; ++fact) {
      const uint32_t known = joined.local_outcomes.get(fact);
      REQUIRE((known == 0 || (a.local_outcomes.get(fact) == known && b.local_outcomes.get(fact) == known)));
    }
    REQUIRE(joined.outside == (a.outside || b.outside));
  }
}

TEST_CASE("states are a lattice", "[lattice]") {
  States states(20261131);
  for (int i = 0; i < 3'000; ++i) {
    const State a = states.any();
    const State b = states.any();
    check_lattice(states, a, b, states.any());
    const State joined = states.join(a, b);
    REQUIRE(joined.joined);
    REQUIRE((joined.flags.executed & a.flags.executed) == a.flags.executed);
    REQUIRE((joined.flags.breaking & b.flags.breaking) == b.flags.breaking);
    REQUIRE((!joined.mixed || (a.mixed && b.mixed)));
  }
}

TEST_CASE("equal states have equal hashes, however they came about", "[lattice]") {
  States states(5);
  for (int i = 0; i < 1'000; ++i) {
    const State a = states.any();
    const State b = states.any();
    const State one = states.join(a, b);
    const State other = states.join(b, a);
    REQUIRE(one.hash() == other.hash());
    REQUIRE((a.hash() != b.hash() || (States::equal(a, b) && a.joined == b.joined)));
  }
}

TEST_CASE("a state that is joined with more and more others comes to rest", "[lattice]") {
  States states(11);
  State now = states.any();
  int last_change = 0;
  for (int pass = 1; pass <= 5'000; ++pass) {
    State next = states.join(now, states.any());
    if (!States::equal(next, now)) last_change = pass;
    now = std::move(next);
  }
  CHECK(last_change < 1'000);
}

TEST_CASE("counts of repeats hold what both sides hold", "[lattice]") {
  const auto counted = [](int count) {
    RepeatCounts out;
    out.set(1, count);
    return out;
  };
  const auto joined = [&](int a, int b) { return join(counted(a), counted(b)).of(1); };
  CHECK(joined(3, 3) == 3);
  CHECK(joined(3, 4) == kManyLeft);
  CHECK(joined(3, kManyLeft) == kManyLeft);
  CHECK(joined(3, RepeatCounts::kNotRunning) == kAnyCount);
  CHECK(joined(kManyLeft, kAnyCount) == kAnyCount);
  CHECK(joined(RepeatCounts::kNotRunning, RepeatCounts::kNotRunning) == RepeatCounts::kNotRunning);
}
