// What owlint proposes for arcs and cycles whose numbers do not fit. Each of these was tried in rs274.
#include <catch2/catch.hpp>

#include "support/process.h"

namespace arc_advice_test {
namespace {

/// The help of the only finding.
std::string help_of(const std::string& program) {
  const nlohmann::json findings = owlint::test::findings_of(program + "\nM2\n");
  return findings.size() == 1 ? findings[0].value("help", "") : std::to_string(findings.size()) + " findings";
}

}  // namespace

TEST_CASE("numbers that nearly fit get the nearest center and the nearest end", "[rules]") {
  CHECK(help_of("G0 X0 Y0\nG2 X10 Y0 I5.1 J0 F9") ==
        "the nearest center that fits is `I5 J0`; if the center is right, an end at `X10.2 Y0` fits");
  CHECK(help_of("G90.1\nG0 X10 Y0\nG2 X20 Y0 I15.1 J1 F9") ==
        "the nearest center that fits is `I15 J1`; if the center is right, an end at `X20.1922 Y-0.0392` fits");
  CHECK(help_of("G18\nG0 X0 Z0\nG2 X10 Z0 I5.1 K0 F9") ==
        "the nearest center that fits is `I5 K0`; if the center is right, an end at `X10.2 Z0` fits");
}

TEST_CASE("an incremental end is proposed as one, and X in diameter mode as a diameter", "[rules]") {
  CHECK(help_of("G91\nG2 X10 Y0 I5.1 J0 F9") ==
        "the nearest center that fits is `I5 J0`; if the center is right, an end at `X10.2 Y0` fits");
  CHECK(help_of("G7 G18\nG0 X20 Z0\nG2 X40 Z0 I5.1 K0 F9") ==
        "the nearest center that fits is `I5 K0`; if the center is right, an end at `X40.4 Z0` fits");
}

TEST_CASE("the mode is named in which the numbers fit", "[rules]") {
  CHECK(help_of("G0 X10 Y10\nG2 X20 Y10 I15 J10 F9") ==
        "`I` and `J` fit as the place of the center itself: `G90.1` seems to be meant; as it is, write `I5 J0`");
  CHECK(help_of("G90.1\nG0 X10 Y10\nG2 X20 Y10 I5 J0 F9") ==
        "`I` and `J` fit as distances from the start: `G91.1` seems to be meant; as it is, write `I15 J10`");
  CHECK(help_of("G0 X10 Y0\nG91\nG2 X20 Y0 I5 J0 F9") == "the end fits in `G90`; in `G91` it counts from the start");
}

TEST_CASE("numbers of another unit, signs, letters and diameters are named", "[rules]") {
  CHECK(help_of("G20\nG0 X0 Y0\nG2 X1 Y0 I12.7 J0 F9") ==
        "the center fits if its numbers are millimeters: in inches it is `I0.5 J0`");
  CHECK(help_of("G0 X0 Y0\nG2 X1 Y0 I12.7 J0 F9") ==
        "the end fits if its numbers are inches: in millimeters it is `X25.4 Y0`");
  CHECK(help_of("G0 X0 Y0\nG2 X10 Y0 I-5 J0 F9") ==
        "a center at `I5 J0` would fit: check the signs, the letters, and the end");
  CHECK(help_of("G7 G18\nG0 X30 Z0\nG2 X50 Z10 I20 K0 F9") == "`I` is no diameter in `G7`, only `X` is: `I10 K0` fits");
  CHECK(help_of("G0 X0 Y0\nG2 X10 Y3 I2 J-9 F9") == "check the end, the center, and where the arc starts");
}

TEST_CASE("the least radius is rounded up", "[rules]") {
  CHECK(help_of("G0 X0 Y0\nG3 X20 Y10 R-11.17 F9") == "`R-11.1804` reaches it, as a half circle");
  CHECK(help_of("G0 X0 Y0\nG2 X25.4 Y0 R0.5 F9") ==
        "a half circle fits if the radius is in inches: in millimeters it is `R12.7`");
  CHECK(help_of("G2 X20 Y0 R9 F9") == "`R10` reaches it, as a half circle; or write a move to its start before it");
}

TEST_CASE("a full circle by its radius gets a center", "[rules]") {
  CHECK(help_of("G18\nG0 X0 Z0\nG2 X0 Z0 R5 F9") ==
        "a full circle needs its center instead of `R`, such as `I5` or `K5`");
}

}  // namespace arc_advice_test
