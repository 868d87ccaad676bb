// Tool tables as LinuxCNC's own reader has them. Measured for each case.
#include "analyzer/machine/tool_table.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace owlint;

namespace {

/// The numbers that are found, in the order of their places.
std::vector<int32_t> numbers(std::string_view bytes, ToolChanger changer = ToolChanger::kFixed) {
  std::vector<int32_t> out;
  for (const ToolRow& row : read_tool_table(bytes, changer).rows) out.push_back(row.number);
  return out;
}

ToolRow only(std::string_view bytes) {
  const ToolTable table = read_tool_table(bytes);
  REQUIRE(table.rows.size() == 1);
  return table.rows[0];
}

using Numbers = std::vector<int32_t>;

}  // namespace

TEST_CASE("a line of a tool table is one tool", "[tool-table]") {
  const std::string_view bytes = "; tools\r\n\n  T3 P12 D6.5 Z41 Q2 ;end mill\r\nt4 p13 z0 x-0\n";
  const ToolTable table = read_tool_table(bytes);
  REQUIRE(table.rows.size() == 2);
  const ToolRow& first = table.rows[0];
  CHECK(first.number == 3);
  CHECK(first.pocket == 12);
  CHECK(first.diameter == 6.5);
  CHECK(first.orientation == 2);
  CHECK(first.has_offset);
  CHECK(first.offset[2] == 41);
  CHECK(first.line == 3);
  CHECK(bytes.substr(first.span.begin, first.span.end - first.span.begin) == "T3 P12 D6.5 Z41 Q2");
  const ToolRow& second = table.rows[1];
  CHECK(second.diameter == 0);
  CHECK_FALSE(second.has_offset);
  CHECK(second.line == 4);
  CHECK(bytes.substr(second.span.begin) == "t4 p13 z0 x-0\n");
  CHECK(table.find(4) == &second);
  CHECK(table.find(5) == nullptr);
  CHECK(numbers("").empty());
}

TEST_CASE("a line with a word that is none is skipped", "[tool-table]") {
  for (const char* bad : {"T1 P1 R5", "T1 P1 #c", "T1 P1 (c)", "T1 P1 Z", "T1 P1 D 5", "T P1", "T1 P", "T1 P1 Zx",
                          "T1 P1 \r", "1 1 0.5", "T1 P1 /"}) {
    INFO(bad);
    CHECK(numbers(std::string(bad) + "\nT2 P2\n") == Numbers{2});
  }
  CHECK(numbers("T1 P1 ;#c\n T2 P2;c\n;T3 P3\n ;T4 P4") == Numbers{1, 2});
  CHECK(numbers("T") == Numbers{});
}

TEST_CASE("only blanks separate words of a tool table", "[tool-table]") {
  const ToolRow row = only("T1\tP1\tZ10\n");
  CHECK(row.number == 1);
  CHECK_FALSE(row.has_offset);
  CHECK(only("T\t2 P\v3\n").pocket == 3);
}

