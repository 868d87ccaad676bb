// Programs as shops write them: nothing in the sound ones, one finding in the others.
#include <set>

#include <catch2/catch.hpp>

#include "support/corpus.h"
#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

TEST_CASE("the corpus has what its programs say and nothing else", "[corpus]") {
  const std::vector<CorpusProgram> programs = corpus();
  REQUIRE(programs.size() >= 40);
  std::vector<std::string> paths;
  for (const CorpusProgram& program : programs) paths.push_back(program.path);
  const nlohmann::json files = check_files(paths, "");
  for (size_t i = 0; i < programs.size(); ++i) {
    const nlohmann::json& findings = files[i]["findings"];
    INFO(programs[i].path << "\n" << findings.dump(2));
    if (programs[i].sound) {
      CHECK(findings.empty());
      continue;
    }
    REQUIRE(findings.size() == 1);
    CHECK(findings[0]["code"].get<std::string>() == programs[i].code);
    CHECK(findings[0]["start"]["line"].get<int>() == programs[i].line);
  }
}

TEST_CASE("the corpus holds sound and unsound programs that show different things", "[corpus]") {
  std::set<std::string> shown;
  size_t sound = 0;
  for (const CorpusProgram& program : corpus()) {
    INFO(program.path);
    CHECK(shown.insert(program.shows).second);
    if (program.sound) ++sound;
  }
  CHECK(sound >= 20);
  CHECK(shown.size() - sound >= 15);
}
