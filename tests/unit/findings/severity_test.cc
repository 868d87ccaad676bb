// How bad a finding is, and which rules are on.
#include <catch2/catch.hpp>

#include "analyzer/findings/severity.h"
#include "rules/driver/lint.h"

using namespace owlint;

namespace {

struct Case {
  bool stops = false;
  bool unproven = false;
  bool never_ends = false;
  Severity level = Severity::kError;
  bool abort_list = false;
  bool warn_only = false;
};

Severity decide(const Case& c, const std::map<std::string, Severity, std::less<>>& overrides = {}) {
  Finding f;
  f.code = "OW104";
  f.stops = c.stops;
  f.unproven = c.unproven;
  f.never_ends = c.never_ends;
  return decide_severity(f, c.level, c.abort_list, {c.warn_only, overrides, {}});
}

std::vector<std::string> codes(const std::string& program, const LintOptions& options) {
  std::vector<std::string> out;
  for (const Finding& f : lint(Source::own("p.ngc", program), Profile{}, options).findings) out.emplace_back(f.code);
  return out;
}

}  // namespace

TEST_CASE("a stop is an error and a mistake that runs a warning", "[severity]") {
  CHECK(decide({.stops = true}) == Severity::kError);
  CHECK(decide({.stops = false}) == Severity::kWarning);
  CHECK(decide({.never_ends = true}) == Severity::kError);
  CHECK(decide({.stops = true, .level = Severity::kWarning}) == Severity::kError);
  CHECK(decide({.level = Severity::kWarning}) == Severity::kWarning);
  CHECK(decide({.level = Severity::kInfo}) == Severity::kInfo);
  CHECK(decide({.stops = true, .unproven = true}) == Severity::kWarning);
}

TEST_CASE("FEATURE 0x20 softens the abort list unless the interpreter stops all the same", "[severity]") {
  CHECK(decide({.abort_list = true, .warn_only = true}) == Severity::kWarning);
  CHECK(decide({.stops = true, .abort_list = true, .warn_only = true}) == Severity::kError);
  CHECK(decide({.stops = true, .abort_list = false, .warn_only = true}) == Severity::kError);
  CHECK(decide({.never_ends = true, .warn_only = true}) == Severity::kError);
}

TEST_CASE("the longest override that fits decides", "[severity]") {
  CHECK(decide({.stops = true}, {{"OW104", Severity::kInfo}}) == Severity::kInfo);
  CHECK(decide({.stops = true}, {{"OW1", Severity::kOff}}) == Severity::kOff);
  CHECK(decide({.stops = true}, {{"OW1", Severity::kOff}, {"OW104", Severity::kWarning}}) == Severity::kWarning);
  CHECK(decide({.stops = true}, {{"OW10", Severity::kWarning}, {"OW", Severity::kOff}}) == Severity::kWarning);
  CHECK(decide({.stops = true}, {{"OW2", Severity::kOff}}) == Severity::kError);
}

TEST_CASE("severities have names", "[severity]") {
  for (const Severity s : {Severity::kOff, Severity::kInfo, Severity::kWarning, Severity::kError}) {
    Severity again{};
    CHECK(severity_from_text(severity_text(s), &again));
    CHECK(again == s);
  }
  Severity none{};
  CHECK_FALSE(severity_from_text("fatal", &none));
  CHECK_FALSE(severity_from_text("", &none));
  CHECK_FALSE(severity_from_text("errors", &none));
}

TEST_CASE("which rules are wanted", "[severity]") {
  // an OW104, an OW304, and OW310 if it is selected
  const std::string program = "o1 if [1] (yes)\no1 endif\no1 if [1]\no1 endif\nM2\n";
  CHECK(codes(program, {}) == std::vector<std::string>{"OW104"});
  CHECK(codes(program, {.select = {"OW3"}}) == std::vector<std::string>{"OW310"});
  CHECK(codes(program, {.extend_select = {"OW310"}}) == std::vector<std::string>{"OW310", "OW104"});
  CHECK(codes(program, {.select = {"OW"}, .ignore = {"OW3"}}) == std::vector<std::string>{"OW104"});
  CHECK(codes(program, {.ignore = {"OW104"}}).empty());
  CHECK(codes(program, {.select = {"OW104"}, .ignore = {"OW1"}}) == std::vector<std::string>{"OW104"});
  CHECK(codes(program, {.severity = {{"OW104", Severity::kOff}}}).empty());
}

TEST_CASE("rules are found by code and name and nearly so", "[severity]") {
  REQUIRE(find_rule("ow104") != nullptr);
  CHECK(find_rule("OW104") == find_rule("if-label-reused"));
  CHECK(find_rule("OW1") == nullptr);
  CHECK(known_prefix("OW1"));
  CHECK(known_prefix("OW104"));
  CHECK_FALSE(known_prefix("OW99"));
  CHECK(nearest_rule("if-label-resued") == "if-label-reused");
  CHECK(nearest_rule("OW1O4") == "OW104");
  CHECK(nearest_rule("completely-different").empty());
}
