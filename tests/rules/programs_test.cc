// Every fixture says what owlint finds in it. With OWLINT_UPDATE=1 the expectations are rewritten instead.
#include <algorithm>
#include <set>

#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include "support/files.h"
#include "support/fixture.h"

using namespace owlint::test;

TEST_CASE("fixtures meet their expectations", "[programs][fixtures]") {
  if (updating()) {
    if (const size_t count = update_fixtures(); count > 0)
      WARN(count << " fixtures rewritten: read the difference before you keep it");
    return;
  }
  const auto& [fixtures, findings] = checked_fixtures();
  REQUIRE(fixtures.size() > 400);
  for (size_t i = 0; i < fixtures.size(); ++i) {
    const std::vector<std::string> found = expectations(findings[i]);
    const bool same = std::ranges::equal(fixtures[i].expected, found, meets);
    INFO(fmt::format("{}\nexpected:\n  {}\nfound:\n  {}\n", fixtures[i].path, fmt::join(fixtures[i].expected, "\n  "),
                     fmt::join(found, "\n  ")));
    CHECK(same);
  }
}

TEST_CASE("fixtures ask a question each and name the places exactly", "[programs]") {
  if (updating()) return;
  std::set<std::string> questions;
  for (const Fixture& fixture : all_fixtures()) {
    INFO(fixture.path);
    CHECK(fixture.asks.ends_with('?'));
    CHECK(questions.insert(fixture.asks).second);
    CHECK_FALSE(fixture.expected.empty());
    for (const std::string& line : fixture.expected) CHECK((line == "nothing" || line.find('-') != std::string::npos));
  }
}

TEST_CASE("expectations without columns are met by any columns", "[programs]") {
  CHECK(meets("OW104 7 error always stops", "OW104 7:1-7:8 error always stops"));
  CHECK(meets("OW104 7:1-7:8 error always stops", "OW104 7:1-7:8 error always stops"));
  CHECK_FALSE(meets("OW104 7:1-7:9 error always stops", "OW104 7:1-7:8 error always stops"));
  CHECK_FALSE(meets("OW104 8 error always stops", "OW104 7:1-7:8 error always stops"));
  CHECK_FALSE(meets("nothing", "OW104 7:1-7:8 error always stops"));
}

TEST_CASE("rewriting a fixture changes only its expectations", "[programs]") {
  const Scratch scratch;
  Fixture fixture;
  fixture.path = fixture.lines_in =
      scratch.write("p.ngc", "G0 X\xE4\r\n; expect: nothing\r\n; expect: OW301 1 error always stops\r\nM2\r");
  rewrite(fixture, {"OW101 4:1-4:2 error always stops"});
  CHECK(read_file(fixture.path) == "G0 X\xE4\r\n; expect: OW101 4:1-4:2 error always stops\r\nM2\r");
  fixture.lines_in = scratch.write("p.expect", "asks: what?\nexpect: nothing");
  rewrite(fixture, {"a", "b"});
  CHECK(read_file(fixture.lines_in) == "asks: what?\nexpect: a\nexpect: b");
}
