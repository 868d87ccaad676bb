// What lines need of the modes, and refuse. Each program was run with rs274 2.9.0~pre1, where no other release is named.
#include <string>

#include <catch2/catch.hpp>

#include "support/mode_lines.h"

using namespace owlint;
using namespace owlint::test;

namespace {

constexpr Tool kTools[] = {{.number = 1, .diameter = 3, .orientation = 0, .has_offset = true},
                           {.number = 4, .diameter = 0, .orientation = 2, .has_offset = false}};
const MachineWords kWithTools{.remapped = {}, .tools = kTools};

}  // namespace

TEST_CASE("a move needs a feed", "[modes]") {
  constexpr Row kRows[] = {
      {"G1 X1", "Cannot do g1 with zero feed rate"},
      {"G1", "Cannot do g1 with zero feed rate"},
      {"G1 X1 F1", ""},
      {"F100 / G94 / G1 X1", "Cannot do g1 with zero feed rate"},
      {"F100 / G94 F1 / G1 X1", ""},
      {"F100 / G20 / G1 X1", ""},
      {"F0 / X1 G3 I1", "Cannot make arc with zero feed rate"},
      {"G5.1 X1 Y1 I1 J1", "Cannot make arc with zero feed rate"},
      {"G5.2 X1 Y1 P1", "Cannot make a NURBS with 0 feedrate"},
      {"G95 / G5.2 X1 Y1 P1", ""},
      {"G38.2 X1", "Cannot probe with zero feed rate"},
      {"G81 X1 Z-1 R1", "Cannot feed with zero feed rate"},
      {"F1 / G95 / G1 X1", "Cannot do g1 with zero feed rate"},
      {"G95 F1 / G1 X1", "Cannot feed with zero spindle speed in feed per rev mode"},
      {"G95 F1 M3 / G1 X1", "Cannot feed with zero spindle speed in feed per rev mode"},
      {"G95 F1 S1 / G1 X1", ""},
      {"G93 F1 / G1 X1", "F word missing with inverse time g1 move"},
      {"G93 / G1 X1 F0 / G2 X2 I1", "F word missing with inverse time arc move"},
      {"G93 / G1 X1 F0 / G38.2 X9", ""},
      {"G93 / G0 X1 F1 / G38.2 X1", "Cannot probe with zero feed rate"},
      {"F1 / G93 / G81 X1 Z-1 R1", "Cannot use inverse time feed with canned cycles"},
      {"G95 F1 / G38.2 X1", "Cannot probe with feed per rev mode"},
      {"G33 Z1 K1 M3 / Z2 K1", ""},
      {"G0 X1 / G1 Z1 F1 / X2", ""},
      {"G1 F1 / G94 / X1", "Cannot do g1 with zero feed rate"},
  };
  check(kRows);
}

TEST_CASE("a thread and a tapping cycle need a spindle that turns", "[modes]") {
  constexpr Row kRows[] = {
      {"G33 Z1 K1", "Spindle not turning in G33"},
      {"M3 / M5 / G33.1 Z1 K1", "Spindle not turning in G33.1"},
      {"M3 / M6 / G33 Z1 K1", "Spindle not turning in G33"},
      {"M3 / M19 R1 / G33 Z1 K1", "Spindle not turning in G33"},
      {"M4 S0 / G33 Z1 K1", ""},
      {"G76 Z1 P1 I1 J1 K2", "Chosen spindle (0) not turning in G76"},
      {"F1 / G84 Z-1 R1", "Spindle not turning in G84"},
      {"F1 M3 / G74 Z-1 R1", "Spindle turning clockwise in G74"},
      {"F1 M4 / G84 Z-1 R1", "Spindle turning counterclockwise in G84"},
      {"F1 M4 / G74 Z-1 R1", ""},
      {"F1 / G86 Z-1 R1 P1", "Spindle not turning in g86"},
  };
  check(kRows);
}

