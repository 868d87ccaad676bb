// Characters that look like others.
#include <catch2/catch.hpp>

#include "analyzer/syntax/look_alike.h"

using namespace owlint;

TEST_CASE("characters are read as UTF-8, or as Windows writes them", "[syntax]") {
  CHECK(character_at("A").code == 'A');
  CHECK(character_at("\xE2\x88\x92"
                     "5")
            .code == 0x2212);
  CHECK(character_at("\xE2\x88\x92").length == 3);
  CHECK(character_at("\xF0\x9D\x9F\x8E").length == 4);
  CHECK(character_at("\x96").code == 0x2013);
  CHECK(character_at("\xA0").code == 0xA0);
  CHECK(character_at("\xE2").length == 1);
  CHECK(character_at("\xC3\xA4").code == 0xE4);
}

TEST_CASE("what characters look like", "[syntax]") {
  CHECK(look_alike(0x2212)->name == "MINUS SIGN");
  CHECK(look_alike(0x2212)->plain == "-");
  CHECK(look_alike(0xA0)->plain == " ");
  CHECK(look_alike(0x200B)->plain.empty());
  CHECK(look_alike(0xFF11)->name == "FULLWIDTH DIGIT 1");
  CHECK(look_alike(0xFF38)->plain == "X");
  CHECK(look_alike(0x0425)->plain == "X");
  CHECK_FALSE(look_alike(0xE4).has_value());
  CHECK_FALSE(look_alike('A').has_value());
}

TEST_CASE("text with the characters that are meant", "[syntax]") {
  CHECK(plain_text("dr\xD1\x96ll") == "drill");
  CHECK(plain_text("X\xE2\x88\x92"
                   "5\xC2\xA0Y") == "X-5 Y");
  CHECK(plain_text("gr\xC3\xB6\xC3\x9F"
                   "e") ==
        "gr\xC3\xB6\xC3\x9F"
        "e");
}
