// How far arcs go between their ends.
#include <catch2/catch.hpp>

#include "analyzer/geometry/arc_box.h"

using namespace owlint;

namespace arc_box_test {
namespace {

void check_box(const ArcBox& box, Flat least, Flat greatest) {
  CHECK(box.least.first == Approx(least.first).margin(1e-12));
  CHECK(box.least.second == Approx(least.second).margin(1e-12));
  CHECK(box.greatest.first == Approx(greatest.first).margin(1e-12));
  CHECK(box.greatest.second == Approx(greatest.second).margin(1e-12));
}

}  // namespace

TEST_CASE("half a circle goes to one side of its ends", "[geometry]") {
  check_box(arc_box({0, 0}, {10, 0}, {20, 0}, true, 1), {0, 0}, {20, 10});
  check_box(arc_box({0, 0}, {10, 0}, {20, 0}, false, 1), {0, -10}, {20, 0});
}

TEST_CASE("an arc of less than a quarter may go no further than its ends", "[geometry]") {
  check_box(arc_box({3, 4}, {0, 0}, {4, 3}, true, 1), {3, 3}, {4, 4});
  check_box(arc_box({3, 4}, {0, 0}, {4, 3}, false, 1), {-5, -5}, {5, 5});
}

TEST_CASE("where the ends are one point, or with several turns, it is a whole circle", "[geometry]") {
  check_box(arc_box({1, 0}, {3, 0}, {1, 0}, true, 1), {1, -2}, {5, 2});
  check_box(arc_box({3, 4}, {0, 0}, {4, 3}, true, 2), {-5, -5}, {5, 5});
}

TEST_CASE("a negative radius is the greater arc", "[geometry]") {
  const Flat start{0, 0}, end{8, 0};
  CHECK(center_by_radius(start, end, 5, true) == Flat{4, -3});
  CHECK(center_by_radius(start, end, -5, true) == Flat{4, 3});
  CHECK(center_by_radius(start, end, 5, false) == Flat{4, 3});
  CHECK(center_by_radius(start, end, -5, false) == Flat{4, -3});
  // A radius that is too small by a little reaches all the same.
  CHECK(center_by_radius(start, end, 3.9999, true).second == Approx(0).margin(1e-12));
}

}  // namespace arc_box_test
