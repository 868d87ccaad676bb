// Arcs at their tolerances. Each was run with rs274 2.9.0~pre1.
#include <catch2/catch.hpp>

#include "analyzer/geometry/arc.h"

using namespace owlint;

namespace {

constexpr ArcTolerance kMillimetres{0.00127, 0.02 * 1.4142135623730951};

ArcFault by_center(Flat start, Flat center, Flat end) { return arc_by_center(start, center, end, kMillimetres).fault; }
ArcFault by_radius(Flat end, double radius) { return arc_by_radius({0, 0}, end, radius, kMillimetres).fault; }

}  // namespace

TEST_CASE("both ends of an arc are as far from its center", "[geometry]") {
  CHECK(by_center({0, 0}, {1, 0}, {2, 0}) == ArcFault::kNone);
  CHECK(by_center({0, 0}, {1, 0}, {2.0282, 0}) == ArcFault::kNone);
  CHECK(by_center({0, 0}, {1, 0}, {2.0283, 0}) == ArcFault::kRadiiDiffer);
  // A share of less than a thousandth passes, up to a hundredfold difference.
  CHECK(by_center({0, 0}, {40, 0}, {80.05, 0}) == ArcFault::kRadiiDiffer);
  CHECK(by_center({0, 0}, {60, 0}, {120.05, 0}) == ArcFault::kNone);
  CHECK(by_center({0, 0}, {9000, 0}, {18002.82, 0}) == ArcFault::kNone);
  CHECK(by_center({0, 0}, {9000, 0}, {18002.83, 0}) == ArcFault::kRadiiDiffer);
  CHECK(by_center({0, 0}, {0, 0}, {2, 0}) == ArcFault::kZeroRadius);
  CHECK(by_center({0, 0}, {1, 0}, {1, 0.001}) == ArcFault::kZeroRadius);
  CHECK(by_center({0, 0}, {1, 0}, {0, 0}) == ArcFault::kNone);  // a full circle
}

TEST_CASE("what would pass is known", "[geometry]") {
  CHECK(arc_by_center({0, 0}, {1, 0}, {3, 0}, kMillimetres).allowed == kMillimetres.difference);
  CHECK(arc_by_center({0, 0}, {40, 0}, {80.05, 0}, kMillimetres).allowed == Approx(0.04005));
  CHECK(arc_by_center({0, 0}, {9000, 0}, {18002.83, 0}, kMillimetres).allowed == Approx(2.82842712));
}

TEST_CASE("a radius reaches both ends", "[geometry]") {
  CHECK(by_radius({2, 0}, 1) == ArcFault::kNone);
  CHECK(by_radius({2, 0}, -1) == ArcFault::kNone);
  CHECK(by_radius({2, 0}, 0.9988) == ArcFault::kNone);
  CHECK(by_radius({2, 0}, 0.9987) == ArcFault::kRadiusTooSmall);
  CHECK(by_radius({0, 0}, 1) == ArcFault::kSamePoint);
  CHECK(arc_by_radius({0, 0}, {3, 4}, 1, kMillimetres).least_radius == 2.5);
}
