// Checks a machine's INI, with the files that belong to it: runs the rules that look at them, decides severities, applies
// suppressions.
#include <algorithm>
#include <map>

#include "rules/driver/lint.h"
#include "rules/driver/missing_files.h"
#include "rules/driver/variants.h"

namespace owlint {
namespace {

using ByFile = std::map<std::string, FileReport>;  // by path

/// Comments `# owlint: ignore …` of the INI. They stand on lines of their own, as a comment behind a value is part of it.
std::vector<Suppression> suppressions_in(const IniText& text, const Source& file) {
  constexpr std::string_view kMark = "owlint:";
  std::vector<Suppression> out;
  for (const IniLine& line : text.lines()) {
    if (line.kind != IniLine::Kind::kComment || text.source(line)->path() != file.path()) continue;
    const std::string_view comment = text.text(line);
    const size_t mark = comment.find_first_not_of("#; \t");
    if (mark == std::string_view::npos || !small_letters(comment.substr(mark)).starts_with(kMark)) continue;
    const Span words{line.span.begin + mark + kMark.size(), line.span.end};
    std::ranges::move(parse_suppressions(file, words, line.number, true, suppressed_code), std::back_inserter(out));
  }
  return out;
}

void decide(const SeverityPolicy& policy, std::vector<Finding>& findings) {
  for (Finding& f : findings) f.severity = decide_severity(f, rule_of(f).level, false, policy);
}

ByFile lint_one_version(const Profile& profile, const LintOptions& options, Library& library) {
  std::vector<Finding> findings;
  const SetupInput input{*profile.setup, profile, library};
  for (const Rule* rule : catalogue()) {
    if (rule->check_setup == nullptr || !selected(*rule, options)) continue;
    Reporter reporter(*rule, findings);
    rule->check_setup(input, reporter);
  }
  ByFile reports;
  for (Finding& f : findings) {
    FileReport& report = reports[f.source->path()];
    if (report.source == nullptr) report.source = f.source;
    f.source = nullptr;
    report.findings.push_back(std::move(f));
  }
  const SeverityPolicy policy = policy_of(profile, options);
  for (auto& [path, report] : reports) {
    std::vector<Suppression> suppressions = suppressions_in(profile.setup->text, *report.source);
    decide(policy, report.findings);
    apply_suppressions(*report.source, suppressions, report.findings);
    put_in_order(report.findings);
    rules::fold_missing_files(input, report.findings, selected(*find_rule("OW407"), options));
    decide(policy, report.findings);  // what was folded changes it
    apply_suppressions(*report.source, suppressions, report.findings);
    for (Finding& f : report.findings) {
      if (f.group.empty()) f.group = f.message;  // copies of one configuration have the same mistakes
    }
  }
  return reports;
}

}  // namespace

std::vector<FileReport> lint_setup(const Profile& profile, const LintOptions& options, Library& library) {
  std::vector<ByFile> by_version;
  if (options.all_versions) {
    for (const Version version : kAllVersions) {
      Profile one = profile;
      one.version = version;
      one.version_given = true;
      by_version.push_back(lint_one_version(one, options, library));
    }
  } else {
    by_version.push_back(lint_one_version(profile, options, library));
  }
  std::map<std::string, std::vector<std::vector<Finding>>> lists;
  std::map<std::string, std::shared_ptr<const Source>> sources;
  for (size_t i = 0; i < by_version.size(); ++i) {
    for (auto& [path, report] : by_version[i]) {
      lists[path].resize(by_version.size());
      lists[path][i] = std::move(report.findings);
      sources.try_emplace(path, report.source);
    }
  }
  std::vector<FileReport> reports;
  for (auto& [path, findings] : lists) {
    const auto& source = sources[path];
    reports.push_back(
        {source, options.all_versions ? join_versions(*source, std::move(findings)) : std::move(findings[0]), {}});
  }
  return reports;
}

}  // namespace owlint
