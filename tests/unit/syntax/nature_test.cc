// Files that are no LinuxCNC programs: what tells them.
#include <string>

#include <catch2/catch.hpp>

#include "analyzer/syntax/controllers.h"

using namespace owlint;

namespace {

std::string_view controller(const std::string& program) { return nature_of(program).controller; }

}  // namespace

TEST_CASE("every mark fits its example", "[nature]") {
  for (const Mark& mark : marks()) {
    INFO(mark.controller << ": " << mark.pattern << " | " << mark.example);
    std::string_view line = mark.example;
    while (line[0] >= '0' && line[0] <= '9' && mark.controller == "Heidenhain") line.remove_prefix(1);
    CHECK(fits(line, mark.pattern));
    CHECK_FALSE(fits("G0 X10 Y20", mark.pattern));
    CHECK_FALSE(fits("o100 if [#1 EQ 2]", mark.pattern));
    CHECK_FALSE(fits("(" + std::string(line), mark.pattern));
  }
}

TEST_CASE("a pattern ends with its line", "[nature]") {
  CHECK(fits("M 82", "M82"));
  CHECK(fits("m82 (absolute)", "M82"));
  CHECK(fits("M82 ; absolute", "M82"));
  CHECK_FALSE(fits("M820", "M82"));
  CHECK(fits("G1 X1 E-0.5", "G1+E@*"));
  CHECK_FALSE(fits("G1 X1 (SIZE 5)", "G1+E@*"));
  CHECK_FALSE(fits("G1 X[EXP[1]]", "G1+E@*"));
  CHECK_FALSE(fits("G1 X#<e1>", "G1+E@*"));
  CHECK_FALSE(fits("", "M82"));
}

TEST_CASE("one mark that may be a slip of the pen is not enough", "[nature]") {
  CHECK(controller("IF [#1 EQ 2] GOTO 20\nGOTO 30\nN20 G0 X1\nM30\n").empty());
  CHECK(controller("IF [#1 EQ 2] GOTO 20\nWHILE [#1 LT 2] DO1\nEND1\nN20 M30\n") == "Fanuc macro B");
  CHECK(controller("o100 sub\no100 endsub\nIF [#1 EQ 2] GOTO 20\nWHILE [#1 LT 2] DO1\n").empty());
  CHECK(controller("G65 P9010\n#3000=1\nM30\n").empty());
  CHECK(controller("M82\nM83\n").empty());
  CHECK(controller("M82\nG92 E0\n") == "a 3D printer");
  CHECK(controller("M104 S200\nG1 X1 E2\n") == "a 3D printer");
  CHECK(controller("M104 S200\nM106 S100\n").empty());
}

TEST_CASE("a comment names a controller only together with a code of its own", "[nature]") {
  CHECK(controller("(for Mach3)\nG31 Z-1\n") == "Mach3");
  CHECK(controller("(for mach4)\nG31 Z-1\n") == "Mach4");
  CHECK(controller("G31 Z-1\n").empty());
  CHECK(controller("(for Mach3, now LinuxCNC)\nG31 Z-1\n").empty());
  CHECK(controller("(for Mach3)\nG0 Z-1\n").empty());
  CHECK(controller("#<mach3> = 1\nG31 Z-1\n").empty());
}

TEST_CASE("a file that is no text is told from a damaged one", "[nature]") {
  const std::string program = "G21 G90\nG0 X10\nG0 Y10\nM2\n";
  CHECK(nature_of(program).kind == Nature::kProgram);
  CHECK(nature_of("").kind == Nature::kProgram);
  CHECK(nature_of(program + std::string(5000, '\0')).kind == Nature::kProgram);
  CHECK(nature_of("G21 G90\nG0 X\0 10\nG0 Y\x01 10\nM2\n").kind == Nature::kProgram);
  CHECK(nature_of("\xFF\xFEG\0").kind == Nature::kUtf16);
  std::string wide;
  for (const char c : program) wide += std::string{c, '\0'};
  CHECK(nature_of(wide).kind == Nature::kUtf16);
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += static_cast<char>(i * i * 7);
  CHECK(nature_of(bytes).kind == Nature::kNoText);
  CHECK(nature_of("(Bohrung \xFC"
                  "ber Kante, Gr\xF6\xDF"
                  "e 10)\nM2\n")
            .kind == Nature::kProgram);
}
