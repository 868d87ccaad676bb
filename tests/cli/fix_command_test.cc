// `--fix`, `--diff`, `--fix-only`, `--add-suppressions` as scripts rely on them.
#include <sys/stat.h>

#include <filesystem>

#include <catch2/catch.hpp>

#include "analyzer/findings/edits.h"
#include "analyzer/text/replace.h"
#include "support/damage.h"
#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace fix_command_test {
namespace {

const std::string kTwice =
    "G21 G90\no100 if [#5070 EQ 0]\n  G0 X1\no100 endif\no100 if [#5070 EQ 1]\n  G0 X3\no100 endif\nM2\n";
const std::string kFixed =
    "G21 G90\no100 if [#5070 EQ 0]\n  G0 X1\no100 endif\no101 if [#5070 EQ 1]\n  G0 X3\no101 endif\nM2\n";
const std::string kInLoop =
    "o100 while [#5070 EQ 0]\n  o200 sub\n    G0 X#1\n  o200 endsub\n  o200 call [1]\no100 endwhile\nM2\n";

Run check(std::vector<std::string> arguments, const std::string& input = {}) {
  arguments.insert(arguments.begin(), {"check", "--no-find-ini"});
  return owlint::test::owlint(arguments, input);
}

std::string crlf(std::string text) {
  for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, 1, '\r');
  return text;
}

}  // namespace

TEST_CASE("option --fix fixes files in their place and keeps their mode, line ends and bytes", "[cli][fix]") {
  const Scratch s;
  const std::string path = s.write("twice.ngc", crlf("(B\xFCgel)\n" + kTwice));
  ::chmod(path.c_str(), 0640);
  const Run run = check({"--fix", path});
  CHECK(run.status == 0);
  CHECK(run.err == "fixed 1 finding in 1 file\nnothing found in 1 file\n");
  CHECK(read_file(path) == crlf("(B\xFCgel)\n" + kFixed));
  struct stat info {};
  REQUIRE(::stat(path.c_str(), &info) == 0);
  CHECK((info.st_mode & 07777) == 0640);
  const auto written = std::filesystem::last_write_time(path);
  CHECK(check({"--fix", path}).err == "nothing fixed\nnothing found in 1 file\n");
  CHECK(std::filesystem::last_write_time(path) == written);
}

TEST_CASE("option --fix leaves what is not safe, and says how to get it", "[cli][fix]") {
  const Scratch s;
  const std::string path = s.write("loop.ngc", kInLoop);
  const Run safe = check({"--fix", path});
  CHECK(safe.status == 1);
  CHECK(safe.err.find("1 can be fixed with --fix --unsafe") != std::string::npos);
  CHECK(read_file(path) == kInLoop);
  CHECK(check({"--fix", "--unsafe", path}).status == 0);
  CHECK(read_file(path) ==
        "  o200 sub\n    G0 X#1\n  o200 endsub\no100 while [#5070 EQ 0]\n  o200 call [1]\no100 endwhile\nM2\n");
}

TEST_CASE("option --diff changes nothing and can be applied by patch", "[cli][fix]") {
  const Scratch s;
  const std::string path = s.write("twice.ngc", kTwice);
  const Run run = check({"--diff", path});
  CHECK(run.status == 1);
  CHECK(run.out ==
        "--- " + path + "\n+++ " + path +
            "\n@@ -2,7 +2,7 @@\n o100 if [#5070 EQ 0]\n   G0 X1\n o100 endif\n-o100 if [#5070 EQ 1]\n+o101 if [#5070 "
            "EQ 1]\n   G0 X3\n-o100 endif\n+o101 endif\n M2\n");
  CHECK(read_file(path) == kTwice);
  CHECK(check({"--fix-only", path}).out.empty());
  CHECK(check({"--diff", path}).status == 0);
}

TEST_CASE("option --fix-only reports nothing, whatever is left", "[cli][fix]") {
  const Scratch s;
  const std::string path = s.write("loop.ngc", kInLoop + "");
  const Run run = check({"--fix-only", path});
  CHECK(run.status == 0);
  CHECK(run.out.empty());
}

TEST_CASE("option --fix of standard input writes the program to standard output, findings beside it", "[cli][fix]") {
  const Run run = check({"--fix", "-"}, kTwice);
  CHECK(run.status == 0);
  CHECK(run.out == kFixed);
  const Run left = check({"--fix", "-"}, kInLoop);
  CHECK(left.status == 1);
  CHECK(left.out == kInLoop);
  CHECK(left.err.find("OW203") != std::string::npos);
}

