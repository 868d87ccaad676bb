#include "support/corpus.h"

#include <regex>

#include <catch2/catch.hpp>

#include "support/files.h"

namespace owlint::test {

std::vector<CorpusProgram> corpus() {
  std::vector<CorpusProgram> programs;
  for (const std::string& path : files_below(repository("corpus"))) {
    if (!path.ends_with(".ngc")) continue;
    CorpusProgram program;
    program.path = path;
    const std::string text = read_file(path);
    std::smatch match;
    INFO(path);
    REQUIRE(std::regex_search(text, match, std::regex("(^|\n); shows: ([^\r\n]+)")));
    program.shows = match[2];
    REQUIRE(std::regex_search(text, match, std::regex("(^|\n); corpus: (sound|(OW[0-9]+) at ([0-9]+))\r?\n")));
    program.sound = match[2] == "sound";
    if (!program.sound) {
      program.code = match[3];
      program.line = std::stoi(match[4]);
    }
    programs.push_back(program);
  }
  return programs;
}

}  // namespace owlint::test
