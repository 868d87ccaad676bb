// What lines stop with for where the machine stands. Each program was run with rs274 2.9.0~pre1, where it is said what is known.
#include <string>

#include <catch2/catch.hpp>

#include "support/mode_lines.h"

using namespace owlint;
using namespace owlint::test;

namespace {

/// The last fault of the last line, with what it depends on; empty if the line runs.
std::string place_stop(const std::string& text, Place place = Place::started(), const MachineWords& machine = kAlone) {
  ModeState state = ModeState::started();
  std::string said;
  for (size_t at = 0; at < text.size() && said.empty();) {
    const size_t end = std::min(text.find(" / ", at), text.size());
    WordLine words(machine);
    REQUIRE_FALSE(read(words, text.substr(at, end - at)));
    std::vector<ModeFault> faults;
    ModeRun(machine, words).run(&state, &faults, &place);
    if (!faults.empty()) {
      const ModeFault& fault = faults.back();
      said = (!fault.fault.certain ? "perhaps: " : fault.from_start ? "from the start: " : "") + fault.fault.message;
    }
    at = end + 3;
  }
  return said;
}

struct PlaceRow {
  std::string program, message;
};

void check_places(std::initializer_list<PlaceRow> rows, const Place& place = Place::started()) {
  for (const PlaceRow& row : rows) {
    INFO(row.program);
    CHECK(place_stop(row.program, place) == row.message);
  }
}

const std::string kFromStart = "from the start: ";
constexpr const char* kDiffers =
    "Radius to end of arc differs from radius to start: start=(X0.0000,Y0.0000) center=(X1.0000,Y0.0000) "
    "end=(X3.0000,Y0.0000) r1=1.0000 r2=2.0000 abs_err=1 rel_err=50.0000%";
constexpr const char* kTooSmall = "Arc radius too small to reach end point";
constexpr const char* kBelow = "R less than z in cycle in xy plane";
constexpr const char* kAtOrigin = "Must specify angle in polar coordinate if at the origin";

}  // namespace

TEST_CASE("an arc is judged from where the machine stands", "[place]") {
  check_places({
      {"F1 G0 X0 Y0 / G2 X3 Y0 I1", kDiffers},
      {"F1 G0 X0 Y0 / G2 X2 Y0 I1", ""},
      {"F1 G0 X0 Y0 / G91 / G2 X3 I1", kDiffers},
      {"F1 G0 X0 Y0 / G90.1 / G2 X3 Y0 I1 J0", kDiffers},
      {"F1 G0 X0 Y0 / G2 X3 R1", kTooSmall},
      {"F1 G0 X0 Y0 / G2 X2 R1", ""},
      {"F1 G0 X1 Y1 / G2 X1 Y1 R1", "Current point same as end point of arc"},
      {"F1 G0 X0 Z0 / G18 G2 Z3 K1",
       "Radius to end of arc differs from radius to start: start=(Z0.0000,X0.0000) center=(Z1.0000,X0.0000) "
       "end=(Z3.0000,X0.0000) r1=1.0000 r2=2.0000 abs_err=1 rel_err=50.0000%"},
      {"F1 G0 X1 Y1 / G90.1 G2 X3 Y1 I1 J1",
       "Zero-radius arc: start=(X1.0000,Y1.0000) center=(X1.0000,Y1.0000) end=(X3.0000,Y1.0000) r1=0.0000 "
       "r2=2.0000"},
  });
}

TEST_CASE("what depends on the start is said to", "[place]") {
  check_places({
      {"F1 / G2 X3 Y0 I1", kFromStart + kDiffers},
      {"F1 / G2 X3 R1", "from the start: Arc radius too small to reach end point"},
      {"F1 G91 / G2 X3 I1", kDiffers},
      {"F1 G91 / G2 X3 R1", kTooSmall},
      {"G0 @1", "from the start: Must specify angle in polar coordinate if at the origin"},
      {"G0 X0 Y0 / G0 @1", kAtOrigin},
      {"F1 G0 X0 Y0 / G55 / G2 X3 Y0 I1", kFromStart + kDiffers},
  });
}

TEST_CASE("from an unknown place only what needs none stops", "[place]") {
  check_places(
      {
          {"F1 G0 X0 / G2 Y3 R1", "perhaps: Arc radius too small to reach end point"},
          {"F1 G0 X0 Y0 / G2 X3 R1", kTooSmall},
          {"F1 G91 / G2 X3 R1", kTooSmall},
          {"F1 G91 / G81 Z1 R1", kBelow},
          {"G0 X0 / G0 @1", "perhaps: Must specify angle in polar coordinate if at the origin"},
          {"G0 X1 / G0 @1", ""},
          {"F1 G0 X0 Y0 / G38.3 Z1 / G2 Y3 R1", "Arc radius too small to reach end point"},
      },
      Place::unknown());
}

