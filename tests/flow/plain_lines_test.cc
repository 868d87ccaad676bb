// Lines of plain motion are not stored, and hardly read. What is found must not depend on it: the fixtures, the corpus and some
// thousand damaged copies of both are checked a second time with each line read by the parser.
#include <random>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "analyzer/syntax/bulk.h"
#include "rules/driver/lint.h"
#include "support/damage.h"

using namespace owlint;

namespace {

struct EachLine {
  EachLine() { no_line_is_plain = true; }
  ~EachLine() { no_line_is_plain = false; }
};

std::string findings(const std::string& text) {
  std::string out;
  for (const Finding& f : lint(Source::own("plain.ngc", text), {}, {}).findings) {
    out += fmt::format("{} {}-{} {} {}\n", f.code, f.span.begin, f.span.end, f.stops ? "stops" : "",
                       severity_text(f.severity));
  }
  return out;
}

void check_alike(const std::string& name, const std::string& text) {
  const std::string fast = findings(text);
  const EachLine each_line;
  const std::string by_parser = findings(text);
  if (fast == by_parser) return;
  INFO(name << '\n' << text);
  CHECK(fast == by_parser);
}

}  // namespace

TEST_CASE("lines of plain motion are passed without a loss", "[bulk]") {
  for (const auto& [name, text] : test::all_programs()) check_alike(name, text);
}

TEST_CASE("lines of plain motion in damaged programs are passed without a loss", "[bulk]") {
  std::mt19937 random(20261129);
  const auto all = test::all_programs();
  for (int i = 0; i < 4000; ++i) {
    const auto& [name, text] = all[std::uniform_int_distribution<size_t>(0, all.size() - 1)(random)];
    check_alike(name, test::damaged(text, random));
  }
}
