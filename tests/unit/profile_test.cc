// The machine around a program: INI, mask, version, and when FEATURE 0x20 is in effect (interface.md's table).
#include <catch2/catch.hpp>

#include "analyzer/machine/profile.h"
#include "support/files.h"

using namespace owlint;

namespace {

Profile from_ini(const std::string& text) {
  const test::Scratch scratch;
  Profile profile;
  std::string error;
  REQUIRE(read_ini(scratch.write("machine.ini", text), &profile, &error));
  return profile;
}

bool warns(const std::string& ini, const char* version = nullptr, const char* feature = nullptr) {
  Profile profile = ini.empty() ? Profile{} : from_ini(ini);
  if (version != nullptr) {
    profile.version = version_from_text(version).value();
    profile.version_given = true;
  }
  if (feature != nullptr) profile.feature = parse_mask(feature);
  return profile.warn_only();
}

const std::string kMask = "[RS274NGC]\nFEATURES = 0x20\n";
const std::string kKey = "[RS274NGC]\nOWORD_WARNONLY = 1\n";

}  // namespace

TEST_CASE("when FEATURE 0x20 is in effect", "[profile]") {
  CHECK_FALSE(warns(""));
  CHECK(warns("", nullptr, "0x20"));
  CHECK(warns("", "2.9", "32"));
  CHECK(warns("", nullptr, "0xFF"));
  CHECK_FALSE(warns("", nullptr, "0x1F"));
  CHECK_FALSE(warns("", nullptr, "0"));

  CHECK(warns(kKey));
  CHECK_FALSE(warns(kKey, "2.7"));
  CHECK(warns(kKey, "2.8"));
  CHECK(warns(kKey, "2.9"));
  CHECK(warns(kKey, "2.10"));

  CHECK(warns(kMask));  // as documented; OW408 says that 2.8 and later ignore it
  CHECK(warns(kMask, "2.7"));
  CHECK_FALSE(warns(kMask, "2.8"));
  CHECK_FALSE(warns(kMask, "2.10"));
  CHECK(warns(kMask, "2.9", "0x20"));
  CHECK(warns(kMask + "OWORD_WARNONLY = yes\n", "2.9"));
  CHECK(warns("[RS274NGC]\nFEATURE = 32\n"));
}

TEST_CASE("masks are decimal or hexadecimal", "[profile]") {
  CHECK(parse_mask("32") == 32);
  CHECK(parse_mask("0x20") == 32);
  CHECK(parse_mask("0X2f") == 47);
  CHECK(parse_mask(" 7 ") == 7);
  CHECK(parse_mask("0xFFFFFFFF") == 0xFFFFFFFF);
  for (const char* wrong : {"", "0x", "x20", "32a", "-1", "1.5", "0x1FFFFFFFF", "4294967296", "3 2"}) {
    INFO(wrong);
    CHECK_FALSE(parse_mask(wrong).has_value());
  }
}

TEST_CASE("versions are those that are supported", "[profile]") {
  for (const char* text : {"2.7", "2.8", "2.9", "2.10"}) CHECK(version_text(version_from_text(text).value()) == text);
  CHECK(version_from_text("2.10").value() > version_from_text("2.9").value());
  for (const char* wrong : {"", "2", "2.1", "2.11", "3.0", "2.9.1"}) CHECK_FALSE(version_from_text(wrong).has_value());
}

TEST_CASE("an INI is read as LinuxCNC reads it", "[profile]") {
  const Profile p = from_ini("# FEATURES = 1\r\n[EMC]\r\nFEATURES = 1\r\n[RS274NGC]\r\n  FEATURES=0x20 \r\nFEATURES = 0x40\r\n; OWORD_WARNONLY = 1\r\n[TRAJ]\r\nOWORD_WARNONLY = 1\r\n");
  CHECK(p.ini_given);
  CHECK(p.ini_mask == 0x20);
  CHECK_FALSE(p.ini_warnonly);
  CHECK_FALSE(from_ini("[RS274NGC]\nOWORD_WARNONLY = 0\n").ini_warnonly);
  CHECK_FALSE(from_ini("[RS274NGC]\nOWORD_WARNONLY = no\n").ini_warnonly);
  CHECK(from_ini("[RS274NGC]\nOWORD_WARNONLY = TRUE\n").ini_warnonly);
  CHECK_FALSE(from_ini("").ini_mask.has_value());
  CHECK_FALSE(from_ini("[RS274NGC]\nFEATURES = many\n").ini_mask.has_value());
  CHECK(from_ini("[RS274NGC]\nFEATURE = 0x20").ini_mask == 0x20);
}

TEST_CASE("an INI that cannot be read says why", "[profile]") {
  Profile profile;
  std::string error;
  CHECK_FALSE(read_ini("/no/such.ini", &profile, &error));
  CHECK(error == "No such file or directory");
}
