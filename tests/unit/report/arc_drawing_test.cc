// The drawing of an arc that does not fit: everything is inside it, whatever the numbers, and its words are those of the rule.
#include <random>
#include <regex>

#include <catch2/catch.hpp>
#include <pugixml.hpp>

#include "analyzer/report/arc_drawing.h"
#include "rules/driver/lint.h"

using namespace owlint;

namespace {

const Finding& finding_of(const FileReport& report, std::string_view code) {
  const auto found = std::ranges::find(report.findings, code, &Finding::code);
  REQUIRE(found != report.findings.end());
  return *found;
}

FileReport found_in(const std::string& line) {
  return lint(Source::own("arc.ngc", "G21 G90 G17 F200\nG0 X0 Y0 Z0\n" + line + "\nM2\n"), {}, {});
}

void check_drawing(const ArcSketch& arc) {
  const std::string svg = arc_svg(arc);
  INFO(svg);
  pugi::xml_document document;
  REQUIRE(document.load_string(svg.c_str()));
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
  const double height = document.child("svg").attribute("height").as_double();
  for (const pugi::xml_node node : document.child("svg")) {
    for (const char* across : {"x", "cx", "x1", "x2"}) {
      if (!node.attribute(across)) continue;
      CHECK(node.attribute(across).as_double() > 0);
      CHECK(node.attribute(across).as_double() < 380);
    }
    for (const char* down : {"y", "cy", "y1", "y2"}) {
      if (node.attribute(down)) CHECK(node.attribute(down).as_double() < height);
    }
  }
}

}  // namespace

TEST_CASE("arcs by their center are drawn with both radii and the nearest arc that fits", "[report]") {
  const FileReport report = found_in("G2 X20 Y0 I10.1 J0");
  const Finding& f = finding_of(report, "OW901");
  REQUIRE(f.arc != nullptr);
  CHECK(f.arc->clockwise);
  CHECK(arc_sentence(*f.arc) ==
        "start: X0 Y0; end: X20 Y0; center, as written: X10.1 Y0; from the center to the start: 10.1 mm; from the "
        "center to "
        "the end: 9.9 mm; center that fits: X10 Y0; radius that fits: 10 mm");
  check_drawing(*f.arc);
}

TEST_CASE("arcs by their radius are drawn with the least arc that fits", "[report]") {
  const FileReport report = found_in("G3 X20 Y10 R11.1");
  const Finding& f = finding_of(report, "OW902");
  REQUIRE(f.arc != nullptr);
  CHECK_FALSE(f.arc->clockwise);
  CHECK(arc_sentence(*f.arc) ==
        "start: X0 Y0; end: X20 Y10; radius, as written: 11.1 mm; center that fits: X10 Y5; least radius that "
        "fits: 11.1803 mm");
  check_drawing(*f.arc);
}

TEST_CASE("an arc whose center is its start has no arc that fits", "[report]") {
  const FileReport report = found_in("G2 X20 Y0 I0 J0");
  const Finding& f = finding_of(report, "OW903");
  REQUIRE(f.arc != nullptr);
  CHECK_FALSE(f.arc->nearest);
  check_drawing(*f.arc);
}

TEST_CASE("from where a machine stands, points count from there", "[report]") {
  const FileReport report = lint(Source::own("arc.ngc", "G21 G91 G17 F200\nG2 X20 Y0 I10.1 J0\nM2\n"), {}, {});
  const Finding& f = finding_of(report, "OW901");
  REQUIRE(f.arc != nullptr);
  check_drawing(*f.arc);
}

TEST_CASE("random arcs are drawn inside their room", "[report]") {
  std::mt19937 random(5);
  const auto number = [&](double most) { return std::uniform_real_distribution<double>(-most, most)(random); };
  for (int i = 0; i < 400; ++i) {
    const double size = std::pow(10, number(4));
    ArcSketch arc;
    arc.clockwise = i % 2 == 0;
    arc.start = {number(size), number(size), "start"};
    arc.end = i % 7 == 0 ? arc.start : ArcSketch::Point{number(size), number(size), "end"};
    if (i % 3 != 0) {
      arc.center = i % 5 == 0 ? arc.start : ArcSketch::Point{number(size), number(size), "center"};
      arc.start_radius = std::hypot(arc.center->right - arc.start.right, arc.center->up - arc.start.up);
      arc.end_radius = std::hypot(arc.center->right - arc.end.right, arc.center->up - arc.end.up);
    } else {
      arc.start_radius = arc.end_radius = std::abs(number(size));
    }
    if (i % 4 == 0) {
      const ArcSketch::Point center{number(size), number(size), "middle"};
      arc.nearest = {center, std::hypot(center.right - arc.start.right, center.up - arc.start.up), "radius"};
    }
    check_drawing(arc);
  }
}
