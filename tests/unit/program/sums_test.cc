// How far lines go in G91 is only summed up in large programs if G91 may be in effect.
#include <catch2/catch.hpp>

#include "analyzer/program/program.h"

using namespace owlint;

namespace {

/// Behind an O-word, so that the lines do not say what the distance mode is.
std::string large(const std::string& head) {
  std::string text = head + "o1 if [#1]\nG1 X0 F100\no1 endif\n";
  while (text.size() < (2 << 20)) text += "X0.125 Y-0.5\n";
  return text + "X7 Y1\no2 if [#2]\no2 endif\nM2\n";
}

std::unique_ptr<Program> read(const std::string& text) { return build_program(Source::own("large.ngc", text)); }

const PlaceChange& longest(const Program& program) {
  return *std::ranges::max_element(program.syntax.place_changes, {}, [](const PlaceChange& c) { return -c.sum[1]; });
}

}  // namespace

TEST_CASE("sums of large programs are left out where nothing sets G91", "[program]") {
  const auto program = read(large("G90\n"));
  CHECK(program->syntax.lacks_sums);
  CHECK(program->syntax.place_changes.back().last[0] == 7);
}

TEST_CASE("sums of large programs are there where something may set G91", "[program]") {
  for (const char* head : {"o3 if [#3]\nG91\no3 endif\n", "o3 if [#3]\nG[90+#4]\no3 endif\n", "o<other> call\n"}) {
    INFO(head);
    const auto program = read(large(head));
    CHECK_FALSE(program->syntax.lacks_sums);
    const Syntax all = scan(*program->source);
    REQUIRE(program->syntax.place_changes.size() == all.place_changes.size());
    CHECK(longest(*program).sum ==
          std::ranges::max_element(all.place_changes, {}, [](const PlaceChange& c) { return -c.sum[1]; })->sum);
    CHECK(longest(*program).sum[1] < -50'000);
  }
}
