// The one place that decides how bad a finding is.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analyzer/findings/finding.h"

namespace owlint {

/// What severity depends on besides the finding itself.
struct SeverityPolicy {
  bool warn_only = false;                                  ///< FEATURE 0x20 is in effect
  std::map<std::string, Severity, std::less<>> overrides;  ///< by code or prefix; the longest that matches wins
  std::vector<std::string> selected;  ///< codes or prefixes that the user named: their remarks are wanted
};

/// `level`: the rule's own level (for a finding that some run reaches); `abort_list`: OW101-OW108.
Severity decide_severity(const Finding& finding, Severity level, bool abort_list, const SeverityPolicy& policy);

}  // namespace owlint