TEST_CASE("offsets move the point", "[place]") {
  check_places({
      {"F1 G0 X1 Y0 / G92 X0 / G2 X3 Y0 I1", kDiffers},
      {"F1 G0 X1 Y0 / G52 X1 / G2 X3 Y0 I1", kFromStart + kDiffers},
      {"F1 G0 X1 Y0 / G10 L20 P1 X0 / G2 X3 Y0 I1", kDiffers},
      {"F1 G0 X0 Y0 / G20 / G2 X2 Y0 I1", ""},
      {"F1 G0 X25.4 Y0 / G20 / G2 X3 Y0 I1", ""},
      {"F1 G0 X0 Y0 Z0 / G43.1 Z5 / G2 X3 Y0 I1", kDiffers},
      {"F1 G0 X0 Y0 Z0 / G43.1 X0 / G2 X3 Y0 I1", kFromStart + kDiffers},
  });
}

TEST_CASE("cycles keep their heights", "[place]") {
  check_places({
      {"F1 / G81 X1 Z-1 R1 / X2 Z2", kBelow},
      {"F1 / G81 X1 Z-1 R1 / X2 R-2", kBelow},
      {"F1 G91 / G81 X1 Z-1 R1 / X2 R-2", ""},
      {"F1 G0 Z5 / G91 / G81 X1 Z-1 R1 / G90 X2", ""},
      {"F1 G0 Z5 / G81 X1 Z3 R4 / G18 G81 X1 Y9 R4", "R less than y in cycle in xz plane"},
  });
}

TEST_CASE("probes and threads look at the start", "[place]") {
  check_places({
      {"F1 G0 Z1 / G38.2 Z1", "Start point too close to probe point"},
      {"F1 G0 Z1 / G38.3 Z1", ""},
      {"F1 / G38.2 Z0", "from the start: Start point too close to probe point"},
      {"M3 G0 A1 / G76 P1 Z-1 A2 I1 J1 K2", "Cannot move rotary axes with G76"},
      {"M3 G0 A1 / G76 P1 Z-1 A1 I1 J1 K2", ""},
  });
}

TEST_CASE("rotary axes wrap and index where the INI says so", "[place]") {
  MachineWords machine;
  machine.wrapped = letter_set("a");
  machine.indexing = letter_set("b");
  const auto stop = [&](const char* program) { return place_stop(program, Place::started(), machine); };
  CHECK(stop("G0 A400") == "Invalid absolute position 400.00 for wrapped rotary axis A");
  CHECK(stop("G0 A359.9").empty());
  CHECK(stop("G91 G0 A400").empty());
  CHECK(stop("F1 G1 B1") == "Indexing axis B can only be moved with G0");
  CHECK(stop("G0 B1 X1") == "Indexing axis B can only be moved alone");
  CHECK(stop("G0 B1").empty());
}

TEST_CASE("compensation takes the tool that is in the spindle", "[place]") {
  constexpr Tool kTools[] = {{.number = 1, .diameter = 0.125, .orientation = 0, .has_offset = true},
                             {.number = 4, .diameter = 0.03, .orientation = 2, .has_offset = false}};
  const MachineWords machine{.remapped = {}, .tools = kTools};
  const auto stop = [&](const char* program) { return place_stop(program, Place::started(), machine); };
  const std::string kShort = "Length of cutter compensation entry move is not greater than the tool radius";
  const std::string kLathe = "G41 with lathe tool, but plane is not G18";
  CHECK(stop("T1 / M6 / G0 X0 Y0 / G41 / G0 X1") == kShort);
  CHECK(stop("T1 M6 / G0 X0 Y0 / G41 / G0 X2").empty());
  CHECK(stop("T4 M6 / G41") == kLathe);
  CHECK(stop("T1 M6 / T4 / G41").empty());
  CHECK(stop("T4 M6 / G18 / G41").empty());
  CHECK(stop("T4 M6 / M61 Q1 / G41").empty());
  CHECK(stop("T4 M6 G41").empty());
  CHECK(stop("T4 / G41").empty());
}

TEST_CASE("two places join to what they share", "[place]") {
  Place a = Place::started(), b = a;
  CHECK(join(a, b) == a);
  a.at[Axis::kX] = b.at[Axis::kX] = Coordinate::of(1);
  b.at[Axis::kY] = Coordinate::of(2);
  const Place both = join(a, b);
  CHECK(both.at[Axis::kX].is_known());
  CHECK(both.at[Axis::kY].is_unknown());
  CHECK(join(both, a) == both);
  CHECK(join(Place::unknown(), a) == join(a, Place::unknown()));
  a.loaded_tool = 1;
  CHECK(join(a, a).loaded_tool == 1);
  CHECK(join(a, b).loaded_tool == Place::kUnknownTool);
  CHECK(join(Place::unknown(), Place::unknown()) == Place::unknown());
}
