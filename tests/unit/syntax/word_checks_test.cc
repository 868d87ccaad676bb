// Words and the codes that use them, values that are not known, later releases and remaps: each case was run with rs274
// 2.9.0~pre1, or read in a later release.
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "support/word_lines.h"

using namespace owlint;
using namespace owlint::test;

namespace {

constexpr auto kG1 = Motion::kG1;
constexpr auto kG2 = Motion::kG2;
constexpr auto kG81 = Motion::kG81;

}  // namespace

TEST_CASE("a word needs a code that uses it", "[words]") {
  struct Row {
    const char* text;
    Motion motion;
    const char* message;
  };
  constexpr auto kNo80 = Motion::kG80;
  constexpr auto kD = "D word with no G41, G41.1, G42, G42.1, G71, G71.1, G71.2 or G96 to use it";
  constexpr auto kDollar =
      "$ (spindle selection) word with no M3, M4, M5, M19, M51, G33, G33.1, G76, G95, G96 or G97 to use it";
  constexpr auto kE = "E word with no G70, G76, M66, M67 or M68 to use it";
  constexpr auto kH = "H word with no G43 or G76 to use it";
  constexpr auto kI = "I word with no G2, G3, G5, G5.1, G10, G33.1, G76, or G87 to use it";
  constexpr auto kJ = "J word with no G2, G3, G5, G5.1, G10, G76 or G87 to use it";
  constexpr auto kK = "K word with no G2, G3, G33, G33.1, G76, or G87 to use it";
  constexpr auto kL = "L word with no G10, cutter compensation, canned cycle, digital/analog input, M98 or NURBS code";
  constexpr auto kP =
      "P word with no G2 G3 G4 G10 G64 G5 G5.2 G76 G82 G86 G88 G89"
      " or M50 M51 M52 M53 M62 M63 M64 M65 M66 M98 or user M code to use it";
  constexpr auto kQ = "Q word with no G5, G10, G64, G73, G76, G83, M19, M66, M67, M68 or user M code that uses it";
  constexpr auto kR = "R word with no g code that uses it";
  constexpr Row kRows[] = {
      {"G81 X1 A1", kNo80, "Cannot put an a in canned cycle"},
      {"X1 B1", kG81, "Cannot put a b in canned cycle"},
      {"G73 X1 C1", kNo80, "Cannot put a c in canned cycle"},
      {"G76 X1 A1 P1 I1 J1 K1", kNo80, ""},
      {"G92 A1", kG81, ""},
      {"D1", kG1, kD},
      {"G40 D1", kNo80, kD},
      {"G83 X1 D1", kNo80, kD},
      {"G41 D1", kNo80, ""},
      {"G42.1 D1", kNo80, ""},
      {"G96 S1 D1", kNo80, ""},
      {"G70 D1", kNo80, ""},
      {"G72.2 D1", kNo80, ""},
      {"$1", kNo80, kDollar},
      {"G95 $1", kNo80, kDollar},
      {"G97 $1", kNo80, kDollar},
      {"S1 $1", kNo80, ""},
      {"M19 R1 $1", kNo80, ""},
      {"M51 $1", kNo80, ""},
      {"G33 X1 K1 $1", kNo80, ""},
      {"X1 $1", Motion::kG84, kDollar},
      {"E1", kNo80, kE},
      {"G71 E1", kNo80, kE},
      {"G70 E1", kNo80, ""},
      {"M66 E1", kNo80, ""},
      {"H1", kNo80, kH},
      {"G43.1 H1", kNo80, kH},
      {"G49 H1", kNo80, kH},
      {"G43.2 H1", kNo80, ""},
      {"I1", kG1, kI},
      {"I1", kG2, ""},
      {"G33 X1 K1 I1", kNo80, kI},
      {"G33.1 X1 K1 I1", kNo80, ""},
      {"G10 L2 P1 I1 J1", kNo80, ""},
      {"J1", kG1, kJ},
      {"G33.1 X1 K1 J1", kNo80, kJ},
      {"K1", kG1, kK},
      {"G10 L2 P1 K1", kNo80, kK},
      {"G5 X1 K1", kNo80, kK},
      {"L0", kNo80, kL},
      {"G0 X1 L1", kNo80, kL},
      {"G74 X1 L1", kNo80, kL},
      {"X1 L1", kG81, ""},
      {"G41 L1", kNo80, ""},
      {"M66 L1", kNo80, ""},
      {"P1", kNo80, kP},
      {"P-1", kNo80, kP},
      {"P1", kG2, kP},
      {"P1 I1", kG2, ""},
      {"G81 X1 P1", kNo80, kP},
      {"M3 P1", kNo80, kP},
      {"M68 P1", kNo80, kP},
      {"G61 P1", kNo80, kP},
      {"G64 P1", kNo80, ""},
      {"M150 P1 Q1", kNo80, ""},
      {"Q1", kNo80, kQ},
      {"Q0", kNo80, kQ},
      {"Q-1", kNo80, ""},
      {"M62 Q1", kNo80, kQ},
      {"M61 Q1", kNo80, ""},
      {"G83 X1 Q1", kNo80, ""},
      {"R1", kG2, kR},
      {"G1 X1 R1", kNo80, kR},
      {"G41 R1", kNo80, kR},
      {"G64 R1", kNo80, kR},
      {"G70 R1", kNo80, kR},
      {"G41.1 R1", kNo80, ""},
      {"X1 R1", kG2, ""},
      {"F1", kNo80, ""},
      {"S1 T1", kNo80, ""},
  };
  for (const Row& row : kRows) {
    INFO(row.text << " in " << motion_name(row.motion));
    CHECK(stops(row.text, in(row.motion)) == row.message);
  }
}

