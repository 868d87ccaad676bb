// `owlint fmt` as scripts rely on it: what it writes, what it leaves alone, and its exit statuses.
#include <sys/stat.h>

#include <filesystem>

#include <catch2/catch.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace format_command_test {
namespace {

const std::string kFlat = "o1 if [#1]\nG0 X1\no1 endif\nM2\n";
const std::string kIndented = "o1 if [#1]\n  G0 X1\no1 endif\nM2\n";

}  // namespace

TEST_CASE("fmt writes files in their place", "[cli][format]") {
  const Scratch s;
  const std::string path = s.write("flat.ngc", kFlat);
  ::chmod(path.c_str(), 0640);
  CHECK(owlint::test::owlint({"fmt", path}).status == 0);
  CHECK(read_file(path) == kIndented);
  struct stat info {};
  REQUIRE(::stat(path.c_str(), &info) == 0);
  CHECK((info.st_mode & 07777) == 0640);
  // Again: nothing to do, and the file is not touched.
  const auto written = std::filesystem::last_write_time(path);
  const Run again = owlint::test::owlint({"fmt", path});
  CHECK(again.status == 0);
  CHECK(again.err.empty());
  CHECK(std::filesystem::last_write_time(path) == written);
}

TEST_CASE("fmt follows a link to the file behind it", "[cli][format]") {
  const Scratch s;
  const std::string path = s.write("flat.ngc", kFlat);
  std::filesystem::create_symlink(path, s.path() + "/link.ngc");
  CHECK(owlint::test::owlint({"fmt", s.path() + "/link.ngc"}).status == 0);
  CHECK(std::filesystem::is_symlink(s.path() + "/link.ngc"));
  CHECK(read_file(path) == kIndented);
}

TEST_CASE("fmt --check and --diff change nothing", "[cli][format]") {
  const Scratch s;
  const std::string flat = s.write("flat.ngc", kFlat);
  const std::string good = s.write("good.ngc", kIndented);
  const Run check = owlint::test::owlint({"fmt", "--check", s.path()});
  CHECK(check.status == 1);
  CHECK(check.out == "would indent " + flat + "\n");
  const Run diff = owlint::test::owlint({"fmt", "--diff", s.path()});
  CHECK(diff.status == 1);
  CHECK(diff.out ==
        "--- " + flat + "\n+++ " + flat + "\n@@ -1,4 +1,4 @@\n o1 if [#1]\n-G0 X1\n+  G0 X1\n o1 endif\n M2\n");
  CHECK(read_file(flat) == kFlat);
  CHECK(owlint::test::owlint({"fmt", "--check", good}).status == 0);
}

TEST_CASE("fmt reads standard input and says what it cannot do", "[cli][format]") {
  const Scratch s;
  CHECK(owlint::test::owlint({"fmt", "-"}, kFlat).out == kIndented);
  const Run none = owlint::test::owlint({"fmt", s.path() + "/none.ngc"});
  CHECK(none.status == 2);
  CHECK(none.err.find("cannot read") != std::string::npos);
  CHECK(owlint::test::owlint({"fmt"}).status == 2);
}

}  // namespace format_command_test
