// The domain of values is a lattice: where paths meet, it does not matter in which order, and chains come to rest.
#include <limits>
#include <random>

#include <catch2/catch.hpp>

#include "analyzer/flow/domain/known_values.h"

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
  /// a ≤ b: b holds whatever a holds.
  bool leq(ValueId a, ValueId b) { return known.join(a, b) == b; }

  KnownValues known;

 private:
  std::mt19937 random_;
};

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
