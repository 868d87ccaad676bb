// Lines of plain motion are not stored, and hardly read; and large programs are read as usual ones first. What is found must not
// depend on it: the fixtures, the corpus and some thousand damaged copies of both are checked again with each line read by the
// parser, and as if they were large. Of large programs only errors that stop are compared: some warnings go by which lines the
// flow is asked about.
#include <random>
#include <utility>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "analyzer/program/program.h"
#include "analyzer/syntax/bulk.h"
#include "rules/driver/lint.h"
#include "support/damage.h"

using namespace owlint;

namespace {

struct EachLine {
  EachLine() { no_line_is_plain = true; }
  ~EachLine() { no_line_is_plain = false; }
};

struct AllAreLarge {
  size_t before = std::exchange(large_program, 0);
  ~AllAreLarge() { large_program = before; }
};

std::string findings(const std::string& text, bool errors_alone = false) {
  std::string out;
  for (const Finding& f : lint(Source::own("plain.ngc", text), {}, {}).findings) {
    if (errors_alone && (!f.stops || f.severity != Severity::kError)) continue;
    out += fmt::format("{} {}-{} {} {}\n", f.code, f.span.begin, f.span.end, f.stops ? "stops" : "",
                       severity_text(f.severity));
  }
  return out;
}

void check_read_alike(const std::string& name, const std::string& text) {
  const auto compare = [&](const std::string& expected, const std::string& found) {
    if (found == expected) return;
    INFO(name << '\n' << text);
    CHECK(found == expected);
  };
  const std::string fast = findings(text), errors = findings(text, true);
  {
    const AllAreLarge large;
    compare(errors, findings(text, true));
  }
  const EachLine each_line;
  compare(fast, findings(text));
}

}  // namespace

TEST_CASE("lines of plain motion are passed without a loss", "[bulk]") {
  for (const auto& [name, text] : test::all_programs()) check_read_alike(name, text);
}

TEST_CASE("lines of plain motion in damaged programs are passed without a loss", "[bulk]") {
  test::for_damaged_programs(20261129, check_read_alike);
}
