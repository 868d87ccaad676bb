// Starts other programs: Graphviz, git. Never through a shell.
#pragma once

#include <string>
#include <vector>

namespace owlint {

struct Ran {
  bool started = false;
  int status = 0;   ///< exit status; not 0 if a signal ended it
  std::string out;  ///< standard output
};

/// Looks for `arguments[0]` on the PATH; `input` is its standard input. Its standard error goes to ours, or nowhere if `quiet`.
Ran run_program(std::vector<std::string> arguments, const std::string& input, bool quiet = false);

}  // namespace owlint