TEST_CASE("values that a code limits", "[words]") {
  constexpr auto kWhole = "P value not an integer with M19 G2 or G3";
  CHECK(stops("G2 X1 I1 P1.0009").empty());
  CHECK(stops("G2 X1 I1 P1.0011") == kWhole);
  CHECK(stops("G2 X1 I1 P.9991").empty());
  CHECK(stops("M19 R1 P.5") == kWhole);
  CHECK(stops("G2 X1 I1 P99999999999") == kWhole);
  CHECK(stops("M19 R1 P2").empty());
  CHECK(stops("M19 R1 P3") == "P value must be 0,1,or 2 with M19");
  CHECK(stops("M19 R1 P-1") == "P value must be 0,1,or 2 with M19");
  CHECK(stops("G3 X1 I1 P0") == "P value should be 1 or greater with G2 or G3");
  CHECK(stops("G3 X1 I1 P?").empty());
  CHECK(stops("M19 R360").empty());
  CHECK(stops("M19 R360.5") == "R value must be within 0..360 with M19");
  CHECK(stops("M19 R-1") == "R value must be within 0..360 with M19");
}

TEST_CASE("words that a code wants", "[words]") {
  CHECK(stops("G96 D1") == "S word missing with G96");
  CHECK(stops("G33 X1") == "K word missing with g33/g33.1");
  CHECK(stops("X1", in(Motion::kG33_1)) == "K word missing with g33/g33.1");
  CHECK(stops("G33 X1 K1 F1") == "F word used with a g33/g33.1");
  CHECK(stops("G76 X1 I1 J1 K1") == "P word missing with G76");
  CHECK(stops("G76 X1 I1 J1 K1 P-1") == "P word missing with G76");
  CHECK(stops("G76 X1 I1 K1 P1") == "I J or K words missing with G76");
  CHECK(stops("G76 X1 I1 J1 K1 P1").empty());
  CHECK(fault_of("D1 G96")->word == 1);
  CHECK(fault_of("X1", in(Motion::kG33))->word == kNoWord);
}

TEST_CASE("the first error of the first stage wins", "[words]") {
  CHECK(stops("G81 P1 F-1") == "Negative f word used");
  CHECK(stops("G0 G1 F-1") == "Two g codes used from same modal group");
  CHECK(stops("G4 X1") == "Cannot use axis values without a g code that uses them");
  CHECK(stops("M3 M7 M48 M6 M100 G4") == "Dwell time missing with g4");
  CHECK(stops("M3 M7 M48 M6 M100 E1") == "Too many m codes on line");
  CHECK(stops("P1 E1 D1").starts_with("D word"));
  CHECK(stops("R1 P1").starts_with("P word"));
  CHECK(stops("G96 R1").starts_with("R word"));
}

TEST_CASE("values that are not known make faults possible, never other ones", "[words]") {
  CHECK(stops("F? S? T? H? G43 L? M66").empty());
  WordLine line(kAlone);
  const auto twice = read(line, "P? P2 G4");
  REQUIRE(twice);
  CHECK(twice->message == "Multiple p words on one line");
  CHECK_FALSE(twice->certain);
  CHECK_FALSE(line.check(kStart));
  CHECK(stops("Q?").starts_with("perhaps: Q word"));
  CHECK(stops("P?").starts_with("P word"));
  CHECK(stops("X? X1") == "Multiple x words on one line");
  CHECK(stops("G? X1").starts_with("perhaps: "));
  CHECK(stops("G? E1").starts_with("perhaps: E word"));
  CHECK(stops("M? G0 G1") == "Two g codes used from same modal group");
}

