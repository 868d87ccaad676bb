// The programs of the corpus and what their first lines say of them.
#pragma once

#include <string>
#include <vector>

namespace owlint::test {

struct CorpusProgram {
  std::string path;
  std::string shows;
  bool sound = false;
  std::string code;  ///< of its one finding
  int line = 0;
};

/// All programs of the corpus; fails the test where one does not say what it is.
std::vector<CorpusProgram> corpus();

}  // namespace owlint::test
