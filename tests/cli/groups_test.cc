// A called sub that is nowhere is one mistake, in however many places and files it is called.
#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace groups_test {
namespace {

Run check(const Scratch& folder, const std::string& arguments) {
  return owlint::test::owlint(words("check --isolated " + arguments), "", folder.path());
}

std::vector<nlohmann::json> missing_subs(const Scratch& folder, const std::string& arguments) {
  std::vector<nlohmann::json> out;
  const nlohmann::json report = nlohmann::json::parse(check(folder, "--format json " + arguments).out);
  for (const auto& file : report["files"]) {
    for (const auto& f : file["findings"]) {
      if (f["code"].get<std::string>() == "OW208") out.push_back(f);
    }
  }
  return out;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Three programs in two folders that call a sub which is in none of them.
void write_programs(const Scratch& folder) {
  folder.write("mill/a.ngc", "o<drill> call [1]\no<drill> call [2]\nM2\n");
  folder.write("mill/b.ngc", "o<drill> call [3]\nM2\n");
  folder.write("lathe/c.ngc", "G0 X1\no<drill> call [4]\nM2\n");
}

}  // namespace

TEST_CASE("calls of a sub that is nowhere are one finding with all places", "[groups]") {
  const Scratch folder;
  write_programs(folder);
  const auto found = missing_subs(folder, ".");
  REQUIRE(found.size() == 1);
  CHECK(found[0]["severity"].get<std::string>() == "info");  // what so many programs call is on the machine
  CHECK(contains(found[0]["message"].get<std::string>(), "(4 places in 3 files)"));
  REQUIRE(found[0]["related"].size() == 3);
  CHECK(found[0]["related"][0]["path"].get<std::string>() == "mill/a.ngc");
  CHECK(found[0]["related"][1]["path"].get<std::string>() == "mill/a.ngc");
  CHECK(found[0]["related"][1]["start"]["line"].get<int>() == 2);
  CHECK(found[0]["related"][2]["path"].get<std::string>() == "mill/b.ngc");
}

TEST_CASE("what one file calls, or two programs call once, may be missing", "[groups]") {
  const Scratch folder;
  write_programs(folder);
  CHECK(missing_subs(folder, "mill/a.ngc").at(0)["severity"].get<std::string>() == "warning");
  CHECK(missing_subs(folder, "mill/b.ngc lathe/c.ngc").at(0)["severity"].get<std::string>() == "warning");
  CHECK(missing_subs(folder, "--severity OW208=error .").at(0)["severity"].get<std::string>() == "error");
}

TEST_CASE("each folder that is checked has its own", "[groups]") {
  const Scratch folder;
  write_programs(folder);
  CHECK(missing_subs(folder, "mill lathe").size() == 2);
  CHECK(missing_subs(folder, "mill/a.ngc mill/b.ngc").size() == 1);
}

TEST_CASE("a file of that name in the tree is named, with what tells owlint", "[groups]") {
  const Scratch folder;
  write_programs(folder);
  folder.write("subs/drill.ngc", "o<drill> sub\nG0 X#1\no<drill> endsub\n");
  const auto found = missing_subs(folder, ".");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0]["help"].get<std::string>(), "subs/drill.ngc"));
  CHECK(contains(found[0]["help"].get<std::string>(), "`--sub-path subs`"));
  CHECK(contains(found[0]["help"].get<std::string>(), "`sub-path = [\"subs\"]`"));
  CHECK(missing_subs(folder, "--sub-path subs .").empty());
  folder.write("lathe/macros/drill.ngc", "o<drill> sub\nG0 X#1\no<drill> endsub\n");
  CHECK(contains(missing_subs(folder, "lathe subs").at(0)["help"].get<std::string>(),
                 "`--sub-path lathe/macros`"));  // the nearest
}

TEST_CASE("codes that run programs of one machine are one finding, with the names of some", "[groups]") {
  const Scratch folder;
  folder.write("machine.ini", "[RS274NGC]\nUSER_M_PATH = mcodes\n");
  folder.write("a.ngc", "M110\nM160\nM110\nM2\n");
  CHECK(contains(check(folder, "--ini machine.ini a.ngc").out,
                 "`M110` runs a program of the machine, whose folders are not here (also `M160`; 3 places)"));
  folder.write("b.ngc", "M111\nM112\nM113\nM2\n");
  CHECK(contains(check(folder, "--ini machine.ini a.ngc b.ngc").out,
                 "(also `M160`, `M111` and 2 more; 6 places in 2 files)"));
}

