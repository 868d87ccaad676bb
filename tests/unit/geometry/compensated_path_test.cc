// Cutter compensation, against what rs274 does with the same moves.
#include <catch2/catch.hpp>

#include "analyzer/geometry/compensated_path.h"

using namespace owlint;

namespace {

constexpr ArcUnits kMetricUnits{false, {'X', 'Y'}};

CompensatedPath left_of_path(double radius, int orientation = 0) {
  CompensatedPath path;
  path.start({Side::kLeft, radius, orientation}, kMetricUnits, {0, 0});
  return path;
}

/// A line with G1 that has to be followed.
void feed(CompensatedPath& path, double x, double y) {
  PathStep step = path.line({x, y}, Mover::kFeed);
  CAPTURE(x, y, step.message);
  REQUIRE_FALSE(step.stops());
}

PathStep turn(CompensatedPath& path, double x, double y, double center_x, double center_y, int turns) {
  return path.arc({{x, y}, false, 0, {center_x, center_y}, turns, 0.028284});
}

}  // namespace

TEST_CASE("the entry move must be longer than the tool radius", "[geometry]") {
  CompensatedPath path = left_of_path(5);
  PathStep step = path.line({3, 4}, Mover::kFeed);
  CHECK(step.fault == PathFault::kEntryTooShort);
  CHECK(step.message == "Length of cutter compensation entry move is not greater than the tool radius");
  CHECK_FALSE(step.undecided);

  path = left_of_path(5);
  step = path.line({5 - 1e-12, 0}, Mover::kFeed);
  CHECK(step.fault == PathFault::kEntryTooShort);
  CHECK(step.undecided);

  path = left_of_path(5);
  feed(path, 5.001, 0);
  CHECK(path.entered());
  CHECK(path.programmed() == PlanePoint{5.001, 0});
  CHECK(path.tool().second == Approx(5));
}

TEST_CASE("a negative radius is the other side", "[geometry]") {
  CompensatedPath path = left_of_path(-5);
  feed(path, 10, 0);
  CHECK(path.tool().second == Approx(-5));
}

TEST_CASE("with radius 0 moves are plain ones", "[geometry]") {
  CompensatedPath path = left_of_path(0);
  CHECK(path.on());
  CHECK_FALSE(path.offsets());
}

TEST_CASE("a slot narrower than the tool is found when the move after it is known", "[geometry]") {
  for (double width : {3.9, 4.0, 4.1}) {
    CAPTURE(width);
    CompensatedPath path = left_of_path(2);
    feed(path, 10, 0);
    feed(path, 10, width);
    PathStep step = path.line({0, width}, Mover::kFeed);
    CHECK(step.undecided == (width == 4.0));
    if (width == 4.0) continue;
    CHECK(step.stops() == (width < 4));
    if (step.stops()) {
      CHECK(step.fault == PathFault::kGouge);
      CHECK(step.message == "Straight feed in concave corner cannot be reached by the tool without gouging");
    }
  }
}

TEST_CASE("a pause finds the move that is too short, and hides the next corner", "[geometry]") {
  CompensatedPath path = left_of_path(2);
  feed(path, 10, 0);
  feed(path, 10, 1);
  CompensatedPath paused = path;
  CHECK(path.pause().fault == PathFault::kGouge);
  CHECK(path.off().fault == PathFault::kGouge);

  paused = left_of_path(2);
  feed(paused, 10, 0);
  REQUIRE_FALSE(paused.pause().stops());
  feed(paused, 10, 1);
  feed(paused, 0, 1);
}

TEST_CASE("G40 goes back to the programmed point, and then forbids an arc", "[geometry]") {
  CompensatedPath path = left_of_path(2);
  feed(path, 10, 0);
  REQUIRE_FALSE(path.off().stops());
  CHECK_FALSE(path.on());
  CHECK(path.tool() == PlanePoint{10, 0});
  CHECK(path.arc_forbidden());
  path.straight_begins();
  CHECK_FALSE(path.arc_forbidden());

  path.start({Side::kLeft, 2, 0}, kMetricUnits, {0, 0});
  REQUIRE_FALSE(path.off().stops());
  CHECK_FALSE(path.arc_forbidden());
}

