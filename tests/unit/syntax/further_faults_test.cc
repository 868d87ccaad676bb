// The mistakes of a line behind the one with which it stops.
#include <sstream>

#include <catch2/catch.hpp>

#include "analyzer/syntax/further_faults.h"
#include "support/files.h"

using namespace owlint;

namespace {

/// The mistakes of a line, as the table has them.
std::vector<std::string> mistakes(const std::string& line) {
  const std::shared_ptr<const Source> source = Source::own("line.ngc", line + "\n");
  const Syntax syntax = scan(*source);
  REQUIRE(syntax.statements.size() == 1);
  const LineError* first = syntax.error(syntax.statements[0]);
  REQUIRE(first != nullptr);
  std::vector<std::string> out{std::to_string(first->span.begin) + ": " + first->message};
  for (const LineError& error : further_faults(line, 0, *first, {}, true)) {
    CHECK(error.other.end <= error.span.begin);
    out.push_back(std::to_string(error.span.begin) + ":" + std::string(source->slice(error.span)) + ": " +
                  error.message);
  }
  return out;
}

}  // namespace

TEST_CASE("all mistakes on a line are found, and none that the first explains", "[syntax]") {
  std::istringstream table(test::read_file(test::repository("tests/unit/syntax/further_faults.tsv")));
  size_t several = 0;
  for (std::string row; std::getline(table, row);) {
    if (row.starts_with("#")) continue;
    std::istringstream cells(row);
    std::string line;
    std::getline(cells, line, '\t');
    std::vector<std::string> wanted;
    for (std::string cell; std::getline(cells, cell, '\t');) wanted.push_back(cell);
    REQUIRE(!wanted.empty());
    // The parser may say of the first only where it begins.
    wanted[0].erase(wanted[0].find(':'), wanted[0].find(": ") - wanted[0].find(':'));
    INFO(row);
    CHECK(mistakes(line) == wanted);
    several += wanted.size() > 1 ? 1 : 0;
  }
  CHECK(several > 15);
}

TEST_CASE("on an unknown machine a code may be known, but in a program that is not expected", "[syntax]") {
  const std::string line = "G1 X1 X2 G12 M17 M420 U5";
  const LineError first{StopKind::kWordRepeated, {6, 7}, "Multiple x words on one line", {3, 5}, kNoExpr, 0, 0};
  MachineWords unsure;
  unsure.unsure = true;
  CHECK(further_faults(line, 0, first, unsure, true).size() == 2);
  CHECK(further_faults(line, 0, first, unsure, false).empty());
  CHECK(further_faults(line, 0, first, {}, false).size() == 3);
}

TEST_CASE("the mistakes of a line are where the line is in its file", "[syntax]") {
  const LineError first{StopKind::kWordRepeated, {1006, 1007}, "Multiple x words on one line", {}, kNoExpr, 0, 0};
  const std::vector<LineError> more = further_faults("G0 X1 x2 y1 (two) y 2", 1000, first, {}, true);
  REQUIRE(more.size() == 1);
  CHECK(more[0].span == Span{1018, 1021});
  CHECK(more[0].other == Span{1009, 1011});
}
