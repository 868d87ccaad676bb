// What owlint says of a command line that is wrong, and its help.
#include <filesystem>

#include <catch2/catch.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace usage_test {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The message for a command line that is wrong.
std::string message(const std::string& arguments, const std::string& folder = {}) {
  const Run run = owlint::test::owlint(words(arguments), "", folder);
  INFO(arguments << "\n" << run.out << run.err);
  CHECK(run.status == 2);
  CHECK(run.out.empty());
  CHECK(run.err.starts_with("owlint: "));
  CHECK(std::ranges::count(run.err, '\n') == 1);
  return run.err.starts_with("owlint: ") ? run.err.substr(8, run.err.size() - 9) : run.err;
}

}  // namespace

TEST_CASE("usage errors have one voice", "[cli][usage]") {
  const Scratch s;
  s.write("good.ngc", "M2\n");
  const auto said = [&](const std::string& arguments) { return message(arguments, s.path()); };
  CHECK(contains(said("check"), "`owlint check` needs PATH: programs, folders"));
  CHECK(said("graph") == "`owlint graph` needs FILE: the program");
  CHECK(contains(said("explain"), "`owlint explain` needs CODE: "));
  CHECK(contains(said("audit"), "`owlint audit` needs PATH: "));
  CHECK(contains(said("audit diff a"), "`owlint audit diff` needs B: "));
  CHECK(contains(said("audit export"), "`owlint audit export` needs --format: "));
  CHECK(said("graph good.ngc more.ngc") == "`owlint graph` does not take `more.ngc`; see `owlint graph --help`");
  CHECK(said("rules more") == "`owlint rules` does not take `more`; see `owlint rules --help`");
  CHECK(said("good.ngc --ini") == "--ini needs a value: FILE");
  CHECK(said("--jobs 1 --jobs 2 good.ngc") == "--jobs is given more than once");
  CHECK(said("--fix=maybe good.ngc") == "--fix takes no value");
  CHECK(said("--jobs many good.ngc") == "--jobs: `many` is not a number such as 4");
  CHECK(said("--jobs 0 good.ngc") == "--jobs: `0` is not a number such as 4");
  CHECK(said("--versoin") == "unknown option `--versoin`, did you mean `owlint --version`?");
  CHECK(said("graf good.ngc") == "there is no command and no file `graf`, did you mean `owlint graph`?");
  CHECK(said("--reason known good.ngc") == "--reason goes with --add-suppressions");
  CHECK(said("--jobs=-1 good.ngc") == "--jobs: `-1` is not a number such as 4");
  CHECK(said("--feature many good.ngc") == "--feature: `many` is not a number such as 32 or 0x20");
  CHECK(said("--fail-on fatal good.ngc") == "--fail-on: `fatal` is none of error, warning, info");
  CHECK(said("--color alwys good.ngc") == "--color: `alwys` is none of auto, always, never; did you mean `always`?");
  CHECK(said("--linuxcnc 2.6 good.ngc").starts_with("--linuxcnc: `2.6` is none of 2.7, 2.8, 2.9, 2.10, all"));
  CHECK(said("graph --format pgn good.ngc").starts_with("--format: `pgn` is none of dot, mermaid, json, svg"));
  CHECK(said("--select OW1O4 good.ngc") == "--select: there is no rule `OW1O4`, did you mean `OW104`?");
  CHECK(said("--ignore OW104,if-lable-reused good.ngc") ==
        "--ignore: there is no rule `if-lable-reused`, did you mean `if-label-reused`?");
  CHECK(said("--severity OW104 good.ngc") ==
        "--severity: `OW104` is not CODE=LEVEL with a level of off, info, warning or error");
  CHECK(said("--severity OW104=fatal good.ngc") ==
        "--severity: `OW104=fatal` is not CODE=LEVEL with a level of off, info, warning or error");
  CHECK(said("--severity OW999=off good.ngc") == "--severity: there is no rule `OW999`; `owlint rules` lists them");
  CHECK(said("config --show --check .") == "--show and --check do not go together");
  CHECK(said("--config none.toml good.ngc") == "cannot read none.toml: No such file or directory");
  CHECK(said("config --check none.toml") == "cannot read none.toml: No such file or directory");
  CHECK(said("config none") == "there is no none");
  CHECK(said("--ini good.ngc good.ngc") == "good.ngc is not a machine INI: it has no [SECTION]");
  CHECK(said("--sub-path none good.ngc") == "--sub-path: there is no folder none");
}

