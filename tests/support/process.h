// Runs the built owlint as users do.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace owlint::test {

struct Run {
  int status = -1;  ///< exit status; 128 + signal when it was killed
  std::string out;
  std::string err;
  double seconds = 0;
};

/// Runs owlint with these arguments; `input` is its standard input, `folder` where it runs (here, when empty).
Run owlint(const std::vector<std::string>& arguments, const std::string& input = {}, const std::string& folder = {});

/// Runs a script with bash in a folder; `owlint` is the built program there.
Run shell(const std::string& script, const std::string& folder);

/// The words of a line of options; blanks separate them.
std::vector<std::string> words(const std::string& line);

/// The findings of one program, checked with these options, as in the JSON report.
nlohmann::json findings_of(const std::string& program, const std::string& options = {});

/// Checks many files in one run with the same options: the report's `files`, in the order of `paths`.
nlohmann::json check_files(const std::vector<std::string>& paths, const std::string& options);

}  // namespace owlint::test
