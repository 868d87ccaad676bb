// Checks one program: reads it, runs the flow analysis and every rule, decides severities, applies suppressions.
// All front ends come through here.
#pragma once

#include <string>
#include <vector>

#include "analyzer/findings/severity.h"
#include "rules/rule.h"

namespace owlint {

/// Which findings are wanted, and how bad they are.
struct LintOptions {
  std::vector<std::string> select;         ///< codes or prefixes; empty: all rules that are on by default
  std::vector<std::string> extend_select;  ///< added to those
  std::vector<std::string> ignore;         ///< taken away again; the longest prefix that fits decides
  std::map<std::string, Severity, std::less<>> severity;
};

/// The result for one file; findings are ordered by place.
struct FileReport {
  std::shared_ptr<const Source> source;
  std::vector<Finding> findings;
  FlowStatistics statistics;
};

FileReport lint(std::shared_ptr<const Source> source, const Profile& profile, const LintOptions& options);

/// Whether a rule's findings are wanted.
bool selected(const Rule& rule, const LintOptions& options);

}  // namespace owlint
