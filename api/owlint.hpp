// owlint for C++ programs: checks the text of a LinuxCNC program and returns the findings. In CMake, use
// find_package(owlint) and link owlint::owlint; examples/check.cc is a complete program.
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

/// The same as the options of `owlint check`; empty if not given.
struct Options {
  std::string path;      ///< the program's path; without an INI, called files are looked for in its folder
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
  std::string code;  ///< OW104
  std::string rule;  ///< if-label-reused
  Severity severity{};
  bool stops = false;       ///< LinuxCNC stops here with this error, at least on some runs
  std::string message;      ///< what is wrong
  std::string interpreter;  ///< the message that LinuxCNC prints; may be empty
  std::string help;         ///< how to fix it; may be empty
  Place begin, end;
};

/// The findings in a program, ordered by position. Throws std::invalid_argument if the options are wrong or the INI cannot
/// be read.
std::vector<Finding> check(std::string_view text, const Options& options = {});

/// 0.1.0
std::string_view version();

}  // namespace owlint::api