TEST_CASE("later releases use more words and have more codes", "[words]") {
  const MachineWords released{.release = Release::k2_9, .axes = letter_set("xyzabc"), .remapped = {}};
  CHECK(stops("G95 $1", kStart, released).empty());
  CHECK(stops("G96 S1 $1", kStart, released).empty());
  CHECK(stops("G6 X1 I1 J1 P1 Q1", kStart, released) == "Unknown g code used");
  const auto newest = [](const std::string& text) { return stops(text, kStart, kNewest); };
  CHECK(newest("G6 X1 I1 J1 P1 Q1").empty());
  CHECK(newest("G6") == "All axes missing with motion code");
  CHECK(newest("G6.1 X1 I1 J1").empty());
  CHECK(newest("G6.2").empty());
  CHECK(newest("G6.2 X1 P1 K1 L1 R1").empty());
  CHECK(newest("G6.1 X1 P1") ==
        "P word with no G2 G3 G4 G10 G64 G5 G5.2 G6, G6.2, G76 G82 G86 G88 G89"
        " or M50 M51 M52 M53 M62 M63 M64 M65 M66 M98 or user M code to use it");
  CHECK(newest("G73 X1 D1").empty());
  CHECK(newest("D1") == "D word with no G41, G41.1, G42, G42.1, G71, G71.1, G71.2 G73, G83 or G96 to use it");
  CHECK(newest("I1") == "I word with no G2, G3, G5, G5.1, G6, G6.1, G10, G33.1, G76, or G87 to use it");
  CHECK(newest("J1") == "J word with no G2, G3, G5, G5.1, G6, G6.1, G10, G76 or G87 to use it");
  CHECK(newest("K1") == "K word with no G2, G3, G6.2, G33, G33.1, G76, or G87 to use it");
  CHECK(newest("Q1") ==
        "Q word with no G5, G6, G10, G64, G73, G76, G83, M19, M66, M67, M68 or user M code that uses it");
  CHECK(newest("G64 R1").empty());
  CHECK(newest("G64 M19 R1") == "R word is ambiguous on a line with both G64 and M19 - use separate lines");
  CHECK(newest("G64 M19 P1").empty());
  CHECK(stops("G64 M19 R1").empty());
}

TEST_CASE("remapped codes pass the checks of other words over", "[words]") {
  constexpr RemappedCode kRemapped[] = {
      {'g', 881, MGroup::kUser}, {'m', 400, MGroup::kUser}, {'m', 6, MGroup::kToolChange}};
  const MachineWords machine{.release = Release::k2_8, .axes = letter_set("xyzabc"), .remapped = kRemapped};
  const auto here = [&](const std::string& text, const Modes& before = kStart) { return stops(text, before, machine); };
  CHECK(here("G88.1 D1 E1").empty());
  CHECK(here("G88.1 X1").empty());
  CHECK(here("M400 P1 L2").empty());
  CHECK(here("M6 L2").empty());
  CHECK(here("M500") == "M-code greater than 199: M500");
  CHECK(here("M400 M100") == "Two m codes used from same modal group");
  CHECK(here("M6 M61 Q1") == "Two m codes used from same modal group");
  CHECK(here("M3 M7 M48 M6 M400") == "Too many m codes on line");
  CHECK(here("M400 X1") == "Cannot use axis values without a g code that uses them");
  CHECK(here("M400 G4") == "Dwell time missing with g4");
  CHECK(here("G88.1 G28") == "Cannot use two g codes that both use axis values");
  CHECK(here("G88.1 G0 X1") == "Two g codes used from same modal group");
  CHECK(here("G80 G88.1") == "Two g codes used from same modal group");
  CHECK(here("G88.1 G80").empty());
  CHECK(stops("G88.1") == "Unknown g code used");
}

TEST_CASE("the table of codes", "[words]") {
  const auto in_release = [](Release release) {
    return std::ranges::count_if(g_codes(), [release](const GCode& code) { return code.since <= release; });
  };
  CHECK(in_release(Release::k2_8) == 88);
  CHECK(in_release(Release::k2_10) == 92);
  for (const GCode& code : g_codes()) {
    CHECK(g_code(code.tenths, Release::k2_10) == &code);
    CHECK_FALSE(code.title.empty());
  }
  for (const MCode& code : m_codes()) CHECK(m_code(code.number) == &code);
  for (const WordRow& row : word_rows()) CHECK(word_row(row.letter) == &row);
  CHECK(m_code(199) == m_code(100));
  CHECK(m_code(200) == nullptr);
  CHECK(m_code(-1) == nullptr);
  CHECK(g_code(-1, Release::k2_10) == nullptr);
  CHECK(g_code(1000, Release::k2_10) == nullptr);
  CHECK(word_row('n') == nullptr);
  CHECK(word_row('o') == nullptr);
  CHECK(word_row('%') == nullptr);
  CHECK(g_name(51) == "G5.1");
  CHECK(m_name(3) == "M3");
  CHECK(motion_name(Motion::kG38_2) == "G38.2");
  CHECK(motion_name(Motion::kNone) == "no motion");

  WordLine line(kAlone);
  REQUIRE_FALSE(read(line, "G1 X1 M150 P2"));
  CHECK(line.is_user_m());
  CHECK(line.size() == 4);
  CHECK(line[3].letter == 'p');
  CHECK(line.find('p') == 3);
  CHECK(line.find('q') == kNoWord);
  CHECK(line.code(GGroup::kMotion) == g_code(code::kG1, Release::k2_8));
  CHECK(line.word_of(MGroup::kUser) == 2);
  CHECK(line.has_axis_words());
  CHECK_FALSE(line.has_polar_words());
}
