// `owlint debug-flow`: the states at each line and why they were joined, for those who work on the analysis.
#include <catch2/catch.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace debug_flow_test {
namespace {

const std::string kProgram =
    "o1 if [#5061 GT 0]\n#<a> = 1\no1 elseif [#5062 GT 0]\n#<a> = 3\no1 else\n#<a> = 2\no1 endif\n"
    "o2 while [#<a> GT 1]\n#<a> = 1\no2 endwhile\nM2\n";

std::string debugged(const Scratch& folder, const std::string& options) {
  folder.write("p.ngc", kProgram);
  const Run run = owlint::test::owlint(words("debug-flow p.ngc " + options), "", folder.path());
  CHECK(run.err.empty());
  CHECK(run.status == 0);
  return run.out;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("debug-flow prints the states at each line", "[debug]") {
  const Scratch folder;
  const std::string text = debugged(folder, "");
  CHECK(contains(text, "p.ngc:1: o1 if [#5061 GT 0]\n  step 0: call 0\n"));
  CHECK(contains(text, "(true)"));
  CHECK(contains(text, "#<a> 1"));
  CHECK(contains(text, "#<a> 2"));
  CHECK(contains(text, "p.ngc:11: M2\n"));
  CHECK(contains(text, " 0 states joined\n"));
}

TEST_CASE("debug-flow says why states were joined", "[debug]") {
  const Scratch folder;
  const std::string text = debugged(folder, "--states 1");
  CHECK(contains(text, "joined: 1 states are kept apart here, and the limit after "));
  CHECK(contains(text, ", joined, "));
}

TEST_CASE("debug-flow is for those who work on the analysis: no help and no completion shows it", "[debug]") {
  const Scratch folder;
  CHECK_FALSE(contains(owlint::test::owlint({"--help"}).out, "debug-flow"));
  REQUIRE(owlint::test::owlint({"generate", "out"}, "", folder.path()).status == 0);
  for (const std::string& path : files_below(folder.path() + "/out")) {
    INFO(path);
    CHECK_FALSE(contains(read_file(path), "debug-flow"));
  }
  CHECK(owlint::test::owlint(words("debug-flow missing.ngc"), "", folder.path()).status == 2);
}

}  // namespace debug_flow_test
