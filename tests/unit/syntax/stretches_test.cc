// A large file is looked through in stretches, by several cores: what comes out must not depend on how many there are.
#include <random>

#include <catch2/catch.hpp>

#include "analyzer/syntax/statement.h"
#include "analyzer/text/parallel.h"

using namespace owlint;

namespace {

/// About 20 MB of lines of all sorts; `blank` bytes of blank lines first.
std::string large(uint32_t seed, size_t blank) {
  static const std::vector<std::string> kLines = {"G1 X1.5 Y2.25\n",
                                                  "o100 if [#1 GT 2]\n",
                                                  "o100 endif\n",
                                                  "(owlint: ignore OW104 -- known)\n",
                                                  "\n",
                                                  "  \r\n",
                                                  "G0 X1 (not closed\n",
                                                  "#<a> = [#1 + 2]\n",
                                                  "%\n",
                                                  "M2\n",
                                                  "o<name> call [1] [2]\n",
                                                  std::string(300, 'X') + "\n",
                                                  "G1 X1 ; a comment\n",
                                                  std::string("G0\0X", 4) + "\n",
                                                  "\xC3\xA4\n",
                                                  "G1 X1\rG1 Y1\n"};
  std::mt19937 random(seed);
  std::discrete_distribution<size_t> line{400, 4, 4, 1, 20, 3, 1, 4, 1, 1, 2, 1, 8, 1, 1, 1};
  std::string text(blank, '\n');
  while (text.size() < 20'000'000) text += kLines[line(random)];
  if (seed % 2 == 0) text += "G1 X1";  // the last line without a line feed
  return text;
}

bool same(const Syntax& a, const Syntax& b) {
  const auto key = [](const Statement& s) {
    return std::tuple(s.offset, s.length, s.line, s.label, s.first, s.error, s.first_plain_line, s.kind, s.keyword,
                      s.value_count, s.item_count, bool{s.plain_code_follows});
  };
  const auto place = [](const Directive& d) {
    return std::tuple(d.line, d.span.begin, d.span.end, d.own_line, d.on_oword);
  };
  return std::ranges::equal(a.statements, b.statements, {}, key, key) &&
      std::ranges::equal(a.directives, b.directives, {}, place, place) && a.lines == b.lines &&
      a.last_code == b.last_code && a.first_plain_line == b.first_plain_line && a.percent == b.percent &&
      a.blank == b.blank && a.exprs.size() == b.exprs.size() && a.errors.size() == b.errors.size() &&
      a.names.size() == b.names.size();
}

struct AllCores {
  ~AllCores() { use_cores(0); }
};

}  // namespace

TEST_CASE("a large file is read alike by one core and by several", "[scanner]") {
  const AllCores again;
  for (uint32_t seed = 0; seed < 4; ++seed) {
    const auto source = Source::own("large.ngc", large(seed, seed == 3 ? 9'000'000 : 0));
    use_cores(1);
    const Syntax one = scan(*source);
    REQUIRE(one.statements.size() > 10'000);
    for (const unsigned cores : {2U, 3U, 8U}) {
      use_cores(cores);
      CHECK(same(one, scan(*source)));
    }
  }
}

TEST_CASE("after a problem nothing more is begun, and the problem is reported") {
  const AllCores all;
  use_cores(1);
  std::vector<size_t> begun;
  const auto work = [&](size_t i) {
    begun.push_back(i);
    if (i == 3) throw std::runtime_error("no space");
  };
  CHECK_THROWS_WITH(for_each(100, work), "no space");
  CHECK(begun == std::vector<size_t>{0, 1, 2, 3});
}

TEST_CASE("one line may be longer than a stretch", "[scanner]") {
  const AllCores again;
  const auto source = Source::own("line.ngc", "o1 if [#1]\n" + std::string(30'000'000, 'G') + "\no1 endif\nM2\n");
  use_cores(2);
  const Syntax syntax = scan(*source);
  CHECK(syntax.lines == 4);
  REQUIRE(syntax.statements.size() == 4);
  CHECK(syntax.statements[2].line == 3);
}