TEST_CASE("a fixed sub file counts for the programs that call it", "[cli][fix]") {
  const Scratch s;
  s.write("main.ngc", "o<face> call [1]\nM2\n");
  s.write("face.ngc",
          "o<face> sub\n  o100 if [#1 EQ 1]\n    G0 X1\n  o100 endif\n  o100 if [#1 EQ 1]\n    G0 X2\n  o100 "
          "endif\no<face> endsub\n");
  CHECK(check({s.path()}).status == 1);
  CHECK(check({"--fix", s.path()}).status == 0);
  CHECK(check({s.path()}).status == 0);
}

TEST_CASE("only files that were named are fixed", "[cli][fix]") {
  const Scratch s;
  const std::string face =
      "o<face> sub\n  o100 if [#1 EQ 1]\n    G0 X1\n  o100 endif\n  o100 if [#1 EQ 1]\n    G0 X2\n  o100 "
      "endif\no<face> endsub\n";
  s.write("face.ngc", face);
  CHECK(check({"--fix", s.write("main.ngc", "o<face> call [1]\nM2\n")}).status == 1);
  CHECK(read_file(s.path() + "/face.ngc") == face);
}

TEST_CASE("a file that has changed meanwhile is left alone", "[cli][fix]") {
  const Scratch s;
  const std::string path = s.write("a.ngc", "new\n");
  std::string error;
  CHECK(!owlint::replace_unchanged(path, "old\n", "fixed\n", &error));
  CHECK(error == "it has changed in the meantime, so it is not replaced");
  CHECK(read_file(path) == "new\n");
  CHECK(owlint::replace_unchanged(path, "new\n", "fixed\n", &error));
  CHECK(read_file(path) == "fixed\n");
}

TEST_CASE("options of fixing that do not go together", "[cli][fix]") {
  CHECK(check({"--unsafe", "x.ngc"}).status == 2);
  CHECK(check({"--add-suppressions", "x.ngc"}).status == 2);
  CHECK(check({"--update-baseline", "x.ngc"}).status == 2);
}

TEST_CASE("fixes that touch each other are made in different rounds", "[fix]") {
  using owlint::Finding;
  const auto finding = [](uint64_t begin, uint64_t end, bool safe) {
    Finding f;
    f.fixes = {{"fix", safe, {{{begin, end}, "x"}}}};
    return f;
  };
  const owlint::Round safe = owlint::round_of_fixes(
      {finding(0, 2, true), finding(2, 3, true), finding(4, 5, false), finding(6, 7, true)}, false);
  CHECK(safe.made == 2);
  CHECK(owlint::apply_edits("0123456789", safe.edits) == "x2345x789");
  CHECK(owlint::round_of_fixes({finding(4, 5, false), finding(4, 4, true)}, true).made == 1);
}

TEST_CASE("fixing comes to an end, and a second time there is nothing to fix", "[fix]") {
  std::mt19937 random(20261124);
  const auto all = all_programs();
  const Scratch s;
  std::vector<std::string> paths;
  for (int i = 0; i < 400; ++i) {
    std::string text = all[std::uniform_int_distribution<size_t>(0, all.size() - 1)(random)].second;
    if (i % 4 != 0) text = damaged(text, random);
    paths.push_back(s.write(std::to_string(i) + ".ngc", text));
  }
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--fix-only"}, {"--fix-only", "--unsafe"}}) {
    std::vector<std::string> arguments = options;
    arguments.insert(arguments.end(), {"--extend-select", "OW", s.path()});
    const Run first = check(arguments);
    INFO(first.err);
    CHECK(first.status == 0);
    CHECK(check(arguments).err == "nothing fixed\n");
  }
}

TEST_CASE("option --add-suppressions suppresses what is found, and changes nothing else", "[cli][suppression]") {
  const Scratch s;
  const std::string path = s.write("twice.ngc", kTwice);
  const Run run = check({"--add-suppressions", "--reason", "runs on the old mill", path});
  CHECK(run.status == 0);
  CHECK(run.err == "suppressed 1 finding\n");
  std::string expected = kTwice;
  expected.insert(expected.find("o100 if [#5070 EQ 1]"), "(owlint: ignore OW104 because runs on the old mill)\n");
  CHECK(read_file(path) == expected);
  CHECK(check({path}).status == 0);
}

TEST_CASE("a comment never comes before the % that begins a program", "[cli][suppression]") {
  const Scratch s;
  const std::string path = s.write("percent.ngc", "%\nG0 X1\n");
  check({"--extend-select", "OW", "--add-suppressions", "--reason", "(old)", path});
  CHECK(read_file(path).starts_with("%\n"));
}

