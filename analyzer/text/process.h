// Other programs are started here, Graphviz and git, never through a shell; and which program this is.
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

/// The file that this program was started from; empty if that cannot be told.
std::string own_program();

}  // namespace owlint