TEST_CASE("a spindle number is one of the machine's", "[modes]") {
  constexpr Row kRows[] = {
      {"M3 $1", "Spindle ($) number out of range in M3 Command"},
      {"M3 $-1", ""},
      {"M3 $0.9", ""},
      {"S1 $-2", "Invalid spindle ($) number in Spindle speed command"},
      {"G96 S1 $-1", "Invalid spindle ($) number in Spindle Mode command"},
      {"G95 S1 $-1", "Invalid spindle ($) number in Spindle Feed command"},
      {"M19 R1 $1", "Spindle ($) number out of range in M19 Command"},
      {"M19 R1 Q-1", "Q word with M19 requires a value > 0"},
      {"M51 $0", "Invalid spindle ($) number in M51 command"},
      {"M3 / G76 Z1 P1 I1 J1 K2 $1", "Invalid D-number in G76 cycle"},
  };
  check(kRows);

  Interpreter several{.machine = {.remapped = {}, .spindles = 2}};
  CHECK(several.program("M3 $1 / S1 $1") == "");
  CHECK(several.doubts("G33 Z1 K1") == "certain: Spindle not turning in G33");
  CHECK(several.program("M51 $1 / M5") == "");
  CHECK(several.doubts("G33 Z1 K1") == "certain: Spindle not turning in G33");
  CHECK(several.doubts("G33 Z1 K1 $1") == "Spindle not turning in G33");
  Interpreter unsure{.machine = {.remapped = {}, .unsure = true}};
  CHECK(unsure.doubts("M3 $1") == "believed: Spindle ($) number out of range in M3 Command");
  CHECK(unsure.doubts("M3 $-2") == "certain: Spindle ($) number out of range in M3 Command");
}

TEST_CASE("compensation on and off", "[modes]") {
  constexpr Row kRows[] = {
      {"G19 / G41 D0", "Cutter radius compensation allowed only in XY, XZ planes"},
      {"G41 D0 / G42 D0", "Cannot turn cutter radius comp on when on"},
      {"G41.1", "G41.1 with no D word"},
      {"G42.1 D1 L2", "G42.1 with L word, but plane is not G18"},
      {"G18 / G42.1 D1 L2", ""},
      {"G41 D1.5", "G41 requires D word to be a whole number"},
      {"G42 D-1", "G42 requires D word to be a whole number"},
      {"G41.1 D1 / G0 X10 / G40 / G2 X9 I5 F1",
       "The move just after exiting cutter compensation mode must be straight, not an arc"},
      {"F1 / G41.1 D1 / G0 X10 / G40 / G1 X20 / G2 X20 I5", ""},
      {"F1 / G41.1 D0 / G0 X10 / G40 / G2 X10 I5", ""},
      {"F1 / G41.1 D1 / G40 / G2 X0 I5", ""},
      {"G41.1 D1 / G17.1 / G0 X10", "BUG: Invalid plane for cutter compensation"},
      {"G41.1 D0 / G17.1 / G0 X10", ""},
      {"G41.1 D1 / G53 G0 X10", "Cannot use g53 with cutter radius comp"},
      {"G41.1 D0 / G53 G0 X10", ""},
      {"G53 G0 @1 ^1", "Cannot use polar coordinates with G53"},
      {"G41.1 D0 / G33 Z1 K1", "Spindle not turning in G33"},
      {"G41.1 D1 / G0 X10 / G33 X20 K1", ""},
  };
  check(kRows);
}

TEST_CASE("what compensation refuses", "[modes]") {
  constexpr Row kRows[] = {
      {"G18", "Cannot change planes with cutter radius compensation on"},
      {"G17", ""},
      {"G43", "Cannot change tool offset with cutter radius compensation on"},
      {"G54", "Cannot change coordinate systems with cutter radius compensation on"},
      {"G64", "Cannot change control mode with cutter radius compensation on"},
      {"G99", "Cannot change retract mode with cutter radius compensation on"},
      {"G10 L2 P1 X1", "Cannot change the active coordinate system with cutter radius compensation on"},
      {"G10 L20 P0 X1", "Cannot change the active coordinate system with cutter radius compensation on"},
      {"G10 L2 P2 X1", ""},
      {"G28", "Cannot use g28 or g30 with cutter radius comp"},
      {"G30.1", "Cannot set reference point with cutter compensation in effect"},
      {"G92 X1", "Cannot change axis offsets with cutter radius comp"},
      {"G92.1", ""},
      {"G38.3 X1", "Cannot probe with cutter radius comp on"},
      {"G5.1 X1 Y1 I1 J1", "Cannot convert spline with cutter radius compensation"},
      {"G81 X1 Z-1 R1 F1", "Cannot use canned cycles with cutter compensation on"},
      {"G76 Z1 P1 I1 J1 K2 M3", "Cannot use G76 threading cycle with cutter radius compensation on"},
      {"G71 Q1", "G71.0 cannot be used with cutter compensation enabled"},
      {"M6", "Cannot change tools with cutter radius compensation on"},
      {"M61 Q0", ""},
      {"M48", "Cannot enable overrides with cutter radius compensation on"},
      {"M49", "Cannot disable overrides with cutter radius compensation on"},
      {"M53 P0", "Cannot disable overrides with cutter radius compensation on"},
      {"M62 P1", "Cannot set motion output with cutter radius compensation on"},
      {"M63", "Cannot set motion digital output with cutter radius compensation on"},
      {"M64 P1", "Cannot set auxiliary digital output with cutter radius compensation on"},
      {"M66 P1", "Cannot wait for digital input with cutter radius compensation on"},
      {"M66 E1", "Cannot wait for analog input with cutter radius compensation on"},
      {"M67 E1 Q1", "Cannot set motion analog output with cutter radius compensation on"},
      {"M68 E1 Q1", "Cannot set auxiliary analog output with cutter radius compensation on"},
  };
  for (const Row& row : kRows) {
    INFO(row.program);
    CHECK(stop_of("G41.1 D0 / " + std::string(row.program)) == row.message);
  }
  Interpreter on;
  REQUIRE(on.line("G41.1 D0"));
  CHECK_FALSE(read_position(&on.state, &on.faults));
  CHECK(on.faults.back().fault.kind == StopKind::kCompensation);
}

