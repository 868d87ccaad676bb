// Checks many files in one run: in parallel, with the files that they call parsed once, and what several programs say
// of one called file told once.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "analyzer/cli/settings.h"

namespace owlint::cli {

struct RunResult {
  std::vector<FileReport> reports;  ///< of the files in their order, then of called files and INIs by path
  std::vector<std::vector<std::string>> calls;  ///< by file: the paths of the files that it calls
  std::vector<std::string> errors;  ///< by file: why it could not be read, or empty
  std::vector<std::string> notes;   ///< what users should know besides findings
};

/// `settings` has one entry for each of `files`; null where the file is not to be checked. `called_elsewhere`: keys of
/// files that programs outside of this run call. `checked` is told how many of the files are done, one call at a time.
RunResult run_checks(const std::vector<std::string>& files, const std::vector<const Settings*>& settings,
                     const std::function<std::shared_ptr<const Source>(const std::string& path, std::string* error)>& read,
                     Library& library, const std::set<std::string>& called_elsewhere = {},
                     const std::function<void(size_t done)>& checked = nullptr);

}  // namespace owlint::cli
