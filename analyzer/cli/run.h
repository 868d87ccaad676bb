// Checks many files in one run: in parallel, with the files that they call parsed once, and what several programs say
// of one called file reported once.
#pragma once

#include <functional>
#include <memory>
#include <optional>
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

/// What the check of one file gave; a run is put together from these.
struct Checked {
  ProgramReport report;                 ///< without a source: not read, or not to be checked
  std::optional<ProgramReport> as_sub;  ///< the same for a file that others call, where that makes a difference
  bool among_subs = false;              ///< it lies in a folder that its machine has for subs
};

/// Keys of the files that machines call without any program: remaps, ngcgui, buttons, the start.
std::set<std::string> called_by_machines(const std::vector<const Settings*>& settings);
Checked check_file(const std::shared_ptr<const Source>& source, const Settings& settings, Library& library, bool by_machine);
/// What is wrong with the machines' INIs, each reported once.
std::vector<FileReport> check_machines(const std::vector<const Settings*>& settings, Library& library);
RunResult put_together(const std::vector<std::string>& files, std::vector<Checked> checked, std::vector<FileReport> machines,
                       std::set<std::string> called_elsewhere);

/// `settings` has one entry for each of `files`; null where the file is not to be checked. `called_elsewhere`: keys of
/// files that programs outside of this run call. `checked` is called with the number of files that are done, one call at a time.
RunResult run_checks(const std::vector<std::string>& files, const std::vector<const Settings*>& settings,
                     const std::function<std::shared_ptr<const Source>(const std::string& path, std::string* error)>& read,
                     Library& library, const std::set<std::string>& called_elsewhere = {},
                     const std::function<void(size_t done)>& checked = nullptr);

}  // namespace owlint::cli
