// Very large programs are analysed coarsely, and stretches of lines in which nothing can go wrong are passed over in one
// step. Nothing may be lost by that: on fixtures, on the corpus and on a few thousand damaged copies of both, the findings
// must be those of going line by line.
#include <random>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "rules/lint.h"
#include "support/corpus.h"
#include "support/files.h"
#include "support/fixture.h"

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

std::vector<std::pair<std::string, std::string>> programs() {
  std::vector<std::pair<std::string, std::string>> out;
  for (const test::CorpusProgram& c : test::corpus()) out.emplace_back(c.path, test::read_file(c.path));
  for (const test::Fixture& f : test::all_fixtures()) {
    if (!f.bundle) out.emplace_back(f.path, test::read_file(f.path));
  }
  return out;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t at = 0; at < text.size();) {
    const size_t feed = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, feed + 1 - at));
    at = feed + 1;
  }
  return lines;
}

/// A few lines deleted, doubled, moved.
std::string damaged(std::vector<std::string> lines, std::mt19937& random) {
  const auto below = [&](size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random); };
  for (size_t edits = 1 + below(3); edits > 0 && lines.size() > 2; --edits) {
    const size_t at = below(lines.size());
    const std::string line = lines[at];
    const size_t kind = below(3);
    if (kind != 1) lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at));
    if (kind != 0) lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size())), line);
  }
  std::string out;
  for (const std::string& line : lines) out += line;
  return out;
}

}  // namespace

TEST_CASE("passing over calm lines loses nothing", "[calm]") {
  for (const auto& [name, text] : programs()) check_alike(name, text);
}

TEST_CASE("passing over calm lines of damaged programs loses nothing", "[calm]") {
  std::mt19937 random(20261124);
  const auto all = programs();
  for (int i = 0; i < 4000; ++i) {
    const auto& [name, text] = all[std::uniform_int_distribution<size_t>(0, all.size() - 1)(random)];
    check_alike(name, damaged(lines_of(text), random));
  }
}
