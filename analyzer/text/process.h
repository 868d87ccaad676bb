// Starts other programs: Graphviz, git. Never through a shell.
#pragma once

#include <string>
#include <vector>

namespace owlint {

struct Ran {
  bool started = false;
  int status = 0;   ///< exit status; other than 0 also where a signal ended it
  std::string out;  ///< standard output; its standard error is ours
};

/// `arguments[0]` is looked for on the PATH; `input` is its standard input.
Ran run_program(std::vector<std::string> arguments, const std::string& input);

}  // namespace owlint
