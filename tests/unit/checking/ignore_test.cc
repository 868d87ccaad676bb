#include <catch2/catch.hpp>

#include "analyzer/checking/ignore.h"

using owlint::checking::IgnorePatterns;

namespace {

std::string decided(const char* text, const char* path, bool folder = false) {
  IgnorePatterns patterns;
  patterns.add(text);
  const auto decision = patterns.decide(path, folder);
  return !decision ? "-" : *decision ? "out" : "back";
}

}  // namespace

TEST_CASE("patterns of ignore files", "[ignore]") {
  SECTION("a name is meant in every folder") {
    CHECK(decided("*.bak\n", "a.bak") == "out");
    CHECK(decided("*.bak\n", "x/y/a.bak") == "out");
    CHECK(decided("*.bak\n", "a.ngc") == "-");
    CHECK(decided("old\n", "x/old", true) == "out");
  }
  SECTION("a slash ties it to the folder of the file") {
    CHECK(decided("/a.ngc\n", "a.ngc") == "out");
    CHECK(decided("/a.ngc\n", "x/a.ngc") == "-");
    CHECK(decided("./x/*.ngc\n", "x/a.ngc") == "out");
    CHECK(decided("x/*.ngc\n", "x/a.ngc") == "out");
    CHECK(decided("x/*.ngc\n", "y/x/a.ngc") == "-");
    CHECK(decided("x/*.ngc\n", "x/y/a.ngc") == "-");
  }
  SECTION("a slash at its end means folders") {
    CHECK(decided("old/\n", "old", true) == "out");
    CHECK(decided("old/\n", "old", false) == "-");
    CHECK(decided("old/\n", "x/old", true) == "out");
  }
  SECTION("two stars are any number of folders") {
    CHECK(decided("**/a.ngc\n", "a.ngc") == "out");
    CHECK(decided("**/a.ngc\n", "x/y/a.ngc") == "out");
    CHECK(decided("x/**/a.ngc\n", "x/a.ngc") == "out");
    CHECK(decided("x/**/a.ngc\n", "x/y/z/a.ngc") == "out");
    CHECK(decided("x/**\n", "x/y/z.ngc") == "out");
    CHECK(decided("x/**\n", "x", true) == "-");
    CHECK(decided("x/**/y/**/z\n", "x/1/y/2/y/3/z") == "out");
  }
  SECTION("the last one that fits decides") {
    CHECK(decided("*.ngc\n!keep.ngc\n", "keep.ngc") == "back");
    CHECK(decided("!keep.ngc\n*.ngc\n", "keep.ngc") == "out");
  }
  SECTION("comments, blanks and escapes") {
    CHECK(decided("# *.ngc\n\n   \n", "a.ngc") == "-");
    CHECK(decided("a.ngc  \r\n", "a.ngc") == "out");
    CHECK(decided("\\#a.ngc\n", "#a.ngc") == "out");
    CHECK(decided("\\!a.ngc\n", "!a.ngc") == "out");
  }
}

TEST_CASE("a pattern of many stars takes no time", "[ignore]") {
  std::string pattern;
  std::string path;
  for (int i = 0; i < 300; ++i) {
    pattern += "**/a/";
    path += "a/";
  }
  CHECK(decided((pattern + "z\n").c_str(), (path + "b").c_str()) == "-");
}
