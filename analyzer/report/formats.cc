#include "analyzer/report/formats.h"

#include <algorithm>

#include <fmt/format.h>

namespace owlint {
namespace {

void json(std::ostream& out, const Reports& files, const ReportStyle&) { write_json(out, files); }

void jsonl(std::ostream& out, const Reports& files, const ReportStyle&) {
  for (const FileReport& file : files) write_jsonl(out, file);
}

std::string_view seen_from_root(const Source& source, const ReportStyle& style) {
  std::string_view path = source.path();
  if (!style.root.empty() && path.starts_with(style.root) && path.substr(style.root.size()).starts_with('/'))
    path.remove_prefix(style.root.size() + 1);
  while (path.starts_with("./")) path.remove_prefix(2);
  return path;
}

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> all = {
      {"text", "for people: the line, the other places, what LinuxCNC says, how to fix it", true, write_text_report},
      {"grouped", "for people: a line a finding, below its file", true, write_grouped},
      {"gcc", "a line a finding, as compilers write it", false, write_gcc},
      {"json", "one object, see owlint-report-1.schema.json", false, json},
      {"jsonl", "one object a finding, one a line", false, jsonl},
      {"sarif", "SARIF 2.1.0, for code scanning", false, write_sarif},
      {"github", "annotations in GitHub Actions", false, write_github},
      {"gitlab", "code quality report of GitLab", false, write_gitlab},
      {"checkstyle", "XML of Checkstyle", false, write_checkstyle},
      {"junit", "XML of JUnit: each file a suite", false, write_junit},
      {"rdjson", "for reviewdog", false, write_rdjson},
      {"csv", "for spreadsheets", false, write_csv},
  };
  return all;
}

const Format* find_format(std::string_view name) {
  const auto found = std::ranges::find(formats(), name, &Format::name);
  return found == formats().end() ? nullptr : &*found;
}

void write_text_report(std::ostream& out, const Reports& files, const ReportStyle& style) {
  for (const FileReport& file : files) write_text(out, file, style);
}

std::string shown_path(const Source& source, const ReportStyle& style) {
  return printable(seen_from_root(source, style));
}

std::string json_path(const Source& source, const ReportStyle& style) { return as_utf8(seen_from_root(source, style)); }

std::string whole_message(const Finding& finding, std::string_view separator) {
  std::string text = printable(finding.message);
  if (finding.stops && !finding.interpreter.empty())
    text += fmt::format("{}LinuxCNC says: {}", separator, printable(finding.interpreter));
  if (!finding.help.empty()) text += fmt::format("{}fix: {}", separator, printable(finding.help));
  return text;
}

std::vector<Related> related_lines(const Finding& finding) {
  std::vector<Related> lines = finding.related;
  if (finding.reach == Reach::kNever) lines.insert(lines.end(), finding.path.begin(), finding.path.end());
  return lines;
}

const Source& source_of(const FileReport& file, const Finding& finding) {
  return finding.source == nullptr ? *file.source : *finding.source;
}

}  // namespace owlint
