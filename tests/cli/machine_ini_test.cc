// INIs of machines, as users check and fix them.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace machine_ini_test {
namespace {

const std::string kIni = "[EMC]\nVERSION = 1.1\n[RS274NGC]\nSUBROUTINE_PATH = subs\n";

Run check(const Scratch& folder, const std::string& arguments) {
  return owlint::test::owlint(words("check " + arguments), "", folder.path());
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("an INI is checked as a file of its own, with the exit status of programs", "[machine][ini]") {
  const Scratch folder;
  folder.write("machine.ini", "[RS274NGC]\nREMAP = M400 modalgroup=3 ngc=r\nRETAIN_G43 = YES\n");
  folder.write("r.ngc", "o<r> sub\no<r> endsub\n");
  const Run run = check(folder, "--isolated machine.ini");
  CHECK(run.status == 1);
  CHECK(contains(run.out, "machine.ini:2:14: error `M400` cannot be in modal group 3"));
  CHECK(contains(run.out, "machine.ini:3:14: warning `YES`"));
  CHECK_FALSE(contains(run.out, "r.ngc"));
  CHECK(check(folder, "--isolated --ignore OW416 machine.ini").status == 0);
  const Run json = check(folder, "--isolated --format json machine.ini");
  const auto files = nlohmann::json::parse(json.out)["files"];
  REQUIRE(files.size() == 1);
  CHECK(files[0]["path"] == "machine.ini");
  CHECK(files[0]["findings"].size() == 2);
}

TEST_CASE("folders are searched for INIs of machines as well, and each is reported once", "[machine][ini]") {
  const Scratch folder;
  folder.write("mill/machine.ini", "[RS274NGC]\nRETAIN_G43 = YES\n");
  folder.write("mill/p.ngc", "G0 X1\nM2\n");
  folder.write("other/desktop.ini", "[ViewState]\nMode\n");  // no machine
  const Run run = check(folder, "--isolated --format json mill");
  const auto files = nlohmann::json::parse(run.out)["files"];
  REQUIRE(files.size() == 2);
  CHECK(files[0]["path"] == "mill/machine.ini");
  CHECK(files[0]["findings"].size() == 1);
  CHECK(files[1]["findings"].empty());
  CHECK(check(folder, "--isolated other").status == 2);  // no programs
  CHECK(check(folder, "--isolated --exclude machine.ini --no-find-ini mill").out.empty());
}

TEST_CASE("what is wrong with an INI is fixed in the INI", "[machine][ini][fix]") {
  const Scratch folder;
  const std::string path = folder.write(
      "machine.ini", "[RS274NGC]\n  RETAIN_G43 = YES\nOWORD_NARGS = 1 # on\n[JOINT_0]\nSCALE = 100 ; steps\n");
  folder.write("p.ngc", "G0 X1\nM2\n");
  CHECK(check(folder, "--isolated --fix .").status == 0);
  CHECK(read_file(path) == "[RS274NGC]\n  RETAIN_G43 = 1\n# on\nOWORD_NARGS = 1\n[JOINT_0]\n; steps\nSCALE = 100\n");
  CHECK(check(folder, "--isolated .").out.empty());
}

TEST_CASE("findings of an INI are suppressed by comments in it", "[machine][ini][suppression]") {
  const Scratch folder;
  const std::string path = folder.write("machine.ini", "[RS274NGC]\nRETAIN_G43 = YES\n");
  CHECK(check(folder, "--isolated --add-suppressions --reason as-it-was machine.ini").status == 0);
  CHECK(read_file(path) == "[RS274NGC]\n# owlint: ignore OW415 because as-it-was\nRETAIN_G43 = YES\n");
  CHECK(check(folder, "--isolated machine.ini").out.empty());
}

TEST_CASE("an INI that includes itself without end is read to a limit", "[machine][ini]") {
  const Scratch folder;
  std::string text = "[RS274NGC]\n";
  for (int i = 0; i < 20'000; ++i) text += "#INCLUDE machine.ini\n";
  folder.write("machine.ini", text);
  const Run run = check(folder, "--isolated machine.ini");
  CHECK(run.status == 0);
  CHECK(contains(run.out, "owlint checks only the first 100000 lines"));
}

TEST_CASE("an INI in UTF-16 is known as one, and is an error", "[machine]") {
  const Scratch folder;
  std::string wide = "\xFF\xFE";
  for (const char c : kIni) wide += {c, '\0'};
  folder.write("machine.ini", wide);
  for (const char* arguments : {"--isolated .", "--isolated --ini machine.ini ."}) {
    const Run run = check(folder, arguments);
    CHECK(run.status == 1);
    CHECK(contains(run.out, "machine.ini:1:"));
    CHECK(contains(run.out,
                   "the file is saved as UTF-16: LinuxCNC finds no section and no key in it, and does not start"));
  }
}

TEST_CASE("programs of user M codes that cannot run are found, and files that are none are named", "[machine]") {
  const Scratch folder;
  folder.write("machine.ini", kIni + "USER_M_PATH = codes\n");
  const auto program = [&](const char* name, const char* text) {
    ::chmod(folder.write(std::string("codes/") + name, text).c_str(), 0755);
  };
  program("M101", "#!/bin/sh\nexit 0\n");
  program("M102", "#!/bin/sh\r\nexit 0\r\n");
  program("M103", "#!/usr/bin/no-such-owlint\n");
  program("M104.sh", "#!/bin/sh\n");
  folder.write("codes/M105", "#!/bin/sh\n");
  folder.write("a.ngc", "G21 G90\nM101\nM2\n");
  folder.write("b.ngc", "G21 G90\nM104\nM2\n");
  folder.write("c.ngc", "G21 G90\nM105\nM2\n");
  const Run run = check(folder, "--isolated --format gcc .");
  CHECK(contains(run.out, "codes/M102:1:1: "));
  CHECK(contains(run.out,
                 "`#!/bin/sh` ends with a carriage return, so LinuxCNC cannot run this file: `M102` stops the "
                 "program without a message"));
  CHECK(contains(run.out, "codes/M103:1:3: warning: there is no `/usr/bin/no-such-owlint` on this computer"));
  CHECK(contains(run.out, "M104.sh is not named `M104`"));
  CHECK(contains(run.out, "M105 is not executable"));
  CHECK_FALSE(contains(run.out, "a.ngc"));
  CHECK_FALSE(contains(run.out, "M101:"));
}

TEST_CASE("fixes of an INI that change what a machine does are not safe", "[machine]") {
  const Scratch folder;
  const std::string ini =
      "[EMC]\nVERSION = 1.1\n[TRAJ]\nNO_FORCE_HOMING = YES\n[RS274NGC]\nOWORD_WARNONLY = TRUE\n"
      "PARAMETER_FILE = a.var # offsets\nRETAIN_G43 = YES\n";
  folder.write("machine.ini", ini);
  folder.write("a.var", "5161 1\n");
  folder.write("a.var # offsets", "5161 2\n");
  check(folder, "--isolated --fix machine.ini");
  CHECK(read_file(folder.path() + "/machine.ini") == ini.substr(0, ini.rfind("YES")) + "1\n");
  check(folder, "--isolated --fix --unsafe machine.ini");
  const std::string fixed = read_file(folder.path() + "/machine.ini");
  CHECK(contains(fixed, "NO_FORCE_HOMING = 1\n"));
  CHECK(contains(fixed, "PARAMETER_FILE = a.var\n"));
}

}  // namespace machine_ini_test
