// Turns and polar coordinates.
#include <catch2/catch.hpp>

#include "analyzer/geometry/plane.h"

using namespace owlint;

TEST_CASE("a point turns about the origin, counterclockwise", "[geometry]") {
  const Flat point = turned({2, 0}, 90);
  CHECK(point.first == Approx(0).margin(1e-12));
  CHECK(point.second == Approx(2));
  CHECK(turned({2, 1}, 0) == Flat{2, 1});
}

TEST_CASE("polar words change what they name", "[geometry]") {
  const double radius = 2, angle = 90;
  CHECK(polar({3, 4}, &radius, nullptr).second == Approx(1.6));
  CHECK(polar({3, 4}, nullptr, &angle).second == Approx(5));
  CHECK(polar({3, 4}, &radius, &angle).second == Approx(2));
  CHECK(further_out({3, 4}, 5).first == Approx(6));
  CHECK(further_around({3, 4}, 90).first == Approx(-4));
}
