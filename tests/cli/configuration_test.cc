// exclude, include and fail-on, in owlint.toml and on the command line.
#include <catch2/catch.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace configuration_test {
namespace {

const std::string kWarning = "o1 if [0]\no1 endif done\nM2\n";  // OW304, runs
const std::string kBad = "o1 if [1]\no1 endif\no1 if [1]\no1 endif\nM2\n";

Run check(const Scratch& folder, const std::string& arguments) {
  return owlint::test::owlint(words("check --no-find-ini " + arguments), "", folder.path());
}

/// The files in which a run found something, in their order.
std::vector<std::string> files(const Scratch& folder, const std::string& arguments) {
  std::vector<std::string> names;
  const auto report = nlohmann::json::parse(check(folder, "--format json " + arguments).out);
  for (const auto& file : report["files"]) names.push_back(file["path"]);
  return names;
}

using Names = std::vector<std::string>;

void write_shop(const Scratch& folder) {
  for (const char* name : {"a.ngc", "old/b.ngc", "parts/c.ngc", "parts/old/d.ngc", "parts/e.txt", "parts/f.nc"})
    folder.write(name, kWarning);
}

}  // namespace

TEST_CASE("exclude and include are seen from the folder of owlint.toml", "[cli][configuration]") {
  const Scratch s;
  write_shop(s);
  CHECK(files(s, ".") == Names{"a.ngc", "old/b.ngc", "parts/c.ngc", "parts/f.nc", "parts/old/d.ngc"});
  s.write("owlint.toml", "exclude = [\"old/\"]\n");
  CHECK(files(s, ".") == Names{"a.ngc", "parts/c.ngc", "parts/f.nc"});
  s.write("owlint.toml", "exclude = [\"/old/\", \"*.nc\"]\ninclude = [\"parts/*.txt\"]\n");
  CHECK(files(s, ".") == Names{"a.ngc", "parts/c.ngc", "parts/e.txt", "parts/old/d.ngc"});
  CHECK(files(s, "parts") == Names{"parts/c.ngc", "parts/e.txt", "parts/old/d.ngc"});  // also from further below
  CHECK(files(s, "--isolated parts") == Names{"parts/c.ngc", "parts/f.nc", "parts/old/d.ngc"});
  // What is named is checked.
  CHECK(files(s, "parts/f.nc old") == Names{"parts/f.nc", "old/b.ngc"});
  CHECK(files(s, "--force-exclude a.ngc parts/f.nc old/b.ngc") == Names{"a.ngc"});  // except for hooks
  // The nearest configuration counts, and no other.
  s.write("parts/owlint.toml", "exclude = [\"old/d.ngc\"]\n");
  CHECK(files(s, ".") == Names{"a.ngc", "parts/c.ngc", "parts/f.nc"});
  // It wins over ignore files.
  s.write(".gitignore", "*.ngc\n");
  s.write("owlint.toml", "exclude = [\"!a.ngc\"]\n");
  CHECK(files(s, "--config owlint.toml .") == Names{"a.ngc", "parts/f.nc"});
}

TEST_CASE("exclude and include of the command line add to the configuration's", "[cli][configuration]") {
  const Scratch s;
  write_shop(s);
  s.write("owlint.toml", "exclude = [\"/old/\"]\n");
  CHECK(files(s, "--exclude *.nc .") == Names{"a.ngc", "parts/c.ngc", "parts/old/d.ngc"});
  CHECK(files(s, "--exclude parts/old .") == Names{"a.ngc", "parts/c.ngc", "parts/f.nc"});
  CHECK(files(s, "--exclude parts/old parts") == Names{"parts/c.ngc", "parts/f.nc"});  // seen from the working folder
  CHECK(files(s, "--exclude /old parts") == Names{"parts/c.ngc", "parts/f.nc"});  // and from the one that is searched
  CHECK(files(s, "--include *.txt parts") == Names{"parts/c.ngc", "parts/e.txt", "parts/f.nc", "parts/old/d.ngc"});
  CHECK(files(s, "--exclude !old .") == Names{"a.ngc", "old/b.ngc", "parts/c.ngc", "parts/f.nc", "parts/old/d.ngc"});
}

TEST_CASE("a folder of which everything is excluded has no programs", "[cli][configuration]") {
  const Scratch s;
  write_shop(s);
  s.write("owlint.toml", "exclude = [\"*\"]\n");
  CHECK(check(s, ".").status == 2);
  CHECK(check(s, "--allow-empty .").status == 0);
}

TEST_CASE("fmt and audit search folders in the same way", "[cli][configuration]") {
  const Scratch s;
  s.write("a.ngc", "o1 if [1]\nG0\no1 endif\nM2\n");
  s.write("old/b.ngc", "o1 if [1]\nG0\no1 endif\nM2\n");
  s.write("owlint.toml", "exclude = [\"old\"]\nfail-on = \"warning\"\n");
  CHECK(owlint::test::owlint({"fmt", "--check", "."}, "", s.path()).out == "would indent a.ngc\n");
  s.write("a.ngc", kWarning);
  s.write("old/b.ngc", kBad);
  const Run audit = owlint::test::owlint({"audit", ".", "--no-find-ini"}, "", s.path());
  CHECK(audit.err.find("run 1: 1 program, all analysed") != std::string::npos);
  CHECK(audit.status == 1);  // by fail-on
  CHECK(owlint::test::owlint({"audit", ".", "--no-find-ini", "--fail-on", "error"}, "", s.path()).status == 0);
}

TEST_CASE("fail-on holds for the files of its folder", "[cli][configuration]") {
  const Scratch s;
  s.write("strict/p.ngc", kWarning);
  s.write("loose/p.ngc", kWarning);
  s.write("strict/owlint.toml", "fail-on = \"warning\"\n");
  CHECK(check(s, "loose").status == 0);
  CHECK(check(s, "strict").status == 1);
  CHECK(check(s, ".").status == 1);
  CHECK(check(s, "--fail-on error .").status == 0);  // the command line wins
  CHECK(check(s, "--isolated .").status == 0);
  CHECK(owlint::test::owlint({"config", "strict"}, "", s.path())
            .out.find("fail-on          warning                  # strict/owlint.toml:1\n") != std::string::npos);
  CHECK(owlint::test::owlint({"config", "loose"}, "", s.path())
            .out.find("fail-on          error                    # default\n") != std::string::npos);
}

TEST_CASE("the folders of an INI that are not here are one finding", "[cli][configuration]") {
  const Scratch s;
  s.write("p.ngc", "M2\n");
  s.write("machine.ini", "[DISPLAY]\nPROGRAM_PREFIX = none\n[RS274NGC]\nSUBROUTINE_PATH = gone:.:away\n");
  const auto report = nlohmann::json::parse(check(s, "--isolated --format json --ini machine.ini p.ngc").out);
  REQUIRE(report["files"].size() == 2);
  const auto& findings = report["files"][1]["findings"];
  REQUIRE(findings.size() == 1);
  CHECK(findings[0]["code"] == "OW407");
  CHECK(findings[0]["start"]["line"] == 2);
  REQUIRE(findings[0]["related"].size() == 2);
  CHECK(findings[0]["related"][0]["start"]["column"] == 19);
  CHECK(findings[0]["related"][1]["start"]["column"] == 26);
}

}  // namespace configuration_test
