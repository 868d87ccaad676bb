// Subs and blocks: what belongs to what, also where something is missing.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "analyzer/program/program.h"

using namespace owlint;

namespace {

std::unique_ptr<Program> build(const std::string& text) { return build_program(Source::own("p.ngc", text)); }

uint32_t line_of(const Program& p, StatementId id) { return id == kNoStatement ? 0 : p.at(id).line; }

/// `keyword label opener-[parts]end<parent's opener`, 0 for none.
std::string shape(const Block& b, const Program& p) {
  std::string parts;
  for (const StatementId part : p.parts[static_cast<size_t>(&b - p.blocks.data())])
    parts += fmt::format("{},", line_of(p, part));
  const uint32_t parent = b.parent == kNoBlock ? 0 : line_of(p, p.blocks[b.parent].opener);
  return fmt::format("{} {} {}-{}{}<{}", spelling(b.kind), p.name(b.label), line_of(p, b.opener), parts,
                     line_of(p, b.end), parent);
}

std::string blocks(const std::string& text) {
  const auto p = build(text);
  std::string out;
  for (const Block& b : p->blocks) out += (out.empty() ? "" : "; ") + shape(b, *p);
  return out;
}

}  // namespace

TEST_CASE("blocks have parts ends and parents", "[program]") {
  CHECK(blocks("o1 if [1]\no2 while [1]\no2 endwhile\no1 elseif [1]\no1 else\no3 do\no3 while [0]\no1 endif\no4 repeat "
               "[2]\no4 endrepeat\nM2\n") == "if 1 1-4,5,8<0; while 2 2-3<1; do 3 6-7<1; repeat 4 9-10<0");
}

TEST_CASE("a while closes a do with its label and opens a block otherwise", "[program]") {
  CHECK(blocks("o1 do\no2 while [1]\no2 endwhile\no1 while [0]\n") == "do 1 1-4<0; while 2 2-3<1");
  CHECK(blocks("o1 while [1]\no1 endwhile\n") == "while 1 1-2<0");
}

TEST_CASE("break and continue belong to the block with their label", "[program]") {
  const auto p = build("o1 while [1]\no2 if [1]\no1 break\no1 continue\no9 break\no2 endif\no1 endwhile\nM2\n");
  CHECK(p->block_of[2] == 0);
  CHECK(p->block_of[3] == 0);
  CHECK(p->block_of[4] == kNoBlock);
}

TEST_CASE("labels of blocks are local to their sub", "[program]") {
  const auto p = build("o1 sub\no5 if [1]\no5 endif\no1 endsub\no5 if [1]\no1 call\no5 endif\nM2\n");
  REQUIRE(p->regions.size() == 2);
  CHECK(p->name(p->regions[1].name) == "1");
  CHECK(line_of(*p, p->regions[1].opener) == 1);
  CHECK(line_of(*p, p->regions[1].end) == 4);
  REQUIRE(p->blocks.size() == 2);
  CHECK(p->blocks[0].region == kMainRegion);
  CHECK(shape(p->blocks[0], *p) == "if 5 5-7<0");
  CHECK(p->blocks[1].region == 1);
  CHECK(shape(p->blocks[1], *p) == "if 5 2-3<0");
  REQUIRE(p->calls.size() == 1);
  CHECK(p->calls[0].target == 1);
  CHECK(p->calls[0].caller == kMainRegion);
}

TEST_CASE("crossed blocks name each other", "[program]") {
  const auto p = build("o1 if [1]\no2 while [1]\no1 endif\no2 endwhile\nM2\n");
  CHECK(shape(p->blocks[0], *p) == "if 1 1-3<0");
  CHECK(shape(p->blocks[1], *p) == "while 2 2-4<1");
  CHECK(p->blocks[1].crossed == 0);
  CHECK(p->blocks[0].crossed == kNoBlock);
}

TEST_CASE("an end with another label is taken for the missing one", "[program]") {
  const auto p = build("o1 if [1]\n  G0 X1\no2 endif\nM2\n");
  CHECK(p->blocks[0].end == kNoStatement);
  CHECK(line_of(*p, p->blocks[0].mistaken_end) == 3);
  const auto kind = build("o1 while [1]\n  G0 X1\no1 endif\nM2\n");
  CHECK(line_of(*kind, kind->blocks[0].mistaken_end) == 3);
}

TEST_CASE("an end that belongs to nothing is not taken when the proper one follows", "[program]") {
  const auto p = build("o1 if [1]\no2 endif\no1 endif\nM2\n");
  CHECK(line_of(*p, p->blocks[0].end) == 3);
  CHECK(p->blocks[0].mistaken_end == kNoStatement);
}

TEST_CASE("indentation tells where a missing end belongs", "[program]") {
  const auto p = build("o1 while [1]\n  o2 if [1]\n    #1=1\n  #2=2\no1 endwhile\nM2\n");
  REQUIRE(p->blocks.size() == 2);
  CHECK(p->blocks[1].end == kNoStatement);
  CHECK(p->blocks[1].suggested_line == 4);
}

TEST_CASE("without indentation no place is guessed among several", "[program]") {
  const auto p = build("o1 if [1]\n#1=1\n#2=2\nM2\n");
  REQUIRE(p->blocks.size() == 1);
  CHECK(p->blocks[0].suggested_line == 0);
}

