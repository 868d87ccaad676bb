// Ranges must hold whatever arithmetic.h gives for their members.
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "analyzer/flow/domain/ranges.h"
#include "analyzer/syntax/arithmetic.h"

using namespace owlint;
using flow::Range;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Random {
 public:
  double number() {
    static const double kOften[] = {0, 1, -1, 2, 0.5, 5, -5, 0.0001, 100, -0.0001, 90, 1e9};
    return chance(0.7) ? kOften[random_() % std::size(kOften)]
                       : std::uniform_real_distribution<double>(-20, 20)(random_);
  }
  Range range() {
    double a = chance(0.15) ? -kInfinity : number();
    double b = chance(0.15) ? kInfinity : number();
    if (a > b) std::swap(a, b);
    return {a, b, chance(0.3) && a < b, chance(0.3) && a < b};
  }
  /// Often one of the ends.
  double member(const Range& r) {
    for (;;) {
      double value = number();
      if (chance(0.3) && std::isfinite(r.low))
        value = r.low;
      else if (chance(0.3) && std::isfinite(r.high))
        value = r.high;
      else if (std::isfinite(r.low) && std::isfinite(r.high))
        value = std::uniform_real_distribution<double>(r.low, std::nextafter(r.high, kInfinity))(random_);
      else if (std::isfinite(r.low))
        value = r.low + std::fabs(value);
      else if (std::isfinite(r.high))
        value = r.high - std::fabs(value);
      if (r.has(value)) return value;
      if (r.low == r.high) return r.low;
    }
  }
  bool chance(double p) { return std::bernoulli_distribution(p)(random_); }
  Operator op() {
    return static_cast<Operator>(
        static_cast<int>(Operator::kNegate) +
        static_cast<int>(random_() % (static_cast<int>(Operator::kXor) - static_cast<int>(Operator::kNegate) + 1)));
  }

 private:
  std::mt19937 random_{7};
};

std::string text(const Range& r) {
  return (r.above_low ? "(" : "[") + std::to_string(r.low) + ", " + std::to_string(r.high) + (r.below_high ? ")" : "]");
}

}  // namespace

TEST_CASE("a range holds the results of its members", "[ranges]") {
  Random random;
  size_t narrowed = 0;
  size_t failing = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Operator op = random.op();
    const Range left = random.range();
    const Range right = random.range();
    const Range out = flow::apply(op, left, right);
    const char* fails = flow::always_fails(op, left, right);
    narrowed += out.is_all() ? 0 : 1;
    failing += fails != nullptr ? 1 : 0;
    for (int k = 0; k < 4; ++k) {
      const double a = random.member(left);
      const double b = random.member(right);
      double result = 0;
      const char* message = owlint::apply(op, a, b, &result);
      INFO(operator_text(op) << " of " << text(left) << " and " << text(right) << " is " << text(out) << "; " << a
                             << ", " << b << " give " << result);
      if (fails != nullptr) {
        REQUIRE(message != nullptr);
        REQUIRE(std::string(message) == fails);
      } else if (message == nullptr) {
        // One unit in the last place is what a function may round otherwise than its inverse.
        const double slack = std::fabs(result) * 1e-12;
        REQUIRE((out.has(result) || out.has(result - slack) || out.has(result + slack)));
      }
    }
  }
  CHECK(narrowed > 100'000);
  CHECK(failing > 1'000);
}

TEST_CASE("narrowing keeps every member for which a comparison comes out so", "[ranges]") {
  Random random;
  size_t narrower = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto op = static_cast<Operator>(static_cast<int>(Operator::kEq) + i % 6);
    const Range left = random.range();
    const Range right = random.range();
    for (const bool truth : {true, false}) {
      const Range out = flow::narrowed(left, op, right, truth);
      narrower += out == left ? 0 : 1;
      for (int k = 0; k < 4; ++k) {
        const double a = random.member(left);
        const double b = random.member(right);
        double result = 0;
        owlint::apply(op, a, b, &result);
        if ((result != 0) != truth) continue;
        INFO(text(left) << " " << operator_text(op) << " " << text(right) << " " << truth << ": " << text(out)
                        << " lacks " << a << " with " << b);
        REQUIRE(out.has(a));
        owlint::apply(flow::mirrored(op), b, a, &result);
        REQUIRE((result != 0) == truth);
      }
    }
  }
  CHECK(narrower > 50'000);
}

TEST_CASE("widened ranges hold the range and come to rest", "[ranges]") {
  Random random;
  for (int i = 0; i < 20'000; ++i) {
    const flow::Thresholds thresholds({random.number(), random.number(), random.number()});
    const Range range = random.range();
    const Range wide = thresholds.widened(range);
    const double member = random.member(range);
    INFO(text(range) << " widened to " << text(wide));
    REQUIRE(wide.has(member));
    REQUIRE(thresholds.widened(wide) == wide);
    REQUIRE(flow::hull(wide, range) == wide);
  }
}
