// owlint for C++ programs: checks the text of a program for LinuxCNC and gives the findings. Find it with CMake's
// find_package(owlint) and link owlint::owlint; examples/check.cc is a whole program.
//
// Any number of threads may check at the same time. Lines and columns count from 1, columns in code points; offsets count
// bytes from 0; ends are exclusive.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace owlint::api {

enum class Severity { kInfo, kWarning, kError };

/// As the options of `owlint check`; empty where not given.
struct Options {
  std::string path;      ///< what the program is called; its folder is where called files are looked for without an INI
  std::string ini;       ///< INI of the machine
  std::string linuxcnc;  ///< 2.7, 2.8, 2.9, 2.10 or all
  std::string feature;   ///< FEATURE mask, as 32 or 0x20
};

struct Place {
  unsigned line = 1;
  unsigned column = 1;
  std::size_t offset = 0;
};

struct Finding {
  std::string code;         ///< OW104
  std::string rule;         ///< if-label-reused
  Severity severity{};
  bool stops = false;       ///< LinuxCNC stops here with this error, on some run at least
  std::string message;      ///< what was seen
  std::string interpreter;  ///< what LinuxCNC prints; may be empty
  std::string help;         ///< how to fix it; may be empty
  Place begin, end;
};

/// The findings in a program, ordered by place. Throws std::invalid_argument where the options are wrong, or the INI cannot
/// be read.
std::vector<Finding> check(std::string_view text, const Options& options = {});

/// 0.1.0
std::string_view version();

}  // namespace owlint::api
