// Bytes, lines, columns.
#include <catch2/catch.hpp>

#include "analyzer/report/report.h"
#include "analyzer/text/source.h"
#include "support/files.h"

using namespace owlint;

namespace {

std::shared_ptr<const Source> own(std::string bytes) { return Source::own("p.ngc", std::move(bytes)); }

void check_position(const Source& source, uint64_t offset, uint32_t line, uint32_t column) {
  const Position p = source.position(offset);
  INFO("offset " << offset);
  CHECK(p.line == line);
  CHECK(p.column == column);
}

}  // namespace

TEST_CASE("lines end at line feeds only", "[text]") {
  const auto source = own("G0\nG1\r\n\nM2");
  CHECK(source->line_count() == 4);
  CHECK(source->slice(source->line(1)) == "G0");
  CHECK(source->slice(source->line(2)) == "G1\r");
  CHECK(source->slice(source->line(3)).empty());
  CHECK(source->slice(source->line(4)) == "M2");
  CHECK(source->slice(source->line(5)).empty());
  CHECK(source->slice(source->line(0)).empty());
  check_position(*source, 0, 1, 1);
  check_position(*source, 2, 1, 3);
  check_position(*source, 3, 2, 1);
  check_position(*source, 7, 3, 1);
  check_position(*source, 9, 4, 2);
  check_position(*source, 10, 4, 3);
}

TEST_CASE("an empty file has no line and a first position", "[text]") {
  const auto source = own("");
  CHECK(source->line_count() == 0);
  check_position(*source, 0, 1, 1);
  check_position(*source, 99, 1, 1);
}

TEST_CASE("an offset behind the end is the end", "[text]") {
  const auto source = own("M2\n");
  check_position(*source, UINT64_MAX, 2, 1);
  CHECK(source->position(UINT64_MAX).offset == 3);
  CHECK(source->line_count() == 1);
}

TEST_CASE("columns count code points and a byte that is none counts one", "[text]") {
  const auto source = own("(\xC3\xA4\xE2\x82\xAC\xF0\x9F\x94\xA7)\n(\xE4)\n");
  check_position(*source, 1, 1, 2);
  check_position(*source, 3, 1, 3);
  check_position(*source, 6, 1, 4);
  check_position(*source, 10, 1, 5);
  check_position(*source, 13, 2, 2);
  check_position(*source, 14, 2, 3);
  CHECK(count_code_points("\xC3") == 1);
  CHECK(count_code_points("\xC3\xC3\xA4") == 2);
  CHECK(count_code_points("\xFF\xFE") == 2);
  CHECK(count_code_points("\xF0\x9F\x94") == 3);
}

TEST_CASE("positions are right on every line of a long file", "[text]") {
  std::string bytes;
  std::vector<uint64_t> starts;
  for (int i = 0; i < 2000; ++i) {
    starts.push_back(bytes.size());
    bytes += "G1 X" + std::to_string(i) + "\n";
  }
  const auto source = own(bytes);
  CHECK(source->line_count() == 2000);
  for (uint32_t i = 0; i < 2000; ++i) {
    REQUIRE(source->position(starts[i]).line == i + 1);
    REQUIRE(source->position(starts[i] + 3).column == 4);
    REQUIRE(source->line(i + 1).begin == starts[i]);
  }
}

TEST_CASE("reports are UTF-8 whatever the program is", "[text]") {
  CHECK(printable("a\tb") == "a\tb");
  CHECK(printable("\xC3\xA4") == "\xC3\xA4");
  CHECK(printable("\xE4") == "\xC3\xA4");
  CHECK(printable(std::string_view("\0\x1B\x7F", 3)) == "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(as_utf8("\n\x1B\xE4") == "\n\x1B\xC3\xA4");
  CHECK(printable("\xC0\xAF") == "\xC3\x80\xC2\xAF");              // overlong
  CHECK(printable("\xED\xA0\x80") == "\xC3\xAD\xC2\xA0\xC2\x80");  // a surrogate
}