TEST_CASE("a misspelt command or option names the nearest", "[cli][usage]") {
  const Scratch s;
  s.write("good.ngc", "M2\n");
  const auto said = [&](const std::string& arguments) { return message(arguments, s.path()); };
  CHECK(said("chekc good.ngc") == "there is no command and no file `chekc`, did you mean `owlint check`?");
  CHECK(said("explian OW101") == "there is no command and no file `explian`, did you mean `owlint explain`?");
  CHECK(said("lint good.ngc") == "there is no command and no file `lint`, did you mean `owlint check`?");
  CHECK(said("fix good.ngc") == "there is no command and no file `fix`; `owlint --fix PATH` makes the safe fixes");
  CHECK(said("-x good.ngc") == "unknown option `-x`; `--help` lists all, and what comes after `--` is a path");
  CHECK(said("--linuxcnc 2.9.4 good.ngc") ==
        "--linuxcnc: `2.9.4` is none of 2.7, 2.8, 2.9, 2.10, all; did you mean `2.9`?");
  CHECK(said("--severity OW104=warn good.ngc") ==
        "--severity: `OW104=warn` is not CODE=LEVEL with a level of off, info, warning or error; did you mean "
        "`OW104=warning`?");
  CHECK(said("audit lst") == "there is no lst, did you mean `owlint audit list`?");
  CHECK(said("check --selct OW1 good.ngc") == "unknown option `--selct`, did you mean `--select`?");
  CHECK(said("fmt --chekc good.ngc") == "unknown option `--chekc`, did you mean `--check`?");
  CHECK(said("audit show --stor x.db") == "unknown option `--stor`, did you mean `--store`?");
  CHECK(said("--sub-pth=x good.ngc") == "unknown option `--sub-pth=x`, did you mean `--sub-path`?");
  CHECK(said("explain if-lable-reused") == "there is no rule `if-lable-reused`, did you mean `if-label-reused`?");
  // A file of that name is a program.
  s.write("chekc", "M2\n");
  CHECK(owlint::test::owlint({"--isolated", "chekc"}, "", s.path()).status == 0);
}

TEST_CASE("the beginning of codes, or a word of names, lists rules", "[cli][usage]") {
  const auto listed = [](const std::string& about) {
    const Run run = owlint::test::owlint({"explain", about}, "");
    CHECK(run.status == 0);
    return run.out;
  };
  CHECK(contains(listed("ow10"), "  OW108  loop-end-mismatch"));
  CHECK_FALSE(contains(listed("OW10"), "OW201"));
  CHECK(contains(listed("arc"), "  OW901  arc-radii-differ"));
  CHECK_FALSE(contains(listed("arc"), "search"));
}

TEST_CASE("codes are taken in small letters and as names, wherever codes are taken", "[cli][codes]") {
  const Scratch s;
  const std::string bad = s.write("bad.ngc", "o1 if [1]\no1 endif\no1 if [1]\no1 endif\nM2\n");  // OW104
  const auto status = [&](const std::string& arguments) {
    return owlint::test::owlint(words(arguments + " bad.ngc"), "", s.path()).status;
  };
  CHECK(status("--isolated --select if-label-reused") == 1);
  CHECK(status("--isolated --select ow104") == 1);
  CHECK(status("--isolated --select ow2") == 0);
  CHECK(status("--isolated --ignore If-Label-Reused") == 0);
  CHECK(status("--isolated --select ow2 --extend-select if-label-reused") == 1);
  CHECK(status("--isolated --severity if-label-reused=warning") == 0);
  CHECK(status("--isolated --severity ow1=info") == 0);
  for (const char* text :
       {"ignore = [\"ow104\"]\n", "ignore = [\"if-label-reused\"]\n", "[severity]\nif-label-reused = \"off\"\n",
        "[[overrides]]\nfiles = [\"*\"]\nignore = [\"ow1\"]\n"}) {
    INFO(text);
    s.write("owlint.toml", text);
    CHECK(status("check") == 0);
  }
}

TEST_CASE("help is laid out for people", "[cli][usage]") {
  for (const char* command : {"", "check", "graph", "explain", "rules", "fmt", "lsp", "config", "audit", "audit list",
                              "audit show", "audit export", "audit diff", "audit merge"}) {
    const Run run = owlint::test::owlint(words(std::string(command) + " --help"));
    INFO(run.out);
    CHECK(run.status == 0);
    CHECK(run.err.empty());
    for (const char* rest : {"{", "}", "TEXT:", "[OPTIONS] SUBCOMMAND", "Positionals", "REQUIRED"})
      CHECK_FALSE(contains(run.out, rest));
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
  }
  const std::string help = owlint::test::owlint({"check", "--help"}).out;
  CHECK(contains(help, "  --format FORMAT           the form of the report: text, grouped, gcc, "));
  CHECK(contains(help, "(default: text)"));
  CHECK(contains(help, "  --find-ini, --no-find-ini\n"));
  CHECK(owlint::test::owlint({"help"}).out == owlint::test::owlint({"--help"}).out);
  CHECK(owlint::test::owlint({"help", "check"}).out == help);
}

TEST_CASE("values may have capitals and blanks around them", "[cli][usage]") {
  const Scratch s;
  s.write("good.ngc", "M2\n");
  const auto runs = [&](const std::vector<std::string>& arguments) {
    const Run run = owlint::test::owlint(arguments, "", s.path());
    INFO(run.err);
    CHECK(run.status == 0);
  };
  runs({"check", "--select", "OW104, OW105", "good.ngc"});
  runs({"check", "--fail-on", "INFO", "good.ngc"});
  runs({"check", "--severity", "OW104=off, OW105=Info", "good.ngc"});
}

}  // namespace usage_test
