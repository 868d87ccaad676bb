// Checks programs: joins each with the files that it calls, runs the flow analysis and every rule, decides severities,
// applies suppressions. All front ends use it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "analyzer/findings/file_report.h"
#include "analyzer/findings/severity.h"
#include "analyzer/machine/answers.h"
#include "rules/driver/rule.h"

namespace owlint {

/// Which findings are wanted, and how bad they are.
struct LintOptions {
  std::vector<std::string> select;         ///< codes or prefixes; empty: all rules that are on by default
  std::vector<std::string> extend_select;  ///< added to those
  std::vector<std::string> ignore;         ///< removed again; the longest matching prefix decides
  std::map<std::string, Severity, std::less<>> severity;
  Detail detail = Detail::kBySize;
  flow::KnownCalls* known_calls = nullptr;  ///< an editor's memory of this one program; see known_calls.h
  bool notes_inputs = false;                ///< ProgramReport::inputs is wanted
  bool all_versions = false;                ///< every supported LinuxCNC version, not only the profile's
};

/// What a program's report depends on besides its own bytes, the machine and the options.
struct Inputs {
  std::shared_ptr<const SearchPath> search_path;
  std::vector<Answer> answers;
  std::vector<std::shared_ptr<const Source>> called;  ///< all files that it calls
  std::set<std::string> compared;                     ///< keys of files whose bytes were compared with others
};

/// The result for one program and the files that it calls.
struct ProgramReport {
  FileReport own;
  std::vector<FileReport> called;  ///< for those files, the problems that appear when this program calls them
  std::vector<std::string> calls;  ///< the paths of all of them
  std::vector<std::string>
      python;                     ///< called names that were not found and may be functions of the INI's Python module
  bool deletes_lines = false;     ///< it, or a file that it calls, has lines that begin with `/`
  bool sub_file = false;          ///< checked as a file that others call
  bool only_definitions = false;  ///< it defines subs and does nothing else
  bool role_matters = false;      ///< the result would be different as a file that others call
  Inputs inputs;                  ///< if they are wanted
};

/// Whether a file is a program or a file that others call, if its content does not decide.
enum class Role : uint8_t { kByContent, kSubFile };

ProgramReport lint(const std::shared_ptr<const Program>& program, const Profile& profile, const LintOptions& options,
                   Library& library, Role role = Role::kByContent);

/// One file alone, with no others: what it calls is not found.
FileReport lint(std::shared_ptr<const Source> source, const Profile& profile, const LintOptions& options);

/// The findings in the machine's INI itself, by file.
std::vector<FileReport> lint_setup(const Profile& profile, const LintOptions& options, Library& library);

/// Adds findings to those of the same file: a finding that is already there, at the same position with the same rule, only
/// gets the other's call as one more related line.
void merge_findings(FileReport& into, std::vector<Finding> findings);

/// What severities depend on, for a profile and options.
SeverityPolicy policy_of(const Profile& profile, const LintOptions& options);

/// Whether a rule's findings are wanted.
bool selected(const Rule& rule, const LintOptions& options);

}  // namespace owlint
