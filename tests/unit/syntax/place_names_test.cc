// What a program reads back of where the machine stands.
#include <catch2/catch.hpp>

#include "analyzer/syntax/mode_names.h"
#include "analyzer/syntax/place_names.h"

using namespace owlint;

TEST_CASE("positions and the tool have a number and a name", "[place]") {
  REQUIRE(PlaceName::find(5420));
  CHECK(PlaceName::find(5420)->axis() == Axis::kX);
  CHECK(PlaceName::find(5428)->axis() == Axis::kW);
  CHECK_FALSE(PlaceName::find(5429));
  CHECK_FALSE(PlaceName::find(5419));
  CHECK(PlaceName::find("_z")->axis() == Axis::kZ);
  CHECK_FALSE(PlaceName::find("_abs_x"));
  CHECK_FALSE(PlaceName::find("x"));
  REQUIRE(PlaceName::find(5400));
  CHECK_FALSE(PlaceName::find(5400)->axis());
  CHECK(PlaceName::find("_current_tool"));
}

TEST_CASE("a position is read where it does not depend on where the program begins", "[place]") {
  Place place = Place::started();
  const PlaceName x = *PlaceName::find("_x");
  CHECK_FALSE(x.number(place, false));
  CHECK(x.number(place, true) == 0);
  place.at[Axis::kX] = Coordinate::of(5);
  CHECK(x.number(place, false) == 5);
  place.at[Axis::kX] = Coordinate::unknown();
  CHECK_FALSE(x.number(place, true));
}

TEST_CASE("behind a tool change the machine may stand elsewhere", "[place]") {
  Place place = Place::started();
  place.at[Axis::kX] = Coordinate::of(5);
  place.tool = Point{};
  Place stayed = place;
  stayed.ask_machine(false);
  CHECK(stayed.at[Axis::kX].is_known());
  Place moved = place;
  moved.ask_machine(true);
  CHECK_FALSE(moved.at[Axis::kX].is_known());
  CHECK(moved.at[Axis::kX].value == 5);
}

TEST_CASE("the tool and the coordinate system are read by number", "[place]") {
  Place place = Place::started();
  CHECK_FALSE(PlaceName::find(5400)->number(place, false));
  place.loaded_tool = 3;
  CHECK(PlaceName::find(5400)->number(place, false) == 3);
  REQUIRE(ModeName::find(5220));
  const auto numbers = ModeName::find(5220)->numbers(value_bit(modes::kG55));
  REQUIRE(numbers);
  CHECK(numbers->least == 2);
  CHECK(numbers->greatest == 2);
  CHECK_FALSE(ModeName::find(5221));
}
