// Why no run gets to a line: the reason that the text report gives.
#include <catch2/catch.hpp>

#include "rules/driver/lint.h"

using namespace owlint;

namespace {

/// The reason for a mistake on a line: `o9 endrepeat` behind other lines, which no run reaches.
std::string reason(const std::string& before, const std::string& after = "M2\n") {
  const std::string program = before + "o9 endrepeat\n" + after;
  LintOptions options;
  options.select = {"OW108"};  // it would be a part of OW316
  const FileReport report = lint(Source::own("p.ngc", program), Profile{}, options);
  for (const Finding& f : report.findings) {
    if (f.code != "OW108" || f.span.begin != before.size()) continue;
    REQUIRE(f.reach == Reach::kNever);
    REQUIRE(f.path.size() == 1);
    return f.path[0].message;
  }
  return "no finding";
}

}  // namespace

TEST_CASE("a line that no run gets to has its reason", "[unreached]") {
  CHECK(reason("G21\no1 if\n") == "the program stops at line 2 first");
  CHECK(reason("M2\n") == "the program ends at line 1 first");
  CHECK(reason("o1 if [0]\n", "o1 endif\nM2\n") == "`o1 if` on line 1 is never true");
  CHECK(reason("o1 repeat [0]\n", "o1 endrepeat\nM2\n") == "`o1 repeat` on line 1 never runs a pass");
  CHECK(reason("o1 if [1]\nG0 X[1]\no1 else\n", "o1 endif\nM2\n") == "every run skips `o1 else` on line 3");
  CHECK(reason("o1 while [1]\no1 break\n", "o1 endwhile\nM2\n") == "no run gets past line 2");
  CHECK(reason("o<s> sub\n", "o<s> endsub\nM2\n") == "nothing in this file calls `o<s>`");
}

TEST_CASE("what stops in a called sub keeps runs from the lines after the call", "[unreached]") {
  CHECK(reason("o<s> sub\no1 if\no<s> endsub\no<s> call\n") == "the program stops at line 2 first");
  CHECK(reason("o<s> sub\n", "o<s> endsub\no1 if\no<s> call\nM2\n") == "the program stops at line 4 first");
}

TEST_CASE("a stop behind a line is not its reason", "[unreached]") {
  CHECK(reason("o1 while [1]\no1 break\n", "o1 endwhile\no2 if\nM2\n") == "no run gets past line 2");
  CHECK(reason("#1 = [#5220 * 2]\no1 if [#1 GT 2]\no2 if\no1 else\no3 if\no1 endif\n") == "no run gets past line 5");
}
