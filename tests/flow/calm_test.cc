// Very large programs are analysed coarsely, and stretches of lines in which nothing can go wrong are skipped in one
// step. Nothing may be lost by that: on fixtures, on the corpus and on a few thousand damaged copies of both, the findings
// must be those of going line by line.
#include <algorithm>
#include <random>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "rules/driver/lint.h"
#include "support/damage.h"

using namespace owlint;

namespace {

struct Found {
  std::string what;
  Severity severity = Severity::kOff;
  bool operator==(const Found&) const = default;
};

/// What was found, but for words and `reach`: of lines that were passed over only "maybe" is known.
std::vector<Found> findings(const std::string& text, Detail detail) {
  LintOptions options;
  options.detail = detail;
  std::vector<Found> out;
  for (const Finding& f : lint(Source::own("calm.ngc", text), {}, options).findings) {
    out.push_back({fmt::format("{} {}-{} {}", f.code, f.span.begin, f.span.end, f.stops ? "stops" : ""), f.severity});
  }
  return out;
}

/// Paths that meet on a calm line are joined there, and what is known of each is lost: a stop on one of them is no more than a
/// warning. Who passes over the line keeps them apart, and may prove the stop.
bool proves(const Found& coarse, const Found& stepwise) {
  return coarse == stepwise ||
      (coarse.what == stepwise.what && coarse.severity == Severity::kError && stepwise.severity == Severity::kWarning);
}

/// Of names that a list of cases assigns together, all may be missing on joined paths. On paths that are kept apart, the first
/// that is read is missing only where the run ends there, and then the others are not.
void drop_further_names(std::vector<Found>& stepwise, const std::vector<Found>& coarse) {
  const auto is_name = [](const Found& f) { return f.severity == Severity::kInfo && f.what.starts_with("OW603"); };
  if (std::ranges::none_of(coarse, is_name)) return;
  std::erase_if(stepwise, [&](const Found& f) { return is_name(f) && std::ranges::find(coarse, f) == coarse.end(); });
}

void check_alike(const std::string& name, const std::string& text) {
  std::vector<Found> stepwise = findings(text, Detail::kStepwise);
  const std::vector<Found> coarse = findings(text, Detail::kCoarse);
  drop_further_names(stepwise, coarse);
  if (std::ranges::equal(coarse, stepwise, proves)) return;
  const auto lines = [](const std::vector<Found>& all) {
    std::string out;
    for (const Found& f : all) out += fmt::format("{} {}\n", severity_text(f.severity), f.what);
    return out;
  };
  INFO(name << '\n' << text);
  CHECK(lines(coarse) == lines(stepwise));
}

}  // namespace

TEST_CASE("passing over calm lines loses nothing", "[calm]") {
  for (const auto& [name, text] : test::all_programs()) check_alike(name, text);
}

TEST_CASE("passing over calm lines of damaged programs loses nothing", "[calm]") {
  test::for_damaged_programs(20261124, check_alike);
}
