// How far the lines of a program go up to the first from where runs may go elsewhere, as the scanner finds it, and which of them
// end beyond limits.
#include <catch2/catch.hpp>

#include "analyzer/syntax/statement.h"

using namespace owlint;

namespace extents_test {
namespace {

constexpr size_t kX = 0, kY = 1, kZ = 2;

std::shared_ptr<const Extents> extents_of(const std::string& text) {
  MachineWords machine;
  machine.measures_extents = true;
  return scan(*Source::own("p.ngc", text), machine).extents;
}

Extent reach(const Extents& extents, size_t axis, Extents::Origin origin = {}) {
  const auto found = extents.origins().find(origin);
  return found == extents.origins().end() ? Extent{} : found->second[axis].both();
}

void check_extent(const Extent& extent, double least, uint32_t least_line, double greatest, uint32_t greatest_line) {
  CHECK(extent.least == Approx(least).margin(1e-9));
  CHECK(extent.greatest == Approx(greatest).margin(1e-9));
  CHECK(extent.least_at.line == least_line);
  CHECK(extent.greatest_at.line == greatest_line);
}

std::vector<LimitFault> faults_of(const std::string& text) {
  MachineWords machine;
  machine.units_per_mm = 1;
  machine.limits[kX] = {-10, 400};
  machine.limits[kZ] = {-100, 0};
  machine.has_limits = true;
  return scan(*Source::own("p.ngc", text), machine).limit_faults;
}

}  // namespace

TEST_CASE("plain lines are taken by their extremes, with the lines", "[extents]") {
  const auto extents = extents_of("G21 G90 G94 F100\nG0 X10\nG1 X20 Z-1\nX-5\nX7 Z-2\nM2\n");
  check_extent(reach(*extents, kX), -5, 4, 20, 3);
  check_extent(reach(*extents, kZ), -2, 5, -1, 3);
  CHECK(reach(*extents, kY).empty());
  CHECK(extents->unknown().empty());
  CHECK(extents->unit() == 1);
}

TEST_CASE("rapid moves and others are kept apart", "[extents]") {
  const auto extents = extents_of("G21 G90 F100\nG0 X10\nG1 X20\nG0 X30\nM2\n");
  const Extents::Rates& x = extents->origins().at({})[kX];
  CHECK(x.rapid.greatest == 30);
  CHECK(x.feed.greatest == 20);
}

TEST_CASE("incremental moves are added up", "[extents]") {
  const auto extents = extents_of("G21 G90 F100\nG0 X10\nG91\nG1 X5\nX5\nX-30\nX1\nM2\n");
  check_extent(reach(*extents, kX), -10, 6, 20, 5);
}

TEST_CASE("incremental moves from the start count from there", "[extents]") {
  const auto extents = extents_of("G21 G91 F100\nG1 X5\nX5\nM2\n");
  CHECK(reach(*extents, kX).empty());
  check_extent(reach(*extents, kX, {0, false, true}), 5, 2, 10, 3);
}

TEST_CASE("arcs count with what is between their ends", "[extents]") {
  const auto extents = extents_of("G21 G90 G17 F100\nG0 X0 Y0\nG2 X20 I10\nX0 R-10\nM2\n");
  check_extent(reach(*extents, kY), -10, 4, 10, 3);
  CHECK(extents->unknown().empty());
}

TEST_CASE("of an arc from somewhere only the end is known", "[extents]") {
  const auto extents = extents_of("G21 G90 G17 F100\nG28\nG2 X20 Y0 I10\nM2\n");
  check_extent(reach(*extents, kX), 20, 3, 20, 3);
  CHECK(extents->unknown().at({UnknownExtent::kPlace, kX}).line == 2);
}

TEST_CASE("a cycle counts with R, its depth and where it retracts to", "[extents]") {
  const auto extents = extents_of("G21 G90 G17 G98 F100\nG0 X0 Y0 Z20\nG81 X10 Y5 Z-3 R2\nX30\nG80\nM2\n");
  check_extent(reach(*extents, kX), 0, 2, 30, 4);
  check_extent(reach(*extents, kZ), -3, 3, 20, 2);
}

TEST_CASE("coordinate systems, G92 and the machine have coordinates of their own", "[extents]") {
  const auto extents = extents_of("G21 G90\nG0 X1\nG55\nG0 X2\nG92 X0\nG0 X3\nG53 G0 X4\nM2\n");
  CHECK(reach(*extents, kX).greatest == 1);
  CHECK(reach(*extents, kX, {1, false, false}).greatest == 2);
  CHECK(reach(*extents, kX, {1, true, false}).greatest == 3);
  CHECK(reach(*extents, kX, {Extents::Origin::kMachine, false, false}).greatest == 4);
}

TEST_CASE("lengths are in units of the first move", "[extents]") {
  const auto extents = extents_of("G20 G90\nG0 X1\nG21\nG0 X50.8\nM2\n");
  CHECK(extents->unit() == 25.4);
  check_extent(reach(*extents, kX), 1, 2, 2, 4);
}

TEST_CASE("a diameter is twice a radius", "[extents]") {
  const auto extents = extents_of("G21 G90 G7\nG0 X20\nG8\nG0 X15\nM2\n");
  check_extent(reach(*extents, kX), 10, 2, 15, 4);
}

TEST_CASE("of many lines the first beyond a limit is found", "[extents]") {
  const auto faults = faults_of("G21 G90 F100\nG0 Z0\nG53 G0 Z0\nG53 G0 Z1\nG53 G0 Z2\nM2\n");
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].line == 4);
  CHECK(faults[0].position == 1);
  CHECK(faults[0].furthest_line == 5);
  CHECK(faults[0].needs == LimitFault::Needs::kNothing);
}

TEST_CASE("of many plain lines the first that makes the way too long is found", "[extents]") {
  const auto faults = faults_of("G21 G90 F100\nG0 Z0\nG1 Z-10\nZ-101\nZ-5\nZ-120\nG0 Z0\nM2\n");
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].is_distance());
  CHECK(faults[0].line == 4);
  CHECK(faults[0].from_line == 2);
  CHECK(faults[0].furthest == 120);
  CHECK(faults[0].limit == 100);
}

TEST_CASE("what is as long as the axis fits", "[extents]") {
  CHECK(faults_of("G21 G90 F100\nG0 X-5 Z50\nG1 X405 Z-50\nM2\n").empty());
  CHECK(faults_of("G20 G90 F100\nG0 X0\nG0 X16.1\nM2\n").empty());
}

TEST_CASE("a rotation that is not known makes a way along X doubtful, up to the diagonal", "[extents]") {
  const auto faults = faults_of("G21 G90 F100\nG0 X0\nG1 X411\nM2\n");
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].needs == LimitFault::Needs::kNoRotation);
}

}  // namespace extents_test
