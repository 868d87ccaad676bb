// Modes that are saved and restored, and modes of which several values may be in effect. Each program was run with rs274
// 2.9.0~pre1, where no other release is named.
#include <string>

#include <catch2/catch.hpp>

#include "support/mode_lines.h"

using namespace owlint;
using namespace owlint::test;

TEST_CASE("M72 takes back what M70 has saved", "[modes]") {
  constexpr Row kRows[] = {
      {"M72", "Cannot restore context from invalid stack frame - missing M70/M73?"},
      {"M70 / M71 / M72", "Cannot restore context from invalid stack frame - missing M70/M73?"},
      {"M70 / M72 / M72", ""},
      {"F0.04 / M70 / F1 / M72 / G1 X1", "Cannot do g1 with zero feed rate"},
      {"F1 / M70 / F0 / M72 / G1 X1", ""},
      {"S0.5 / M70 / S1 / M72 / G95 F1 / G1 X1", "Cannot feed with zero spindle speed in feed per rev mode"},
      {"F1 M70 / G55 / M72 G81 X1 Z1 R1 L0 / G1 X1", ""},
      {"M3 / M70 / M5 / M72 / G33 Z1 K1", ""},
      {"G17 / M70 / G18 / M72 / G0 @1 ^1", ""},
      {"M70 / G41.1 D0 / M72 / G41.1 D0", ""},
      {"G41.1 D0 / M70 / G40 / M72 / G41.1 D0", "Cannot turn cutter radius comp on when on"},
      {"G96 S100 / M70 / G97 S50 / M72", ""},
      {"G41.1 D0 / M70 / G40 / G55 / M72",
       "M7x: restore_settings failed executing: ' G41 G54': "
       "Cannot change coordinate systems with cutter radius compensation on"},
      {"G41.1 D0 / M70 / G40 / G61 / M72",
       "M7x: restore_settings failed executing: ' G41 G64 P0.000000 Q0.000000': "
       "Cannot change control mode with cutter radius compensation on"},
      {"G18 / M70 / G17 / G41.1 D0 / M72",
       "M7x: restore_settings failed executing: ' G18 G40': Cannot change planes with cutter radius compensation on"},
      {"M70 / M49 / G41.1 D0 / M72",
       "M7x: restore_settings failed executing: ' G40M48': Cannot enable overrides with cutter radius compensation on"},
      {"M49 / M70 / M48 / G41.1 D0 / M72",
       "M7x: restore_settings failed executing: ' G40M51': Cannot enable overrides with cutter radius compensation on"},
      {"M3 / M70 / M5 / M49 / G41.1 D0 / M72", ""},
      {"G41.1 D0 / M3 / M70 / G40 / M5 / M49 / M72",
       "M7x: restore_settings failed executing: 'M48': Cannot enable overrides with cutter radius compensation on"},
      {"G41.1 D0 / M70 / G40 / G42.1 D0 / M72",
       "M7x: restore_settings failed executing: ' G41': Cannot turn cutter radius comp on when on"},
  };
  check(kRows);

  // A feed or speed that has not changed is not written again.
  Interpreter same;
  REQUIRE(same.program("G96 S100 / M70 / G97").empty());
  CHECK(same.doubts("M72") == "certain: M7x: restore_settings failed executing: ' G96': S word missing with G96");
  Interpreter feed;
  REQUIRE(feed.program("F1 / M70 / G93 / M72").empty());
  CHECK(feed.doubts("G1 X1") == "certain: Cannot do g1 with zero feed rate");

  // Since 2.10 a path mode of G64 is always restored.
  CHECK(stop_of("G41.1 D0 / M70 / G40 / M72", kNewest) ==
        "M7x: restore_settings failed executing: ' F0.0 S0 G41 G64 P0.000000 Q0.000000': "
        "Cannot change control mode with cutter radius compensation on");
}

TEST_CASE("the end of a sub takes back what M73 has saved", "[modes]") {
  const auto leave = [](const std::string& text) {
    Interpreter sub;
    REQUIRE(sub.program(text).empty());
    const bool runs = restore_modes(sub.machine, &sub.state, &sub.faults);
    return runs ? value_name(Mode::kDistance, sub.state.now[Mode::kDistance] == 1 ? 0 : 1)
                : sub.faults.back().fault.message;
  };
  CHECK(leave("M73 / G91") == "G90");
  CHECK(leave("M70 / G91") == "G91");
  CHECK(leave("M73 / M71 / G91") == "G91");
  CHECK(leave("G41.1 D0 / M73 / G40 / G55") ==
        "M7x: restore_settings failed executing: ' G41 G54': "
        "Cannot change coordinate systems with cutter radius compensation on");

  Interpreter perhaps = either("M73 / G91", "G91");
  REQUIRE(restore_modes(perhaps.machine, &perhaps.state, &perhaps.faults));
  CHECK(perhaps.state.now[Mode::kDistance] == (value_bit(modes::kG90) | value_bit(modes::kG91)));
  CHECK(perhaps.state.now.is_open(Mode::kDistance));
}

