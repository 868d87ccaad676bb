// The lines that a run comes to behind a line.
#include <catch2/catch.hpp>

#include "rules/driver/lines_behind.h"

using namespace owlint;
using namespace owlint::rules;

namespace lines_behind_test {
namespace {

/// The numbers of the lines behind the first of a program.
std::vector<uint32_t> behind(const std::string& text, uint32_t line = 1) {
  const auto program = build_program(Source::own("p.ngc", text));
  std::vector<uint32_t> lines;
  for (LinesBehind at(*program, line); at.next();) lines.push_back(at.line());
  return lines;
}

using Lines = std::vector<uint32_t>;

}  // namespace

TEST_CASE("blank lines, comments and lines with block delete are passed over", "[rules]") {
  CHECK(behind("G0 X1\n\n(here)\n/G0 X2\nG0 X3\n#1 = 2\n") == Lines{5, 6});
}

TEST_CASE("a call is the last line, and so is the end of the sub or the program", "[rules]") {
  CHECK(behind("G0 X1\nG0 X2\no<f> call\nG0 X3\n") == Lines{2, 3});
  CHECK(behind("G0 X1\nM2\nG0 X3\n") == Lines{2});
  CHECK(behind("o<f> sub\nG0 X1\nG0 X2\no<f> endsub\nG0 X3\n", 2) == Lines{3, 4});
  CHECK(behind("G0 X1\no<f> sub\nG0 X2\no<f> endsub\n") == Lines{2});
}

TEST_CASE("the other branches of an if do not run", "[rules]") {
  CHECK(behind("o1 if [#1]\nG0 X1\no1 else\nG0 X2\no1 endif\nG0 X3\n", 2) == Lines{6});
  CHECK(behind("G0 X1\no1 if [#1]\nG0 X2\no1 else\nG0 X3\no1 endif\n") == Lines{2, 3, 4, 5, 6});
}

TEST_CASE("a return in a branch ends only some runs", "[rules]") {
  CHECK(behind("o<f> sub\nG0 X1\no1 if [#1]\no<f> return\no1 endif\nG0 X2\no<f> endsub\n", 2) == Lines{3, 4, 5, 6, 7});
  CHECK(behind("o<f> sub\nG0 X1\no<f> return\nG0 X2\no<f> endsub\n", 2) == Lines{3});
}

TEST_CASE("no line far away is reached", "[rules]") {
  std::string text = "G0 X1\n";
  for (int i = 0; i < 1000; ++i) text += "#1 = 2\n";
  CHECK(behind(text).size() == 200);
}

}  // namespace lines_behind_test
