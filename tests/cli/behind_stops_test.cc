// A line at which every run stops does not hide the mistakes behind it, not even where it is suppressed.
#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace behind_stops_test {
namespace {

/// The findings of a program: line, code and severity, and how many other places each one names, that of the stop
/// included.
std::string found(const std::string& program, const std::string& options = "") {
  const Scratch folder;
  folder.write("a.ngc", program);
  const Run run =
      owlint::test::owlint(words("check --isolated --format json " + options + " a.ngc"), "", folder.path());
  const nlohmann::json report = nlohmann::json::parse(run.out);
  std::string out;
  for (const auto& file : report["files"]) {
    for (const auto& f : file["findings"]) {
      out += fmt::format("{} {} {} {}\n", f["start"]["line"].get<int>(), f["code"].get<std::string>(),
                         f["severity"].get<std::string>(), f["related"].size());
    }
  }
  return out;
}

}  // namespace

TEST_CASE("what is behind a stop is reported, but for what may come of it", "[behind]") {
  CHECK(found("G21 G90\nM13\nG1 X5\nG81 X1\nX1 X2\nM2\nG4\n") == "2 OW705 error 0\n5 OW704 warning 2\n");
}

// Who suppresses it says that the line runs on the machine.
TEST_CASE("a suppressed stop hides nothing, and what is behind it are errors", "[behind]") {
  const std::string program =
      "G21 G90\n(owlint: ignore OW705 because the machine has it)\nM13\n"
      "(owlint: ignore OW801 because the machine keeps the feed)\nG1 X5\nM17\nM2\n";
  CHECK(found(program) == "6 OW705 error 0\n");
  CHECK(found("G21 G90\nG0 X1 X2\nM17\nM2\n", "--ignore OW704") == "3 OW705 error 0\n");
}

TEST_CASE("the same mistake again is one more place", "[behind]") {
  CHECK(found("G21 G90\nM13\nG0 X1\nM13\nM13\nM2\n") == "2 OW705 error 2\n");
}

TEST_CASE("subs that are called behind a stop are looked at, and others are not", "[behind]") {
  CHECK(found("G21 G90\no1 sub\nX1 X2\no1 endsub\no2 sub\nX1 X3\no2 endsub\nM13\no1 call\nM2\n", "--ignore OW6") ==
        "3 OW704 warning 2\n8 OW705 error 0\n");
}

}  // namespace behind_stops_test
