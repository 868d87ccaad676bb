// Which lines are surely good ones.
#include <sstream>

#include <catch2/catch.hpp>

#include "analyzer/syntax/known_line.h"
#include "support/files.h"

using namespace owlint;

TEST_CASE("lines that surely run are told from doubtful ones", "[syntax]") {
  std::istringstream table(test::read_file(test::repository("tests/unit/syntax/known_lines.tsv")));
  size_t asked = 0;
  for (std::string row; std::getline(table, row);) {
    if (row.starts_with("#")) continue;
    const size_t tab = row.find('\t');
    REQUIRE(tab != std::string::npos);
    INFO(row);
    CHECK(surely_runs(row.substr(tab + 1)) == (row.substr(0, tab) != "doubt"));
    ++asked;
  }
  CHECK(asked > 90);
}

TEST_CASE("a line longer than LinuxCNC reads does not surely run", "[syntax]") {
  CHECK(surely_runs("G0 X1 ;" + std::string(245, 'x')));
  CHECK_FALSE(surely_runs("G0 X1 ;" + std::string(246, 'x')));
}
