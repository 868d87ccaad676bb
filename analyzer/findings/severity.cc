#include "analyzer/findings/severity.h"

#include <algorithm>
#include <array>

#include "analyzer/text/source.h"

namespace owlint {
namespace {

constexpr std::array<std::string_view, 4> kSeverities = {"off", "info", "warning", "error"};
constexpr std::array<std::string_view, 3> kReaches = {"never", "maybe", "always"};

}  // namespace

std::string_view severity_text(Severity severity) { return kSeverities[static_cast<size_t>(severity)]; }
std::string_view reach_text(Reach reach) { return kReaches[static_cast<size_t>(reach)]; }

bool severity_from_text(std::string_view text, Severity* severity) {
  const auto found = std::ranges::find(kSeverities, small_letters(text));
  if (found == kSeverities.end()) return false;
  *severity = static_cast<Severity>(found - kSeverities.begin());
  return true;
}

Severity decide_severity(const Finding& finding, Severity level, bool abort_list, const SeverityPolicy& policy) {
  Severity severity = level;
  if (abort_list && policy.warn_only && !finding.stops) {
    severity = Severity::kWarning;
  } else if (finding.stops || finding.further || finding.never_ends || finding.runs_other) {
    severity = !finding.unproven ? Severity::kError : finding.uncertain ? Severity::kInfo : Severity::kWarning;
  } else if (level == Severity::kError) {
    severity = Severity::kWarning;  // the mistake is there, but no run meets it
  }
  if (finding.weight == Weight::kAside) severity = std::min(severity, Severity::kInfo);
  if (finding.weight == Weight::kRemark) {
    const bool wanted = std::ranges::any_of(
        policy.selected, [&](const std::string& prefix) { return finding.code.starts_with(prefix); });
    severity = wanted ? Severity::kInfo : Severity::kOff;
  }
  size_t longest = 0;
  for (const auto& [prefix, chosen] : policy.overrides) {
    if (prefix.size() >= longest && finding.code.starts_with(prefix)) {
      longest = prefix.size();
      severity = chosen;
    }
  }
  return severity;
}

}  // namespace owlint
