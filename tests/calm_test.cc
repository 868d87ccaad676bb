// Very large programs are analysed coarsely, and stretches of lines in which nothing can go wrong are skipped in one
// step. Nothing may be lost by that: on fixtures, on the corpus and on a few thousand damaged copies of both, the findings
// must be those of going line by line.
#include <random>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "rules/driver/lint.h"
#include "support/damage.h"

using namespace owlint;

namespace {

/// What was found, but for words and `reach`: of lines that were passed over only "maybe" is known.
std::string findings(const std::string& text, Detail detail) {
  LintOptions options;
  options.detail = detail;
  std::string out;
  for (const Finding& f : lint(Source::own("calm.ngc", text), {}, options).findings) {
    out += fmt::format("{} {}-{} {} {}\n", f.code, f.span.begin, f.span.end, severity_text(f.severity), f.stops ? "stops" : "");
  }
  return out;
}

void check_alike(const std::string& name, const std::string& text) {
  const std::string stepwise = findings(text, Detail::kStepwise);
  const std::string coarse = findings(text, Detail::kCoarse);
  if (stepwise == coarse) return;
  INFO(name << '\n' << text);
  CHECK(coarse == stepwise);
}

}  // namespace

TEST_CASE("passing over calm lines loses nothing", "[calm]") {
  for (const auto& [name, text] : test::all_programs()) check_alike(name, text);
}

TEST_CASE("passing over calm lines of damaged programs loses nothing", "[calm]") {
  std::mt19937 random(20261124);
  const auto all = test::all_programs();
  for (int i = 0; i < 4000; ++i) {
    const auto& [name, text] = all[std::uniform_int_distribution<size_t>(0, all.size() - 1)(random)];
    check_alike(name, test::damaged(text, random));
  }
}