TEST_CASE("the text shows some places and counts the others", "[groups]") {
  const Scratch folder;
  std::string calls;
  for (int i = 0; i < 20; ++i) calls += fmt::format("o<drill> call [{}]\n", i);
  folder.write("a.ngc", calls + "M2\n");
  const Run run = check(folder, "a.ngc");
  CHECK(contains(run.out, "(20 places)"));
  CHECK(contains(run.out, "and 14 more places"));
  CHECK(contains(run.err, "1 warning in 1 file"));
}

TEST_CASE("a baseline and suppressions are about each place", "[groups]") {
  const Scratch folder;
  write_programs(folder);
  check(folder, "--baseline known.json --update-baseline .");
  folder.write("mill/d.ngc", "o<drill> call [5]\nM2\n");
  const auto fresh = missing_subs(folder, "--baseline known.json .");
  REQUIRE(fresh.size() == 1);
  CHECK(fresh[0]["related"].empty());
  const Run run = owlint::test::owlint(
      {"check", "--isolated", "--add-suppressions", "--reason", "it is on the machine", "."}, "", folder.path());
  CHECK(run.status == 0);
  CHECK(check(folder, ".").out.empty());
}

TEST_CASE("subs that are all in one folder of the tree are one finding", "[groups]") {
  const Scratch folder;
  folder.write("mill/a.ngc", "o<drill> call [1]\no<bore> call [2]\no<tap> call\no<ream> call\no<mark> call\nM2\n");
  for (const std::string name : {"drill", "bore", "tap", "ream", "mark"})
    folder.write("helpers/" + name + ".ngc", "o<" + name + "> sub\n  G0 X#1\no<" + name + "> endsub\n");
  const auto found = missing_subs(folder, ".");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0]["message"].get<std::string>(), "all are in `helpers`"));
  CHECK(found[0]["related"].size() == 4);
  CHECK(missing_subs(folder, "--sub-path helpers .").empty());
}

TEST_CASE("calls in several programs that lack the same argument of a file's sub are one finding", "[groups]") {
  const Scratch folder;
  folder.write("bore.ngc", "o<bore> sub\n  G0 X#1\n  G1 Z#2 F100\no<bore> endsub\n");
  folder.write("a.ngc", "o<bore> call [1]\nM2\n");
  folder.write("b.ngc", "o<bore> call [1]\no<bore> call [2]\nM2\n");
  const nlohmann::json report = nlohmann::json::parse(check(folder, "--format json .").out);
  size_t found = 0;
  for (const auto& file : report["files"]) {
    for (const auto& f : file["findings"]) found += f["code"] == "OW507" ? 1 : 0;
  }
  CHECK(found == 1);
}

TEST_CASE("a helper that several sub files define is one finding that names them", "[groups]") {
  const Scratch folder;
  for (const std::string name : {"left", "right"})
    folder.write(name + ".ngc",
                 "o<" + name + "> sub\no500 call\no<" + name + "> endsub\no500 sub\nG0 X1\no500 endsub\n");
  const nlohmann::json report = nlohmann::json::parse(check(folder, "--format json .").out);
  const auto& left = report["files"][0]["findings"];
  REQUIRE(left.size() == 1);
  CHECK(left[0]["code"].get<std::string>() == "OW403");
  CHECK(contains(left[0]["message"].get<std::string>(), "(2 places in 2 files)"));
  CHECK(left[0]["related"].back()["path"].get<std::string>() == "right.ngc");
  CHECK(report["files"][1]["findings"].empty());
}

TEST_CASE("what a program stops with for a line of the INI is no second finding of that line", "[groups]") {
  const Scratch folder;
  folder.write("machine.ini", "[RS274NGC]\nREMAP = M400 modalgroup=6 argspec=P ngc=fa\n");
  folder.write("fa.ngc", "o<fa> sub\n  G0 X#<q>\no<fa> endsub\n");
  folder.write("main.ngc", "M400 P1\nM2\n");
  const auto codes = [&](const std::string& arguments) {
    std::string found;
    const nlohmann::json report = nlohmann::json::parse(check(folder, "--format json " + arguments).out);
    for (const auto& file : report["files"]) {
      for (const auto& f : file["findings"]) {
        if (f["code"] == "OW418" || f["code"] == "OW603") found += f["code"].get<std::string>() + " ";
      }
    }
    return found;
  };
  CHECK(codes("machine.ini") == "OW418 ");
  CHECK(codes("--ini machine.ini machine.ini main.ngc") == "OW603 ");
}

}  // namespace groups_test