TEST_CASE("arcs that the tool does not fit into", "[geometry]") {
  CompensatedPath path = left_of_path(2);
  feed(path, 10, 0);
  CompensatedPath other = path;
  PathStep step = turn(path, 10, 4, 10, 2, 1);
  CHECK(step.fault == PathFault::kGouge);
  CHECK(step.message == "Tool radius not less than arc radius with comp");
  CHECK_FALSE(step.undecided);

  CHECK_FALSE(turn(other, 10, 6, 10, 3, 1).stops());
  CHECK(other.tool().second == Approx(4));
}

TEST_CASE("a radius equal to the tool's but for rounding is undecided", "[geometry]") {
  CompensatedPath path = left_of_path(0.3);
  feed(path, 0.1 + 0.2, 0);
  CHECK(path.programmed().first > 0.3);
  path = left_of_path(0.3);
  CHECK(path.line({0.1 + 0.2, 0}, Mover::kFeed).undecided);
}

TEST_CASE("the numbers of an arc are checked first", "[geometry]") {
  CompensatedPath path = left_of_path(1);
  feed(path, 10, 0);
  PathStep step = turn(path, 15.1, 5, 10, 5, 1);
  CHECK(step.fault == PathFault::kRadiiDiffer);
  CHECK(step.message ==
        "Radius to end of arc differs from radius to start: start=(X10.0000,Y0.0000) center=(X10.0000,Y5.0000) "
        "end=(X15.1000,Y5.0000) r1=5.0000 r2=5.1000 abs_err=0.1 rel_err=1.9608%");
}

TEST_CASE("a thread is followed only straight on and into inside corners", "[geometry]") {
  CompensatedPath path = left_of_path(1);
  CHECK(path.line({10, 0}, Mover::kThread).fault == PathFault::kNotStraight);
  path = left_of_path(1);
  feed(path, 10, 0);
  CHECK_FALSE(path.line({20, 0}, Mover::kThread).stops());
  CHECK_FALSE(path.line({20, 10}, Mover::kThread).stops());
  CHECK(path.line({30, 10}, Mover::kThread).fault == PathFault::kNotStraight);
  path = left_of_path(1);
  feed(path, 10, 0);
  CHECK(path.line({10, 0}, Mover::kThread).fault == PathFault::kNotStraight);
}

TEST_CASE("an entry arc of a lathe tool leaves what the interpreter calls a bug", "[geometry]") {
  CompensatedPath mill = left_of_path(2);
  CompensatedPath lathe = left_of_path(2, 3);
  REQUIRE_FALSE(turn(mill, 10, 10, 0, 10, 1).stops());
  REQUIRE_FALSE(turn(lathe, 10, 10, 0, 10, 1).stops());
  CHECK(mill.tool() == lathe.tool());
  CHECK_FALSE(mill.line({0, 10}, Mover::kFeed).fault == PathFault::kBug);
  PathStep step = lathe.line({0, 10}, Mover::kFeed);
  CHECK(step.fault == PathFault::kBug);
  CHECK(step.message.starts_with("BUG: cutter compensation has generated an invalid arc with mismatched radii r1 "));
}

TEST_CASE("units scale the path, and what waits scales the corner that is left behind", "[geometry]") {
  // A corner at Y20, a move down from there, and a change of units before it is known where it ends.
  for (int others : {0, 1}) {
    CAPTURE(others);
    CompensatedPath path;
    path.start({Side::kRight, 0.01, 0}, kMetricUnits, {0, 20});
    feed(path, 10, 20);
    feed(path, 10, 10);
    path.append(others);
    path.change_units(true);
    CHECK(path.programmed().first == Approx(10 / 25.4));
    CHECK(path.line({-1, 10 / 25.4}, Mover::kFeed).stops() == (others == 1));
  }
}

TEST_CASE("a path is as good as new after G40", "[geometry]") {
  CompensatedPath one = left_of_path(2);
  feed(one, 10, 0);
  feed(one, 20, 5);
  REQUIRE_FALSE(one.off().stops());
  CompensatedPath other = left_of_path(1);
  feed(other, 20, 5);
  REQUIRE_FALSE(other.off().stops());
  CHECK(one == other);
}

TEST_CASE("moves that stay where they are take no room", "[geometry]") {
  CompensatedPath path = left_of_path(2);
  feed(path, 10, 0);
  for (int i = 0; i < 100'000; ++i) feed(path, 10, 0);
  feed(path, 10, 3);
  CHECK(path.line({0, 3}, Mover::kFeed).fault == PathFault::kGouge);
  CHECK(sizeof(path) < 512);
}
