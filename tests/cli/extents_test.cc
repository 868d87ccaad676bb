// `owlint extents`: how far programs go, over all their runs.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace extents_command_test {
namespace {

nlohmann::json extents(const std::string& program, const std::string& options = "") {
  const Scratch folder;
  folder.write("p.ngc", program);
  const Run run = owlint::test::owlint(words("extents --isolated --format json p.ngc " + options), "", folder.path());
  CHECK(run.err.empty());
  CHECK(run.status == 0);
  return nlohmann::json::parse(run.out);
}

/// `0 to 30` of the first origin.
std::string along(const nlohmann::json& json, const std::string& axis) {
  const auto& range = json["origins"][0]["axes"][axis];
  return range["least"].dump() + " to " + range["greatest"].dump();
}

}  // namespace

TEST_CASE("extents of loops and subs are those of all their passes", "[extents]") {
  const auto json = extents(
      "G21 G90 G17 F100\no<row> sub\n  o1 repeat [#1]\n    G91 G1 X10\n  o1 endrepeat\n  G90\no<row> endsub\n"
      "G0 X0 Y0\no<row> call [3]\nG0 X0\n#<y> = 0\no2 while [#<y> LT 20]\n  G1 Y#<y>\n  #<y> = [#<y> + 5]\no2 "
      "endwhile\nM2\n");
  CHECK(along(json, "X") == "0.0 to 30.0");
  CHECK(along(json, "Y") == "0.0 to 15.0");
  CHECK(json["complete"] == true);
  CHECK(json["origins"][0]["axes"]["X"]["greatest_at"]["line"] == 4);
}

TEST_CASE("whole circles count in loops, too", "[extents]") {
  const auto json = extents("G21 G90 G17 F100\nG0 X0 Y0\no1 repeat [2]\n  G2 I5\n  G3 J7\no1 endrepeat\nM2\n");
  CHECK(along(json, "X") == "-7.0 to 10.0");
  CHECK(along(json, "Y") == "-5.0 to 14.0");
}

TEST_CASE("extents of all ways through a program are taken together", "[extents]") {
  const auto json = extents("G21 G90\nG0 X0\no1 if [#<_metric_machine>]\n  G0 X10\no1 else\n  G0 X-10\no1 endif\nM2\n");
  CHECK(along(json, "X") == "-10.0 to 10.0");
}

TEST_CASE("what is not known is listed with its first line", "[extents]") {
  const auto json = extents("G21 G90 F100\nG0 X0 Z5\nG1 Z#5063\nG28\nM2\n");
  CHECK(json["complete"] == false);
  REQUIRE_FALSE(json["unknown"].empty());
  CHECK(json["unknown"][0]["line"] == 3);
  CHECK(json["unknown"][0]["axes"] == nlohmann::json{"Z"});
  CHECK(json["unknown"][0]["why"] == "place");
}

TEST_CASE("moves behind a stop are not counted", "[extents]") {
  for (const std::string stop : {"X#<nowhere>\n", "G0 X1..5\n"}) {
    const auto json = extents("G21 G90\nG0 X0\n" + stop + "G0 X50\nM2\n");
    CHECK(along(json, "X") == "0.0 to 0.0");
    CHECK(json["stops_at"]["line"] == 3);
  }
}

TEST_CASE("moves behind the end are not counted", "[extents]") {
  CHECK(along(extents("G21 G90\nG0 X1\nM2\nG0 X50\n"), "X") == "1.0 to 1.0");
  CHECK(along(extents("%\nG21 G90\nG0 X1\n%\nG0 X50\n"), "X") == "1.0 to 1.0");
}

TEST_CASE("extents of a called file name it", "[extents]") {
  const Scratch folder;
  folder.write("p.ngc", "G21 G90\nG0 X0\no<far> call\nM2\n");
  folder.write("far.ngc", "o<far> sub\n  G0 X70\no<far> endsub\n");
  const Run text = owlint::test::owlint(words("extents --isolated p.ngc"), "", folder.path());
  CHECK(text.out.find("line 2 of far.ngc") != std::string::npos);
}

}  // namespace extents_command_test