TEST_CASE("planes", "[modes]") {
  constexpr Row kRows[] = {
      {"F1 / G17.1 / G2 X1 I1", "Cannot do an arc in planes G17.1, G18.1, or G19.1"},
      {"F1 / G18 / G5.1 X1 Y1 I1 J1", "Splines must be in the XY plane"},
      {"G70 Q1", "G70.0 can only be used in XZ plane (G18)"},
      {"G71.1", "G7x.x  requires a Q word"},
      {"F1 / G17.1 / G81 X1 Z1 R1", "Cannot put an X in a canned cycle in the UV plane"},
      {"F1 / G19.1 / G81 Y1 R1", "Cannot put a Y in a canned cycle in the VW plane"},
      {"F1 / G18.1 / G81 A1", "Cannot put an a in canned cycle"},
      {"G18 / G0 @1 ^1", "Cannot use polar coordinate except in G17 plane"},
      {"G18 G0 @1 ^1", ""},
      {"G18 / G17 G0 @1 ^1", "Cannot use polar coordinate except in G17 plane"},
      {"G91 / G53 G0 X1", "Cannot use g53 incremental"},
      {"G91 / G90 G53 G0 X1", ""},
  };
  check(kRows);
}

TEST_CASE("words of arcs, cycles and threads", "[modes]") {
  constexpr Row kRows[] = {
      {"G2 X1", "R i j k words all missing for arc"},
      {"G2 X1 R1 I1", "Mixed radius ijk format for arc"},
      {"F1 / G2 X1 K1", "K word given for arc in xy plane"},
      {"F1 / G18 / G2 X1 J1", "J word given for arc in xz plane"},
      {"F1 / G90.1 / G2 X1 I1", "J word missing in absolute center arc"},
      {"F1 G90.1 G19 G3 Z1 J1", "K word missing in absolute center arc"},
      {"F1 / G2 Z1 R1", "X and y words missing for arc in xy plane"},
      {"F1 / G81 X1 Z-1", "R clearance plane unspecified in cycle"},
      {"F1 / G81 X1 Z-1 R1 / X2", ""},
      {"F1 / G81 X1 Z-1 R1 / G82 X1 P1", "R clearance plane unspecified in cycle"},
      {"F1 / G81 X1 Z-1 R1 / G81 X2 L0", "Cannot do zero repeats of cycle"},
      {"F1 / G81 X1 R1", "Z value unspecified in xy plane canned cycle"},
      {"F1 / G18 / G81 X1 Z1 R1", "Y value unspecified in xz plane canned cycle"},
      {"F1 / G82 Z-1 R1 P-1", "Dwell time p word missing with g82"},
      {"F1 / G83 Z-1 R1", "Q word missing with g83"},
      {"F1 / G73 Z-1 R1 Q0", "Negative or zero q value used"},
      {"F1 / G83 Z-1 R1 Q1 / X1 / G80 / G83 X1 Z-1 R1", "Q word missing with g83"},
      {"F1 M3 / G87 Z-1 R1 I1 K1", "J word missing with g87"},
      {"M3 / G76 Z1 P1 I0 J1 K2", "In G76, I must not be 0"},
      {"M3 / G76 Z1 P1 I1 J0 K2", "In G76, J must be greater than 0"},
      {"M3 / G76 Z1 P1 I1 J1 K1", "In G76, K must be greater than J"},
  };
  check(kRows);
}