TEST_CASE("where modes have several values, a fault is possible, and the runs that go on have good ones", "[modes]") {
  Interpreter feed = either("F1", "");
  CHECK(feed.doubts("G1 X1") == "believed: Cannot do g1 with zero feed rate");
  CHECK(feed.faults[0].decided_by == (mask_of(Mode::kFeed) | mask_of(Mode::kFeedMode)));
  CHECK(feed.faults[0].fault.word == 0);
  CHECK(feed.doubts("X2").empty());

  // Two modes decide: they may be bad on different runs.
  Interpreter two = either("F1 S1", "G95");
  CHECK(two.doubts("G1 X1") ==
        "Cannot do g1 with zero feed rate; Cannot feed with zero spindle speed in feed per rev mode");

  // What has ended may have been the only run with a value of another mode.
  Interpreter ended = either("F1", "M3");
  CHECK(ended.doubts("G1 X1") == "believed: Cannot do g1 with zero feed rate");
  CHECK(ended.doubts("G33 Z1 K1") == "Spindle not turning in G33");

  Interpreter motion = either("F1 / G1 X1", "F1 / G81 X1 Z-1 R1");
  CHECK(motion.doubts("R1 X2") == "believed: R word with no g code that uses it");
  CHECK(motion.faults[0].decided_by == mask_of(Mode::kMotion));
  CHECK(motion.doubts("X3 F0") == "certain: Cannot feed with zero feed rate");

  Interpreter none = either("G0 X1", "");
  CHECK(none.doubts("X1") == "believed: Cannot use axis values without a g code that uses them");
  CHECK(none.doubts("X1").empty());

  Interpreter plane = either("G0 X1", "G0 X1 / G18");
  CHECK(plane.doubts("@1 ^1") == "believed: Cannot use polar coordinate except in G17 plane");
  CHECK(plane.state.now[Mode::kPlane] == value_bit(modes::kG17));
  Interpreter distance = either("G91", "");
  CHECK(distance.doubts("G53 G0 X1") == "believed: Cannot use g53 incremental");
  CHECK(distance.state.now[Mode::kDistance] == value_bit(modes::kG90));
}

TEST_CASE("an unknown interpreter is believed of nothing", "[modes]") {
  Interpreter unknown{.state = ModeState::unknown()};
  CHECK(unknown.doubts("G1 X1 F1") ==
        "Cannot feed with zero spindle speed in feed per rev mode; "
        "BUG: Invalid plane for cutter compensation");
  CHECK(unknown.doubts("G18") == "Cannot change planes with cutter radius compensation on");
  CHECK(unknown.doubts("G54") == "Cannot change coordinate systems with cutter radius compensation on");
  CHECK(unknown.state.now[Mode::kCompensation] == value_bit(modes::kG40));
  CHECK(unknown.doubts("G41.1 D0").empty());
  CHECK(unknown.doubts("G40 G17").starts_with("certain: Cannot change planes"));
  CHECK(unknown.doubts("G2 X1") == "certain: R i j k words all missing for arc");
}

TEST_CASE("values and codes that are not known", "[modes]") {
  Interpreter values;
  CHECK(values.doubts("F? S?").empty());
  CHECK(values.doubts("G1 X1") == "Cannot do g1 with zero feed rate");
  CHECK(values.doubts("M3 $?").empty());
  CHECK(values.doubts("G41.1 D?").empty());
  CHECK(values.doubts("M50 P?") == "Cannot enable overrides with cutter radius compensation on");
  CHECK(values.doubts("G10 L2 P?") == "Cannot change the active coordinate system with cutter radius compensation on");
  CHECK(values.doubts("G53 G0 X?") == "Cannot use g53 with cutter radius comp");

  Interpreter code;
  CHECK(code.doubts("G? X1") == "Cannot use axis values without a g code that uses them");
  CHECK(code.state == ModeState::unknown());

  constexpr RemappedCode kRemapped[] = {{'g', 881, MGroup::kUser}, {'m', 400, MGroup::kUser}};
  Interpreter remapped{.machine = {.remapped = kRemapped}};
  CHECK(remapped.doubts("G88.1 X1").empty());
  CHECK(remapped.state == ModeState::unknown());
  remapped.state = ModeState::started();
  CHECK(remapped.doubts("M400 P1").empty());
  CHECK(remapped.state == ModeState::unknown());
}

TEST_CASE("modes and values have names", "[modes]") {
  CHECK(mode_name(Mode::kFeedMode) == "feed mode");
  CHECK(value_name(Mode::kFeedMode, modes::kG93) == "G93");
  CHECK(value_name(Mode::kMotion, static_cast<uint8_t>(Motion::kG81)) == "G81");
  CHECK(value_name(Mode::kNurbsOrder, modes::kOrder3) == "3");
  CHECK(value_name(Mode::kNurbs, 2) == "2");
  CHECK(all_values(Mode::kPlane) == 0x3f);
  CHECK((all_values(Mode::kMotion) & set_of(Motion::kG5)) == 0);
}
