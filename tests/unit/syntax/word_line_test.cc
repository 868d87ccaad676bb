// Words of a line as they are read, axis words and codes of group 0: each case was run with rs274 2.9.0~pre1, or read
// in a later release.
#include <string>

#include <catch2/catch.hpp>

#include "support/word_lines.h"

using namespace owlint;
using namespace owlint::test;

namespace word_line_test {
namespace {

MotionSet behind(const std::string& text, Motion before = Motion::kG80) {
  WordLine line(kAlone);
  REQUIRE_FALSE(read(line, text));
  MotionSet after = 0;
  REQUIRE_FALSE(line.check(in(before), &after));
  CHECK(line.after(set_of(before)) == after);
  return after;
}

constexpr auto kG0 = Motion::kG0;
constexpr auto kG1 = Motion::kG1;
constexpr auto kG2 = Motion::kG2;
constexpr auto kG81 = Motion::kG81;

}  // namespace

TEST_CASE("a word that is on the line twice stops, but for a few", "[words]") {
  for (const char letter : std::string("XYZABCDEFHIJKLRST")) {
    const std::string word(1, letter);
    CHECK(stops(word + "1 " + word + "2") ==
          "Multiple " + std::string(1, static_cast<char>(letter + 32)) + " words on one line");
  }
  CHECK(stops("$0 $0") == "Multiple spindle choice ($) words on one line");
  CHECK(stops("G0 @1 @2 ^3 ^4").empty());
  CHECK(stops("G4 P1 P2") == "Multiple p words on one line");
  CHECK(stops("G4 P-1 P2").empty());
  CHECK(stops("G4 P-0.5 P2") == "Multiple p words on one line");
  CHECK(stops("Q-1 Q-2 Q-1").empty());
  CHECK(stops("Q1 Q-1") == "Multiple q words on one line");
  const MachineWords foam{.release = Release::k2_8, .axes = letter_set("xyuv"), .remapped = {}};
  CHECK(stops("G0 U1 U2", kStart, foam) == "Multiple U words on one line");

  const auto fault = fault_of("G0 X1 Y2 X3");
  REQUIRE(fault);
  CHECK(fault->kind == StopKind::kWordRepeated);
  CHECK(fault->word == 3);
  CHECK(fault->other == 1);
  CHECK(fault->certain);
}

TEST_CASE("an axis that the machine lacks is no letter", "[words]") {
  CHECK(stops("G0 U1") == "Bad character 'u' used");
  CHECK(fault_of("G0 X1 W2")->kind == StopKind::kWordUnknown);
  CHECK(stops("G0 C1", kStart, {.release = Release::k2_8, .axes = letter_set("xyz"), .remapped = {}}) ==
        "Bad character 'c' used");
}

TEST_CASE("numbers have the ranges of their words", "[words]") {
  const char* const kTable[][2] = {
      {"F-1", "Negative f word used"},
      {"F-0", ""},
      {"S-1", "Negative spindle speed used"},
      {"H-2", "Negative h word used"},
      {"G43 H-1", ""},
      {"H1.5", "Non integer value for integer"},
      {"G43 H1.00009", ""},
      {"G10 L-1", "Negative l word used"},
      {"L1.5", "Non integer value for integer"},
      {"T-1", "Negative tool id (tool not found)"},
      {"T-0", ""},
      {"T2.0002", "Non integer value for integer"},
      {"T99999999999", "Negative tool id (tool not found)"},
      {"T2147483647", ""},
      {"T2147483648", "Negative tool id (tool not found)"},
      {"$0.9 M3", ""},
      {"G41 D-1", ""},
      {"M-1", "Negative m code used"},
      {"M3.00009", ""},
      {"M4.99991", ""},
      {"M3.00011", "Non integer value for integer"},
      {"M200", "M-code greater than 199: M200"},
      {"M10", "Unknown m code used: M10"},
      {"M98", "Unknown m code used: M98"},
      {"M99999999999", "Negative m code used"},
      {"G0.0001", ""},
      {"G0.9999", ""},
      {"G1.05", "G-code out of range"},
      {"G-.05", "G-code out of range"},
      {"G-1", "Negative g code used"},
      {"G-0", ""},
      {"G100", "G-code out of range"},
      {"G99.9", "Unknown g code used"},
      {"G0.5", "Unknown g code used"},
      {"G214748364.7", "G-code out of range"},
      {"G214748364.8", "Negative g code used"},
      {"G99999999999", "Negative g code used"},
  };
  for (const auto& [text, message] : kTable) {
    INFO(text);
    CHECK(stops(text) == message);
  }
}

TEST_CASE("a line has one code of a group", "[words]") {
  CHECK(stops("G0 G1 X1") == "Two g codes used from same modal group");
  CHECK(stops("G0 G0 X1") == "Two g codes used from same modal group");
  CHECK(stops("G4 G53 P1") == "Two g codes used from same modal group");
  CHECK(stops("G90 G90.1 G92 G92.1 X1").empty());
  CHECK(stops("M3 M4") == "Two m codes used from same modal group");
  CHECK(stops("M7 M8") == "Two m codes used from same modal group");
  CHECK(stops("M3 M19 R0") == "Two m codes used from same modal group");
  CHECK(stops("M100 M150") == "Two m codes used from same modal group");
  CHECK(stops("M3 M7 M48 M6 M100") == "Too many m codes on line");
  CHECK(stops("M3 M7 M48 M6").empty());
  const auto fault = fault_of("X1 G0 G90 G1");
  REQUIRE(fault);
  CHECK(fault->kind == StopKind::kCodesConflict);
  CHECK(fault->word == 3);
  CHECK(fault->other == 1);
}

TEST_CASE("G80 gives way to any other motion", "[words]") {
  CHECK(stops("G0 G80 X1").empty());
  CHECK(stops("G80 G0 X1").empty());
  CHECK(stops("G80 G80").empty());
  CHECK(stops("G80 G0 G80 X1").empty());
  CHECK(stops("G80 G0 G1 X1") == "Two g codes used from same modal group");
  CHECK(behind("G0 G80 X1", kG81) == set_of(kG0));
  CHECK(behind("G80 G1 X1 F1") == set_of(kG1));
}

TEST_CASE("axis words need one code that takes them", "[words]") {
  constexpr auto kNoCode = "Cannot use axis values without a g code that uses them";
  CHECK(stops("X1") == kNoCode);
  CHECK(stops("X1", in(kG0)).empty());
  CHECK(stops("X1", in(Motion::kNone)) == kNoCode);
  CHECK(stops("G90 X1") == kNoCode);
  CHECK(stops("G43 X1") == kNoCode);
  CHECK(stops("G43.1 X1").empty());
  CHECK(stops("G43.2 H1 X1").empty());
  CHECK(stops("G4 P1 X1", in(kG1)).empty());
  CHECK(stops("G28.1 X1") == kNoCode);
  CHECK(stops("G80 X1") == "Cannot use axis values with g80");
  CHECK(stops("G80 G4 P1 X1") == "Cannot use axis values with g80");
  CHECK(stops("G80 @1") == "Cannot use axis values with g80");
  CHECK(stops("G80 G92 X1").empty());
  CHECK(stops("G80 G92 @1") == "Polar coordinates can only be used for motion");
  CHECK(stops("G80 G92") == "All axes missing with g52 or g92");
  CHECK(stops("G80 G10 L2 P1 @1").empty());
  for (const char* const taker : {"G10 L2 P1", "G28", "G30", "G52", "G92"}) {
    INFO(taker);
    CHECK(stops("G0 " + std::string(taker)) == "Cannot use two g codes that both use axis values");
    CHECK(stops("G1 X1 " + std::string(taker)) == "Cannot use two g codes that both use axis values");
    CHECK(stops("X1 " + std::string(taker), in(kG2)).empty());
  }
  CHECK(stops("G0 X1 G28.1").empty());
  CHECK(stops("G0 X1 G92.1").empty());
  for (const char* const free :
       {"G0", "G1", "G2", "G3", "G5.2", "G70", "G71", "G71.1", "G71.2", "G72", "G72.1", "G72.2"}) {
    INFO(free);
    CHECK(stops(free).empty());
  }
  for (const char* const needy : {"G5", "G5.1", "G33", "G33.1", "G38.2", "G38.5", "G73", "G74", "G76", "G81", "G89"}) {
    INFO(needy);
    CHECK(stops(needy) == "All axes missing with motion code");
  }
  CHECK(stops("G52") == "All axes missing with g52 or g92");
  CHECK(stops("G92") == "All axes missing with g52 or g92");
  CHECK(stops("G28").empty());
  CHECK(fault_of("G92")->kind == StopKind::kWordMissing);
  CHECK(fault_of("G80 X1")->kind == StopKind::kAxisWords);
}

TEST_CASE("polar words are for motions in the XY plane", "[words]") {
  constexpr auto kOnlyMotion = "Polar coordinates can only be used for motion";
  constexpr Modes kOther{Motion::kG0, Modes::kAbsolute, Modes::kOtherPlane};
  constexpr Modes kUnknown{Motion::kG0, Modes::kAbsolute, Modes::kPlaneUnknown};
  CHECK(stops("G0 @1 ^2").empty());
  CHECK(stops("G0 @1 Z1").empty());
  CHECK(stops("G0 @1 X1") == "Cannot specify both polar coordinate and X word");
  CHECK(stops("G0 ^1 Y1") == "Cannot specify both polar coordinate and Y word");
  CHECK(stops("G17 G0 @1", kOther) == "Cannot use polar coordinate except in G17 plane");
  CHECK(stops("G18 G0 @1").empty());
  CHECK(stops("G0 @1", kUnknown) == "perhaps: Cannot use polar coordinate except in G17 plane");
  CHECK(stops("G0 @1 X1", kUnknown) == "Cannot specify both polar coordinate and X word");
  CHECK(stops("G0 @1", kStart, {.release = Release::k2_8, .axes = letter_set("xz"), .remapped = {}}) ==
        "Cannot use polar coordinate on a machine lacking X or Y axes");
  CHECK(stops("G92 @1") == kOnlyMotion);
  CHECK(stops("G92 @1 X1") == "Cannot specify both polar coordinate and X word");
  CHECK(stops("G52 @1") == "All axes missing with g52 or g92");
  CHECK(stops("G52 @1 Z1") == kOnlyMotion);
  CHECK(stops("G10 L2 P1 @1") == kOnlyMotion);
  CHECK(stops("G28 @1") == kOnlyMotion);
  CHECK(stops("G43.1 @1") == kOnlyMotion);
  CHECK(stops("@1") == "Cannot use axis values without a g code that uses them");
  CHECK(stops("@1", in(kG0)).empty());
}

TEST_CASE("the motion of a line, and the mode it leaves", "[words]") {
  CHECK(behind("X1", kG1) == set_of(kG1));
  CHECK(behind("G0") == set_of(kG0));
  CHECK(behind("G53 G0 X1", kG81) == set_of(kG0));
  CHECK(behind("I1", kG2) == set_of(kG2));
  CHECK(behind("G43.1 X1") == set_of(Motion::kG80));
  CHECK(behind("G28 X1", kG81) == set_of(kG81));
  CHECK(behind("G80", kG1) == set_of(Motion::kG80));
  CHECK(behind("G80 G92 X1", kG1) == set_of(Motion::kG80));
  CHECK(behind("G38.2 X1") == set_of(Motion::kG38_2));
  CHECK(behind("G5 X1 I0 J0 P1 Q1", kG1) == set_of(kG1));
  CHECK(behind("G5.1 X1 I1 J1", kG1) == set_of(kG1));
  CHECK(behind("G5.2 X1 P1", kG1) == set_of(Motion::kG5_2));
  CHECK(behind("G5.3", Motion::kG5_2) == set_of(Motion::kNone));
  CHECK(behind("G5.3 G90", Motion::kG5_2) == set_of(Motion::kNone));
  CHECK(behind("G71.2 Q100 D1 I1 R1", kG1) == kAnyMotion);

  const auto depends = [](const std::string& text) {
    WordLine line(kAlone);
    read(line, text);
    return line.depends_on_motion();
  };
  CHECK(depends("X1"));
  CHECK(depends("I1"));
  CHECK(depends("G53 X1"));
  CHECK(depends("G43.2 X1"));
  CHECK_FALSE(depends("G0 X1"));
  CHECK_FALSE(depends("G80"));
  CHECK_FALSE(depends("G92 X1"));
  CHECK_FALSE(depends("G43.1 X1"));
  CHECK_FALSE(depends("M3 S100 P1"));
}

TEST_CASE("G4 needs P", "[words]") {
  CHECK(stops("G4") == "Dwell time missing with g4");
  CHECK(stops("G4 P-1") == "Dwell time missing with g4");
  CHECK(stops("G4 P-2").empty());
  CHECK(stops("G4 P?").empty());
  CHECK(stops("G4 P1 G2 X1 I1") == "G4 not allowed with G2 or G3 because they both use P");
  CHECK(stops("G4 P1 X1 I1", in(kG2)).empty());
  CHECK(stops("G4 P.5 I.5", in(kG2)) == "P value not an integer with M19 G2 or G3");
  CHECK(fault_of("G4")->word == 0);
}

TEST_CASE("G10 needs L and P", "[words]") {
  constexpr auto kL = "Line with G10 does not have L0, L1, L10, L11, L2, or L20";
  constexpr auto kWhole = "P value not an integer with G10";
  CHECK(stops("G10") == kL);
  CHECK(stops("G10 L3 P1") == kL);
  CHECK(stops("G10 L? P1").empty());
  CHECK(stops("G10 L0").empty());
  CHECK(stops("G10 L0 P1.4") == kWhole);
  CHECK(stops("G10 L2 P1.0002") == kWhole);
  CHECK(stops("G10 L2 P1.0001").empty());
  CHECK(stops("G10 L2 P1.5").empty());
  CHECK(stops("G10 L2 P-0.3").empty());
  CHECK(stops("G10 L2 P9").empty());
  CHECK(stops("G10 L2 P10") == "P value out of range (0-9) with G10 L2");
  CHECK(stops("G10 L2") == "P value out of range (0-9) with G10 L2");
  CHECK(stops("G10 L20 P-1") == "P value out of range (0-9) with G10 L20");
  CHECK(stops("G10 L2 P0").empty());
  CHECK(stops("G10 L2 P?").empty());
  CHECK(stops("G10 L1 P0") == "P value out of range with G10 L1");
  CHECK(stops("G10 L10") == "P value out of range with G10 L10");
  CHECK(stops("G10 L11 P0.4") == kWhole);
  CHECK(stops("G10 L11 P-5") == "P value out of range with G10 L11");
}

TEST_CASE("G53 needs G0 or G1 and absolute positions", "[words]") {
  constexpr auto kMotion = "Must use g0 or g1 with g53";
  constexpr auto kIncremental = "Cannot use g53 incremental";
  constexpr Modes kG91{Motion::kG0, Modes::kIncremental, Modes::kG17};
  constexpr Modes kUnknown{Motion::kG0, Modes::kDistanceUnknown, Modes::kG17};
  CHECK(stops("G53") == kMotion);
  CHECK(stops("G53", in(kG0)) == kMotion);
  CHECK(stops("G53 X1", in(kG0)).empty());
  CHECK(stops("G53 X1", in(kG81)) == kMotion);
  CHECK(stops("G53 G2 X1 I1") == kMotion);
  CHECK(stops("G53 G0 X1", kG91) == kIncremental);
  CHECK(stops("G53 G0 X1 G90", kG91).empty());
  CHECK(stops("G53 G0 X1 G91") == kIncremental);
  CHECK(stops("G53 G0 X1", kUnknown) == "perhaps: " + std::string(kIncremental));
  CHECK(stops("G53 G0 X1 E1", kUnknown) == "E word with no G70, G76, M66, M67 or M68 to use it");
  CHECK(stops("G53 G0 X1 G90", kUnknown).empty());
  CHECK(stops("G53 G5.2 X1 P1", kG91).empty());
}

TEST_CASE("G5.3 and G6.3 end their blocks", "[words]") {
  constexpr auto kBetween = "Between G5.2 and G5.3 codes, only additional G5.2 codes are allowed.";
  CHECK(stops("G5.3").empty());
  CHECK(stops("G5.3 G1 X1") == kBetween);
  CHECK(stops("G5.3 G80") == kBetween);
  CHECK(stops("G5.3 G5.2 X1 P1").empty());
  CHECK(stops("G6.3") == "Unknown g code used");
  CHECK(stops("G6.3", kStart, kNewest) == "Bug bad g code modal group 0");
  CHECK(stops("G6.3 G6.2 X1 P1", kStart, kNewest).empty());
  CHECK(stops("G53 G6.2 X1 P1", kStart, kNewest).empty());
}

}  // namespace word_line_test