TEST_CASE("splines and NURBS", "[modes]") {
  constexpr Row kRows[] = {
      {"F1 / G5.1 X1 Z1 I1 J1", "Splines may not have motion in Z, A, B, or C"},
      {"F1 / G5.1 X1 I1", "Must specify both I and J with G5.1"},
      {"F1 / G5 X1 I1 P1 Q1", "Must specify both I and J, or neither"},
      {"F1 / G5 X1 P1", "Must specify both P and Q with G5"},
      {"F1 / G5 X1 P-1 Q-1", ""},
      {"F1 / G5 X1 P1 Q1 / X2", "Cannot use axis values without a g code that uses them"},
      {"F1 / G5.2 X1 P1", "You must specify both X and Y coordinates for Control Points"},
      {"F1 / G5.2 P1 / G5.2 P1", "Can specify P without X and Y only for the first control point"},
      {"F1 / G5.2 / G5.2 X1 Y1", "Must specify positive weight P for every Control Point"},
      {"F1 / G5.2 X1 Y1 P1 / G5.3", "You must specify a number of control points at least equal to the order L = 3"},
      {"F1 / G5.2 X1 Y1 P1 / X2 Y1 P1 / G5.3", ""},
      {"F1 / G5.2 X1 Y1 P1 L4 / X2 Y1 P1 / G5.3",
       "You must specify a number of control points at least equal to the order L = 4"},
      {"F1 / G5.2 X1 Y1 P1 / X2 Y1 P1 / G5.3 / G5.3", "Cannot use G5.3 without G5.2 first"},
      {"F1 / G5.2 X1 Y1 P1 / G0 X5 / G5.2 X1 Y1", "Must specify positive weight P for every Control Point"},
      {"F1 / G5.2 X1 Y1 P1 / X2 Y1 P1 / G5.3 X3 Y3 P1 / X4 Y4 P1 / G5.3", ""},
  };
  check(kRows);

  constexpr Row kNewer[] = {
      {"F1 / G18 / G5.1 X1 Z1 I1 J1", ""},
      {"F1 / G5.1 X1 B1 I1 J1", "Splines may not have motion in A, B, or C"},
      {"F1 / G6.1 X1 I1", "Must specify both I and J with G5.1 or G6.1"},
      {"F1 / G18 / G5.2 X1 P1", "You must specify both X and Z coordinates for Control Points"},
      {"F1 / G5.2 X1 Y1 P1 / M0 / G5.2 X1 Y1", ""},
  };
  check(kNewer, kNewest);
}

TEST_CASE("G10, inputs and outputs, tools", "[modes]") {
  constexpr Row kRows[] = {
      {"G10 L2 P1 J1", "I J words not allowed with G10 L2"},
      {"G10 L20 P1 R1", "R not allowed in G10 L20"},
      {"G10 L1 P1", "G10 L1 without offsets has no effect"},
      {"G10 L1 P1 Q1.5", "Q number in G10 is not an integer"},
      {"G10 L11 P1 Q10", "Invalid tool orientation"},
      {"G10 L1 P1 Q-1", ""},
      {"M62 Q-1", "No valid P word with M62"},
      {"M65 P-1", ""},
      {"M66 P1 E1", "Invalid to select both a digital and an analog input with M66"},
      {"M66 P1 L1 Q0", "Zero timeout with wait type != immediate return"},
      {"M66 E1 L1 Q1", "Can't select analog input with wait type != immediate return"},
      {"M66 P-0.6", "Need to have either a valid P or a valid E word with M66"},
      {"M67 Q1", "Invalid analog index with M67"},
      {"M68 E-0.4 Q1", ""},
      {"M61 Q-0.6", "Need non-negative Q-word to specify tool number with M61"},
      {"M61", "Need non-negative Q-word to specify tool number with M61"},
      {"G43.2", "G43.2: No axes specified and H word missing"},
      {"G43.2 X1 H1", "G43.2: Can not have both H and axis words"},
      {"G43.2 X1", "Requested tool -1 not found in the tool table"},
      {"G43 H-1", "Requested tool -1 not found in the tool table"},
  };
  check(kRows);
  CHECK(stop_of("G43.2 X1", kNewest).empty());

  CHECK(stop_of("T7").empty());
  CHECK(stop_of("T7", kWithTools) == "Requested tool 7 not found in the tool table");
  CHECK(stop_of("T0 / M61 Q4 / G43 H1 / G10 L1 P1 X1", kWithTools).empty());
  CHECK(stop_of("M61 Q2", kWithTools) == "Requested tool 2 not found in the tool table");
  CHECK(stop_of("G41 D2", kWithTools) == "Requested tool 2 not found in the tool table");
  CHECK(stop_of("G42 D4", kWithTools) == "G42 with lathe tool, but plane is not G18");
  CHECK(stop_of("G41 D1 / G53 G0 X1", kWithTools) == "Cannot use g53 with cutter radius comp");
  CHECK(stop_of("G18 / G41 D4 / G53 G0 X1", kWithTools).empty());
  CHECK(Interpreter{}.doubts("G41 D1").empty());
}
