// From paths on the command line to files.
#pragma once

#include <string>
#include <vector>

namespace owlint::cli {

struct Walk {
  std::vector<std::string> files;     ///< in the order in which they are reported; each once
  std::vector<std::string> problems;  ///< messages for people, about paths that cannot be read
  std::vector<std::string> empty;     ///< folders without programs
};

/// Files are taken whatever their name; folders are searched for *.ngc *.nc *.tap *.cnc *.gcode in any case, sorted,
/// without hidden folders, and without following links to folders.
Walk walk(const std::vector<std::string>& paths);

}  // namespace owlint::cli