TEST_CASE("what --fix cannot write is still there, and is reported", "[cli][fix]") {
  const Scratch s;
  ::chmod(s.path().c_str(), 0755);
  const auto fails = [&](const std::string& script, const std::string& reason) {
    const Run run = shell(script, s.path());
    INFO(run.out << run.err);
    CHECK(run.status == 2);
    CHECK(run.err.find("owlint: cannot write bad.ngc: " + reason + "\n") == 0);
    CHECK(run.out.find("bad.ngc:5:1: error") == 0);
    CHECK(read_file(s.path() + "/bad.ngc") == kTwice);
    CHECK(files_below(s.path()).size() ==
          (std::filesystem::exists(s.path() + "/other.ngc") ? 2 : 1));  // no rest of a try
    return run;
  };
  s.write("bad.ngc", kTwice);
  if (OWLINT_PATIENCE == 1) {  // the sanitizers' OpenMP needs a file of its own to start
    // The file gets no longer than nothing: a full disk.
    const Run full = fails(
        "set -o pipefail; { (trap '' XFSZ; ulimit -f 0; exec $OWLINT --isolated --no-find-ini --fix bad.ngc 2>&1 >&3) "
        "| cat >&2; } 3>&1 | cat",
        "File too large");
    CHECK(full.err.find("nothing fixed") == std::string::npos);
    CHECK(full.err.find("1 error in 1 file\n1 can be fixed with --fix\n") != std::string::npos);
  }
  if (::geteuid() != 0) return;  // root may write everything, and becomes somebody else for this
  const std::string as_nobody =
      "setpriv --reuid 65534 --regid 65534 --clear-groups $OWLINT --isolated --no-find-ini --fix ";
  fails(as_nobody + "bad.ngc", "Permission denied");
  // The rest is still fixed.
  s.write("other.ngc", kTwice);
  ::chmod((s.path() + "/other.ngc").c_str(), 0666);
  const Run folder = fails(as_nobody + "bad.ngc other.ngc", "Permission denied");
  CHECK(folder.err.find("owlint: cannot write other.ngc: no file can be made in its folder: Permission denied\n") !=
        std::string::npos);
  ::chmod(s.path().c_str(), 0777);
  const Run other = fails(as_nobody + "bad.ngc other.ngc", "Permission denied");
  CHECK(other.err.find("fixed 1 finding in 1 file\n1 error in 2 files\n") != std::string::npos);
  CHECK(read_file(s.path() + "/other.ngc") == kFixed);
}

TEST_CASE("two names of one file are fixed once", "[cli][fix]") {
  const Scratch s;
  const std::string path = s.write("twice.ngc", kTwice);
  std::filesystem::create_symlink("twice.ngc", s.path() + "/link.ngc");
  const Run run = check({"--fix", path, s.path() + "/link.ngc"});
  CHECK(run.status == 0);
  CHECK(read_file(path) == kFixed);
  CHECK(std::filesystem::is_symlink(s.path() + "/link.ngc"));
}

TEST_CASE("a fixed program that cannot be put out is an error", "[cli][fix]") {
  const Scratch s;
  s.write("twice.ngc", kTwice);
  const Run full = shell("owlint --isolated --fix - < twice.ngc > /dev/full", s.path());
  CHECK(full.status == 2);
  CHECK(full.err.find("owlint: cannot write to standard output\n") != std::string::npos);
  CHECK(shell("owlint --isolated twice.ngc > /dev/full", s.path()).status == 2);
  CHECK(shell("owlint explain OW101 > /dev/full", s.path()).status == 2);
}

TEST_CASE("standard input that needs no suppression is put out as it is", "[cli][suppression]") {
  CHECK(check({"--add-suppressions", "--reason", "old", "-"}, kFixed).out == kFixed);
}

TEST_CASE("a fix in a called file names the file to give", "[cli][fix]") {
  const Scratch s;
  s.write("main.ngc", "o<twice> call\nM2\n");
  s.write("twice.ngc",
          "o<twice> sub\no100 if [#5070 EQ 0]\n  G0 X1\no100 endif\no100 if [#5070 EQ 1]\n  G0 X3\n"
          "o100 endif\no<twice> endsub\n");
  const auto check_here = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"check", "--no-find-ini"});
    return owlint::test::owlint(arguments, "", s.path());
  };
  const Run run = check_here({"main.ngc"});
  INFO(run.out << run.err);
  CHECK(run.err.find("can be fixed with --fix\n") == std::string::npos);
  CHECK(run.err.find("1 in twice.ngc, which was not named, can be fixed with --fix twice.ngc\n") != std::string::npos);
  CHECK(check_here({"--fix", "twice.ngc"}).err.find("fixed 1 finding in 1 file\n") == 0);
}

}  // namespace fix_command_test
