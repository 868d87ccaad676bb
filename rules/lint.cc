#include "rules/lint.h"

#include <algorithm>
#include <tuple>

namespace owlint {
namespace {

/// Length of the longest of `prefixes` that `code` begins with; -1 if none.
int longest_fit(std::string_view code, const std::vector<std::string>& prefixes) {
  int longest = -1;
  for (const std::string& prefix : prefixes) {
    if (code.starts_with(prefix)) longest = std::max(longest, static_cast<int>(prefix.size()));
  }
  return longest;
}

void run_rules(const Input& input, const LintOptions& options, const SeverityPolicy& policy, std::vector<Finding>& out) {
  for (const Rule* rule : catalogue()) {
    if (!selected(*rule, options)) continue;
    if (input.suppressions_applied && rule->group != Group::kLinter) continue;
    const size_t first = out.size();
    Reporter reporter(*rule, out);
    rule->check(input, reporter);
    for (size_t i = first; i < out.size(); ++i) {
      out[i].severity = decide_severity(out[i], rule->level, rule->group == Group::kAbortList, policy);
    }
  }
}

}  // namespace

bool selected(const Rule& rule, const LintOptions& options) {
  int wanted = rule.level == Severity::kInfo ? -1 : 0;
  if (!options.select.empty()) wanted = longest_fit(rule.code, options.select);
  wanted = std::max(wanted, longest_fit(rule.code, options.extend_select));
  return wanted >= 0 && longest_fit(rule.code, options.ignore) < std::max(wanted, 1);
}

FileReport lint(std::shared_ptr<const Source> source, const Profile& profile, const LintOptions& options) {
  FileReport report;
  report.source = source;
  const std::unique_ptr<Program> program = build_program(source);
  const FlowResult flow = analyze_flow(*program, profile);
  report.statistics = flow.statistics;

  std::vector<Suppression> suppressions;
  for (const Directive& directive : program->syntax.directives) {
    for (Suppression& s : parse_suppressions(*source, directive.span, directive.line, directive.own_line)) {
      suppressions.push_back(std::move(s));
    }
  }
  SeverityPolicy policy{profile.warn_only(), options.severity};
  const StopIndex stops(*program, flow);
  run_rules({*program, flow, profile, suppressions, stops, false}, options, policy, report.findings);
  apply_suppressions(*source, suppressions, report.findings);
  run_rules({*program, flow, profile, suppressions, stops, true}, options, policy, report.findings);

  std::erase_if(report.findings, [](const Finding& f) { return f.severity == Severity::kOff; });
  const auto key = [](const Finding& f) { return std::tie(f.span.begin, f.span.end, f.code, f.message); };
  std::ranges::stable_sort(report.findings, [&](const Finding& a, const Finding& b) { return key(a) < key(b); });
  return report;
}

}  // namespace owlint
