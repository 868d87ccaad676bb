// The machine around a program: INI, mask, version, and when FEATURE 0x20 is in effect (interface.md's table).
#include <catch2/catch.hpp>

#include "analyzer/machine/predefined.h"
#include "support/files.h"

using namespace owlint;

namespace {

Profile from_ini(const std::string& text) {
  const test::Scratch scratch;
  Profile profile;
  std::string error;
  profile.setup = read_setup(disk(), scratch.write("machine.ini", text), &error);
  REQUIRE(profile.setup != nullptr);
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
  CHECK_FALSE(warns("[RS274NGC]\nOWORD_WARNONLY = yes\n", "2.9"));  // measured: only the number 1 is
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

TEST_CASE("the settings of a machine are those of its RS274NGC section", "[profile]") {
  const Profile p = from_ini(
      "# FEATURES = 1\r\n[EMC]\r\nFEATURES = 1\r\n[RS274NGC]\r\n  FEATURES=0x20 \r\nFEATURES = 0x40\r\n; "
      "OWORD_WARNONLY = 1\r\n[TRAJ]\r\nOWORD_WARNONLY = 1\r\n");
  REQUIRE(p.setup != nullptr);
  CHECK(p.setup->mask == 0x20);
  CHECK_FALSE(p.setup->warnonly);
  // Measured: an integer 1, however it is written, and nothing else.
  for (const char* yes : {"1", "01"})
    CHECK(from_ini(std::string("[RS274NGC]\nOWORD_WARNONLY = ") + yes + "\n").setup->warnonly);
  for (const char* no : {"0", "no", "TRUE", "yes", "on", "2", "-1", "0x1", "1 # x"}) {
    INFO(no);
    CHECK_FALSE(from_ini(std::string("[RS274NGC]\nOWORD_WARNONLY = ") + no + "\n").setup->warnonly);
  }
  CHECK_FALSE(from_ini("").setup->mask.has_value());
  CHECK_FALSE(from_ini("[RS274NGC]\nFEATURES = many\n").setup->mask.has_value());
  CHECK(from_ini("[RS274NGC]\nFEATURE = 0x20").setup->mask == 0x20);
}

TEST_CASE("an INI that cannot be read says why", "[profile]") {
  std::string error;
  CHECK(read_setup(disk(), "/no/such.ini", &error) == nullptr);
  CHECK(error == "No such file or directory");
}

TEST_CASE("called files are looked for where LinuxCNC looks for them", "[profile]") {
  const test::Scratch scratch;
  const std::string ini = scratch.write("m/machine.ini",
                                        "[DISPLAY]\nPROGRAM_PREFIX = ../prefix\n[RS274NGC]\nSUBROUTINE_PATH = "
                                        "../s1:../none:../s2: ../s3\n[WIZARD]\nWIZARD_ROOT = ../wiz\n");
  for (const char* name : {"m/a.ngc", "prefix/a.ngc", "prefix/b.ngc", "s1/b.ngc", "s2/c.ngc", "s3/d.ngc",
                           "wiz/deep/e.ngc", "s1/Up.ngc", "s2/x.ngc/y"})
    scratch.write(name, "");
  std::string error;
  const auto setup = read_setup(disk(), ini, &error);
  REQUIRE(setup != nullptr);
  const SearchPath& search = *setup->search_path;
  const auto found = [&](const std::string& name) {
    const auto file = search.find(name);
    return file ? file->path.substr(scratch.path().size() + 1) : "";
  };
  CHECK(found("a") == "m/a.ngc");
  CHECK(found("b") == "prefix/b.ngc");
  CHECK(found("c") == "s2/c.ngc");
  CHECK(found("d").empty());  // the blank before `../s3` is a part of the name
  CHECK(found("e") == "wiz/deep/e.ngc");
  CHECK(found("deep/e").empty());
  CHECK(found("up").empty());
  CHECK(search.find_other_case("up").value_or("").ends_with("s1/Up.ngc"));
  CHECK(found("x") == "s2/x.ngc");  // a folder: LinuxCNC opens it, and finds nothing
  CHECK_FALSE(search.find("x")->regular);
  for (const char* outside : {"../m/a", "/etc/passwd", "~/a", "a/../../m/a", "$HOME", "`a`", ""})
    CHECK_FALSE(search.find(outside));
  CHECK(search.names() == std::vector<std::string>{"a", "b", "c", "e", "x"});
  CHECK(std::ranges::count(setup->folders, false, &IniFolder::exists) == 2);
}

TEST_CASE("which names are predefined depends on the version and the INI", "[machine]") {
  const auto kind = [](std::string_view name, const char* version, const std::string& ini) {
    Profile profile = ini.empty() ? Profile{} : from_ini(ini);
    profile.version = version_from_text(version).value();
    return name_kind(name, profile);
  };
  const std::string ini =
      "[RS274NGC]\nHAL_PIN_VARS = 0\n[AXIS_Z]\nMAX_LIMIT = 12.5\nWORDS = 12 mm\nTOO_MUCH = 1e400\nSIGNS = +-1\n";

  CHECK(kind("n", "2.9", "") == NameKind::kLocal);
  CHECK(kind("_n", "2.9", "") == NameKind::kGlobal);
  for (const char* version : {"2.7", "2.8", "2.9", "2.10"}) {
    CHECK(kind("_x", version, "") == NameKind::kPredefined);
    CHECK(kind("_value_returned", version, "") == NameKind::kPredefined);
    CHECK(kind("_ini[axis_z]max_limit", version, "") == NameKind::kOfMachine);
  }
  CHECK(kind("_abs_x", "2.7", "") == NameKind::kSomeReleases);
  CHECK(kind("_abs_x", "2.8", "") == NameKind::kPredefined);
  CHECK(kind("_abs_u", "2.8", "") == NameKind::kGlobal);
  CHECK(kind("_abs_u", "2.9", "") == NameKind::kSomeReleases);
  CHECK(kind("_abs_u", "2.10", "") == NameKind::kPredefined);
  CHECK(kind("_metric_machine", "2.7", "") == NameKind::kGlobal);
  CHECK(kind("_metric_machine", "2.9", "") == NameKind::kPredefined);

  CHECK(kind("_ini[axis_z]max_limit", "2.9", ini) == NameKind::kPredefined);
  CHECK(kind("_ini[axis_z]max_limit", "2.7", ini) == NameKind::kOfMachine);
  for (const char* missing : {"_ini[axis_z]words", "_ini[axis_z]too_much", "_ini[axis_z]signs", "_ini[axis_x]max_limit",
                              "_ini[axis_z]", "_ini[axis_z", "_ini["}) {
    CHECK(kind(missing, "2.9", ini) == NameKind::kGlobal);
  }
  CHECK(kind("_hal[pin]", "2.9", ini) == NameKind::kGlobal);
  CHECK(kind("_hal[pin]", "2.9", "[RS274NGC]\n") == NameKind::kOfMachine);

  Profile profile = from_ini(ini);
  CHECK(ini_number("_ini[axis_z]max_limit", profile) == 12.5);
  CHECK(ini_number("_x", profile) == std::nullopt);

  CHECK(read_only_number(5420, Version::k2_7));
  CHECK_FALSE(read_only_number(5021, Version::k2_9));
  CHECK(read_only_number(5021, Version::k2_10));
}
