#include <catch2/catch.hpp>

#include "analyzer/text/source.h"

using owlint::KeptLine;
using owlint::Source;
using owlint::Span;

TEST_CASE("places in an excerpt are given as in the whole file", "[source]") {
  const std::string text = "G21\n(é) o100 if [1]\nG0 X1\n\nM2";
  const auto whole = Source::own("a.ngc", text);
  std::vector<KeptLine> kept;
  for (const uint32_t number : {2U, 4U, 5U}) {
    const Span line = whole->line(number);
    kept.push_back({number, line.begin, std::string(whole->slice(line))});
  }
  const auto excerpt = Source::excerpt("a.ngc", kept, whole->line_count());
  CHECK(excerpt->line_count() == 5);
  for (const uint32_t number : {2U, 4U, 5U}) {
    const Span line = whole->line(number);
    CHECK(excerpt->line(number) == line);
    CHECK(excerpt->slice(line) == whole->slice(line));
    for (uint64_t offset = line.begin; offset <= line.end; ++offset) {
      const auto a = whole->position(offset);
      const auto b = excerpt->position(offset);
      CHECK((a.line == b.line && a.column == b.column && b.offset == offset));
      CHECK(excerpt->slice({offset, line.end}) == whole->slice({offset, line.end}));
    }
  }
  CHECK(excerpt->slice(excerpt->line(3)).empty());
  CHECK(excerpt->slice({0, 3}).empty());
  CHECK(Source::excerpt("b.ngc", {}, 0)->position(7).line == 1);
}
