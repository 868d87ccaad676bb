// The word that a message about modes is about.
#include <array>

#include <catch2/catch.hpp>

#include "rules/driver/modes.h"

using namespace owlint;
using namespace owlint::rules;

namespace {

/// The word of a line that the names mean, as messages show it.
std::string found(const std::string& line, std::string_view names) {
  const auto source = Source::own("p.ngc", line);
  const std::vector<WrittenWord> words = words_of(*source, {0, line.size()});
  const WrittenWord* word = find_word(words, names);
  return word == nullptr ? "none" : shown(*source, word->span);
}

}  // namespace

TEST_CASE("a word is found by its code, its letter or as an axis word", "[modes]") {
  CHECK(found("N5 F100 g1 x5 y6", "G1 *") == "G1");
  CHECK(found("f100 x5 y6", "G1 *") == "X5");
  CHECK(found("G0 ^45 @3", "*") == "^45");
  CHECK(found("G43.2 H1", "G43") == "none");
  CHECK(found("G43.2 H1", "G43 G43.2 H") == "G43.2");
  CHECK(found("T1 M06", "M6 T") == "M06");
  CHECK(found("G[40 + 1] D#1", "G41 D") == "G[40+1]");
  CHECK(found("G#1 D#1", "G41 D") == "D#1");
  CHECK(found("(G41) M8", "G41 D") == "none");
}

TEST_CASE("of several rows that fit a message the first counts", "[modes]") {
  constexpr std::array rows = {Said{"in M51 command", "", "first", ""}, Said{"Invalid spindle", "", "second", ""}};
  CHECK(said_of(rows, "Invalid spindle ($) number in M51 command")->message == "first");
  CHECK(said_of(rows, "Invalid spindle ($) number in G33 move")->message == "second");
  CHECK(said_of(rows, "Cannot do g1 with zero feed rate") == nullptr);
}