TEST_CASE("numbers of a tool table end where they end", "[tool-table]") {
  CHECK(only("T2.7 P1x\n").number == 2);
  CHECK(only("T007 P1\n").number == 7);
  CHECK(only("T+4 P1\n").number == 4);
  CHECK(numbers("T0x10 P1\n").empty());  // 0: the empty spindle
  CHECK(only("T4294967299 P1\n").number == 3);
  CHECK(numbers("T99999999999999999999 P1\nT-99999999999999999999 P1\n").empty());
  CHECK(only("T1 P1 Q5.5\n").orientation == 5);

  CHECK(only("T1 P1 D1,5\n").diameter == 1);
  CHECK(only("T1 P1 D-.5e1x\n").diameter == -5);
  CHECK(only("T1 P1 D+5.\n").diameter == 5);
  CHECK(only("T1 P1 D1e\n").diameter == 1);
  CHECK(only("T1 P1 D0x1p3\n").diameter == 8);
  CHECK(only("T1 P1 D0x.\n").diameter == 0);
  CHECK(std::isinf(only("T1 P1 D1e999\n").diameter));
  CHECK(only("T1 P1 D1e-999\n").diameter == 0);
  CHECK(std::isinf(only("T1 P1 DInfinity\n").diameter));
  CHECK(std::isnan(only("T1 P1 Dnan(\n").diameter));
  for (const char* bad : {"", "+", "-", ".", "..1", ".e5", "e5", "+-1", "--1", "0x", "0xp1", "0xg", "infi", "na"}) {
    INFO(bad);
    CHECK(numbers(std::string("T1 P1 D") + bad + "\n").empty());
  }
  CHECK_FALSE(only("T1 P1 X5 X0\n").has_offset);
  for (const char* axis : {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"})
    CHECK(only(std::string("T1 P1 ") + axis + "-0.001\n").has_offset);
  CHECK_FALSE(only("T1 P1 D3 I95 J155 Q1\n").has_offset);
}

TEST_CASE("the first line of a tool counts", "[tool-table]") {
  CHECK(only("T1 P1 D1\nT1 P2 D2\n").diameter == 1);
  CHECK(numbers("T3 P9\nT1 P2\nT2 P9\n") == Numbers{3, 1, 2});
}

TEST_CASE("a line without P is the spindle's", "[tool-table]") {
  CHECK(numbers("T1 Z10\nT2 Z20\nT3 P3\n") == Numbers{3, 2});
  CHECK(only("T1 D1\nT1 P1 D2\nT1 D3\n").diameter == 2);
  CHECK(numbers("T1\nZ5\n").empty());
  CHECK(numbers("T1\n  \n").empty());  // a line of blanks is one without T and P
  CHECK(numbers("T1\n\n;\n ;\nx;\nZ5 X\n ") == Numbers{1});
}

TEST_CASE("a tool table has 1000 places", "[tool-table]") {
  std::string bytes;
  for (int i = 1; i <= 998; ++i) bytes += "T" + std::to_string(i) + " P1\n";
  bytes += "T2000 P1 X\n";  // skipped, but it has taken a place
  bytes += "T2001 P1\nT2002 P1\nT2003\n";
  const Numbers found = numbers(bytes);
  CHECK(found.size() == 1000);
  CHECK(found[998] == 2001);
  CHECK(found[999] == 2003);
  CHECK(numbers("T1 P1 P2\nT2 P1\n") == Numbers{1, 2});
}

TEST_CASE("long lines of a tool table are cut", "[tool-table]") {
  const std::string comment = "T1 P1 ;" + std::string(248, 'c');
  CHECK(numbers(comment + "\nT2 P2\n") == Numbers{1, 2});
  const ToolTable table = read_tool_table(comment + "T5 P5\nT2 P2\n");
  REQUIRE(table.rows.size() == 3);
  CHECK(table.rows[1].number == 5);
  CHECK(table.rows[1].line == 1);
  CHECK(table.rows[2].line == 2);
  using namespace std::string_view_literals;
  CHECK(numbers("T1\0 P1\nT2 P2\n"sv) == Numbers{2, 1});
}

TEST_CASE("P is the place in a random changer", "[tool-table]") {
  constexpr auto kRandom = ToolChanger::kRandom;
  CHECK(numbers("T1 P5\nT2 P3\nT1 P7\n", kRandom) == Numbers{2, 1});
  CHECK(numbers("T1 P1\nT2 P1\n", kRandom) == Numbers{2});
  CHECK(numbers("T1 P1\nT2 P1 X\n", kRandom) == Numbers{1});
  CHECK(numbers("T1 P1001\nT2 P-1\nT3 P1000\n", kRandom) == Numbers{3});
  CHECK(numbers("T4 P0\nT0 P2\n", kRandom) == Numbers{0, 4});
  CHECK(numbers("T1 P1\nP1 Z3\n", kRandom).empty());
}
