#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "analyzer/report/formats.h"

namespace owlint {
namespace {

constexpr size_t kWidest = 120;  // longer source lines are cut around the finding

struct Colors {
  std::string_view bold, red, yellow, blue, cyan, dim, reset;
};
constexpr Colors kPlain{"", "", "", "", "", "", ""};
constexpr Colors kAnsi{"\x1b[1m", "\x1b[1;31m", "\x1b[1;33m", "\x1b[1;34m", "\x1b[36m", "\x1b[2m", "\x1b[0m"};

std::string_view severity_color(const Colors& c, Severity severity) {
  return severity == Severity::kError ? c.red : severity == Severity::kWarning ? c.yellow : c.blue;
}

/// A source line with the span underlined by `mark`, and words behind the underline.
void write_snippet(std::ostream& out, const Source& source, Span span, char mark, std::string_view words,
                   std::string_view color, const Colors& c) {
  const Position start = source.position(span.begin);
  Span line = source.line(start.line);
  if (source.slice(line).ends_with('\r')) --line.end;  // a line end, not part of the line
  uint64_t from = line.begin;
  if (span.begin > from + kWidest / 2 && line.end - line.begin > kWidest) from = span.begin - kWidest / 2;
  const uint64_t to = std::min<uint64_t>(line.end, from + kWidest);
  std::string text = printable(source.slice({from, to}));
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.pop_back();
  std::string pad;
  const uint64_t shown = std::min(span.begin, to);
  for (const char ch : source.slice({from, shown})) {
    if ((static_cast<unsigned char>(ch) & 0xC0) != 0x80) pad += ch == '\t' ? '\t' : ' ';
  }
  const uint64_t end = std::clamp(span.end, shown, to);
  const size_t width = std::max<size_t>(1, count_code_points(source.slice({shown, end})));
  out << fmt::format("{}{:>5} |{} {}\n", c.dim, start.line, c.reset, text);
  out << fmt::format("{}      |{} {}{}{}{}{}\n", c.dim, c.reset, pad, color, std::string(width, mark), c.reset,
                     words.empty() ? "" : " " + std::string(words));
}

/// `... is true and ... is false`: the branches that lead to a finding.
std::string path_text(const Finding& f) {
  constexpr size_t kShown = 4;
  std::string text;
  // The last decisions are the nearest ones.
  const size_t first = f.path.size() > kShown ? f.path.size() - kShown : 0;
  for (size_t i = first; i < f.path.size(); ++i) {
    std::string_view words = f.path[i].message;
    if (words.starts_with("when ")) words.remove_prefix(5);  // the label says it
    text += (i == first ? "" : i + 1 == f.path.size() ? " and " : ", ") + std::string(words);
  }
  if (first > 0) text += fmt::format(" (and {} more)", first);
  return text;
}

}  // namespace

void Summary::count(const Finding& finding) {
  if (finding.severity == Severity::kError) ++errors;
  if (finding.severity == Severity::kWarning) ++warnings;
  if (finding.severity == Severity::kInfo) ++infos;
}

Summary summarize(const std::vector<FileReport>& files) {
  Summary summary;
  summary.files = files.size();
  for (const FileReport& file : files) {
    for (const Finding& finding : file.findings) summary.count(finding);
  }
  return summary;
}

void write_text(std::ostream& out, const FileReport& file, const ReportStyle& style) {
  const Colors& c = style.color ? kAnsi : kPlain;
  const Source& source = *file.source;
  for (const Finding& f : file.findings) {
    const Position at = source.position(f.span.begin);
    const std::string_view tint = severity_color(c, f.severity);
    out << fmt::format("{}{}:{}:{}:{} {}{}{} {}{}{} {}[{} {}]{}\n", c.bold, shown_path(source, style), at.line, at.column,
                       c.reset, tint, severity_text(f.severity), c.reset, c.bold, printable(f.message), c.reset, c.dim,
                       f.code, f.rule, c.reset);
    write_snippet(out, source, f.span, '^', "", tint, c);
    const Source* shown = &source;
    for (const Related& related : f.related) {
      const Source& place = related.source == nullptr ? source : *related.source;
      if (&place != std::exchange(shown, &place)) out << fmt::format("{}  in {}:{}\n", c.dim, shown_path(place, style), c.reset);
      write_snippet(out, place, related.span, '-', printable(related.message), c.blue, c);
    }
    const auto line = [&](std::string_view label, std::string_view words) {
      if (!words.empty()) out << fmt::format("      {}= {}:{} {}\n", c.cyan, label, c.reset, printable(words));
    };
    line("when", path_text(f));
    line("LinuxCNC says", f.interpreter);
    if (!f.versions.empty()) line("versions", fmt::format("only in LinuxCNC {}", fmt::join(f.versions, ", ")));
    for (const Consequence& consequence : f.consequences) {
      line("other runs", fmt::format("the program stops because of line {} instead: {}", source.position(consequence.span.begin).line, consequence.interpreter));
    }
    if (f.reach == Reach::kNever && f.severity != Severity::kInfo && f.code != "OW316") line("not reached", "no run gets here");
    line("fix", f.help);
    out << '\n';
  }
}

std::string summary_text(const Summary& summary) {
  const auto count = [](size_t n, std::string_view what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
  const std::string files = count(summary.files, "file");
  if (summary.total() == 0) return fmt::format("nothing found in {}", files);
  std::string text;
  const auto add = [&](size_t n, std::string_view what) {
    if (n > 0) text += (text.empty() ? "" : ", ") + count(n, what);
  };
  add(summary.errors, "error");
  add(summary.warnings, "warning");
  add(summary.infos, "info");
  return text + " in " + files;
}

void write_statistics(std::ostream& out, const std::vector<FileReport>& files, const Library& library) {
  std::map<std::string_view, std::pair<size_t, std::string_view>> counts;
  FlowStatistics flow;
  for (const FileReport& file : files) {
    flow.steps += file.statistics.steps;
    flow.merges += file.statistics.merges;
    for (const Finding& f : file.findings) {
      ++counts[f.code].first;
      counts[f.code].second = f.rule;
    }
  }
  std::vector<std::pair<std::string_view, std::pair<size_t, std::string_view>>> sorted(counts.begin(), counts.end());
  std::ranges::stable_sort(sorted, [](const auto& a, const auto& b) { return a.second.first > b.second.first; });
  for (const auto& [code, entry] : sorted) out << fmt::format("{:>7}  {}  {}\n", entry.first, code, entry.second);
  out << fmt::format("{:>7}  reports, {} flow steps, {} merges\n", files.size(), flow.steps, flow.merges);
  out << fmt::format("{:>7}  files parsed", library.parsed());
  out << (library.called() == 0 ? "\n" : fmt::format(", {} of them for {} calls from other files\n", library.called(), library.uses()));
}

}  // namespace owlint
