// Checks many files in one run: in parallel, with the called files parsed once. A finding in a called file is reported
// once, even if several programs lead to it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analyzer/checking/settings.h"

namespace owlint::checking {

struct RunResult {
  std::vector<FileReport> reports;  ///< for the files in their order, then for called files and INIs by path
  std::vector<std::vector<std::string>> calls;  ///< by file: the paths of the files that it calls
  std::vector<std::string> errors;              ///< by file: why it could not be read, or empty
  std::vector<std::string> notes;               ///< messages for users besides findings
};

/// The result for one file; a run is made of these.
struct Checked {
  ProgramReport report;                 ///< without a source: not read, or not checked
  std::optional<ProgramReport> as_sub;  ///< the same as a file that others call, if that makes a difference
  bool among_subs = false;              ///< it is in a folder that its machine has for subs
};

/// Keys of the files that machines call without any program: remaps, ngcgui, buttons, the start.
std::set<std::string> called_by_machines(const std::vector<const Settings*>& settings);
Checked check_file(const std::shared_ptr<const Source>& source, const Settings& settings, Library& library,
                   bool by_machine);
/// The findings in the machines' INIs, each reported once.
std::vector<FileReport> check_machines(const std::vector<const Settings*>& settings, Library& library);
RunResult put_together(const std::vector<std::string>& files, std::vector<Checked> checked,
                       std::vector<FileReport> machines, std::set<std::string> called_elsewhere);

/// `settings` has one entry for each of `files`; null if the file is not to be checked. `called_elsewhere`: keys of
/// files that programs outside of this run call. `checked` is called with the number of files that are done, one call at a time.
RunResult run_checks(const std::vector<std::string>& files, const std::vector<const Settings*>& settings,
                     Library& library, const std::set<std::string>& called_elsewhere = {},
                     const std::function<void(size_t done)>& checked = nullptr);

}  // namespace owlint::checking