TEST_CASE("a sub without endsub names the likely one", "[program]") {
  const auto p = build("o<slot> sub\n#1=1\no<slto> endsub\no<slot> call\nM2\n");
  REQUIRE(p->regions.size() == 2);
  CHECK(p->regions[1].end == kNoStatement);
  CHECK(line_of(*p, p->regions[1].likely_end) == 3);
  CHECK(p->region_of[3] == kMainRegion);
}

TEST_CASE("definitions inside blocks know the block", "[program]") {
  const auto p = build("o1 if [1]\no2 sub\no2 endsub\no1 endif\no3 sub\no3 endsub\nM2\n");
  REQUIRE(p->regions.size() == 3);
  CHECK(p->regions[1].enclosing == 0);
  CHECK(p->regions[2].enclosing == kNoBlock);
}

TEST_CASE("a Fanuc sub reaches from its number to M99", "[program]") {
  const auto p = build("M98 P100 L2\nM2\nO100\nG0 X1\nM99\n");
  REQUIRE(p->regions.size() == 2);
  CHECK(line_of(*p, p->regions[1].opener) == 3);
  CHECK(line_of(*p, p->regions[1].end) == 5);
  CHECK(p->calls[0].target == 1);
}

TEST_CASE("a Fanuc sub goes on behind an M99 in a block that ends below", "[program]") {
  const auto p = build("M98 P100\nM98 P200\nM2\nO100\no1 if [1]\nM99\no1 endif\nG0 X1\nO200\nM99\n");
  REQUIRE(p->regions.size() == 3);
  CHECK(p->regions[1].end == kNoStatement);
  CHECK(line_of(*p, p->regions[2].opener) == 9);
  CHECK(line_of(*p, p->blocks[0].end) == 7);
}

TEST_CASE("an end is taken for the missing one, whatever stands in place of its label", "[program]") {
  for (const char* const end : {"o endif", "Q1 endif", "#1 endif", "[1] endif", "o(1) endif", "ox endif", "endif o1",
                                "endif 1", "<x> endif", "N9 endif", "o1.5 endif", "o1 endif (open"}) {
    CAPTURE(end);
    const auto p = build("o1 if [1]\nG0 X1\n" + std::string(end) + "\nM2\n");
    REQUIRE(p->blocks.size() == 1);
    REQUIRE(p->blocks[0].mistaken_end != kNoStatement);
    CHECK(line_of(*p, p->blocks[0].mistaken_end) == 3);
  }
  const auto loop = build("o1 do\n#1=1\nuntil [#1 GT 3]\nM2\n");
  CHECK(line_of(*loop, loop->blocks[0].mistaken_end) == 3);
}

TEST_CASE("other text with the word of an end ends nothing", "[program]") {
  for (const char* const text : {"end of if", "see endif", "Q1 endif [2]", "G0 endif X1"}) {
    CAPTURE(text);
    const auto p = build("o1 if [1]\nG0 X1\n" + std::string(text) + "\no1 endif\nM2\n");
    CHECK(p->blocks[0].mistaken_end == kNoStatement);
    CHECK(line_of(*p, p->blocks[0].end) == 4);
  }
}

TEST_CASE("labels are written as machinists write them", "[program]") {
  const auto p = build("o0100 if [1]\no<Deep Hole> sub\n");
  CHECK(p->label_text(p->at(0).label) == "o100");
  CHECK(p->label_text(p->at(1).label) == "o<deephole>");
  CHECK(p->head(0) == "o100 if");
}

TEST_CASE("O-words are listed by label", "[program]") {
  const auto p = build("o1 if [1]\no2 if [1]\no2 endif\no1 endif\n");
  CHECK(std::ranges::equal(p->by_label[p->syntax.names.find("1")], std::vector<StatementId>{0, 3}));
  CHECK(std::ranges::equal(p->by_label[p->syntax.names.find("2")], std::vector<StatementId>{1, 2}));
}

TEST_CASE("the lines outside of the sub with the file's name say whether it is a program", "[program]") {
  const auto called = [](const std::string& text) { return build(text)->sub_file; };  // the file is p.ngc
  const std::string sub = "o<p> sub\nG0 X1\no<p> endsub\n";
  CHECK(called(sub));
  CHECK(called(sub + "M2\n"));
  CHECK(called("%\n" + sub + "%\n"));
  CHECK(called("G21 G90\n" + sub));
  CHECK(called("#<depth> = 5\n" + sub + "M2\n"));
  CHECK(called(sub + "G0 X9\nM2\nremarks\n"));
  CHECK(called("M2\n" + sub));
  CHECK_FALSE(called("o<q> sub\no<q> endsub\n"));
  CHECK(called(sub + "o<p> call\n"));
  CHECK(called("o<q> sub\no<q> endsub\no<q> call\n" + sub));
  CHECK_FALSE(called(sub + "o<p> call\nM2\n"));
  CHECK_FALSE(called("%\n" + sub + "o<p> call\n%\n"));
  CHECK_FALSE(called("o<p> call\nM2\n" + sub));
  CHECK_FALSE(called(sub + "o<r> call\nM2\n"));
  CHECK_FALSE(called(sub + "o#1 call\nM2\n"));
  CHECK_FALSE(called(sub + "o<p>\nM2\n"));
  CHECK_FALSE(called("G0 X5\nM30\n" + sub));
}
