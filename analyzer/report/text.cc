#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analyzer/program/library.h"
#include "analyzer/report/formats.h"
#include "analyzer/report/snippet.h"
#include "analyzer/text/width.h"

namespace owlint {
namespace {

constexpr size_t kMostPlaces = 6;  // related ones that are shown; a finding of many places names some
constexpr size_t kWidest = 120;    // longer source lines are cut around the finding
constexpr size_t kNarrowest = 24;  // of a source line; a terminal that has no room for it breaks lines itself

struct Colors {
  std::string_view bold, red, yellow, blue, cyan, dim, reset;
};
constexpr Colors kPlain{"", "", "", "", "", "", ""};
constexpr Colors kAnsi{"\x1b[1m", "\x1b[1;31m", "\x1b[1;33m", "\x1b[1;34m", "\x1b[36m", "\x1b[2m", "\x1b[0m"};

std::string_view severity_color(const Colors& c, Severity severity) {
  return severity == Severity::kError ? c.red : severity == Severity::kWarning ? c.yellow : c.blue;
}

/// The lines that show mistakes as soon as this one is fixed.
std::string unreached_text(const Source& source, const Finding& f) {
  constexpr size_t kShown = 5;
  std::vector<uint32_t> lines;
  bool same = true;
  for (const Consequence& c : f.consequences) {
    if (!c.interpreter.empty()) continue;
    lines.push_back(source.position(c.span.begin).line);
    same = same && c.code == f.code;
  }
  if (lines.empty()) return {};
  std::ranges::sort(lines);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  const size_t more = lines.size() > kShown ? lines.size() - kShown : 0;
  lines.resize(lines.size() - more);
  return fmt::format("{} on line{} {}{}, which no run reaches {}", same ? "the same mistake is" : "more is wrong",
                     lines.size() + more > 1 ? "s" : "", fmt::join(lines, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "",
                     same ? "before this is fixed" : "as the program is");
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

/// A report on its way to a stream, wrapped where its reader's terminal is narrow.
class Writer {
 public:
  Writer(std::ostream& out, const ReportStyle& style) : out_(out), style_(style), c_(style.color ? kAnsi : kPlain) {}

  void finding(const FileReport& file, const Finding& f) {
    const Source& source = *file.source;
    const Position at = source.position(f.span.begin);
    const std::string_view tint = severity_color(c_, f.severity);
    const std::string head = fmt::format("{}{}:{}:{}:{} {}{}{} {}{}{} {}[{} {}]{}", c_.bold, shown_path(source, style_),
                                         at.line, at.column, c_.reset, tint, severity_text(f.severity), c_.reset,
                                         c_.bold, printable(f.message), c_.reset, c_.dim, f.code, f.rule, c_.reset);
    out_ << wrapped(head, style_.width, "      ") << '\n';
    last_line_ = {};
    line_of(source, f.span, '^', "", tint);
    const Source* shown = &source;
    const size_t listed = f.related.size() > kMostPlaces ? kMostPlaces - 1 : f.related.size();
    for (const Related& related : std::span(f.related).first(listed)) {
      const Source& place = related.source == nullptr ? source : *related.source;
      if (&place != std::exchange(shown, &place))
        out_ << fmt::format("{}  in {}:{}\n", c_.dim, shown_path(place, style_), c_.reset);
      line_of(place, related.span, '-', printable(related.message), c_.blue);
    }
    if (listed < f.related.size())
      out_ << fmt::format("{}  and {} more places{}\n", c_.dim, f.related.size() - listed, c_.reset);
    labelled(f.reach == Reach::kNever ? "not reached" : "when", path_text(f));
    labelled("LinuxCNC says", f.interpreter);
    if (!f.versions.empty()) labelled("versions", fmt::format("only in LinuxCNC {}", fmt::join(f.versions, ", ")));
    if (f.missing.empty())
      other_runs(source, f);
    else
      other_lines(source, f);
    labelled("also", unreached_text(source, f));
    labelled("fix", f.help);
    out_ << '\n';
  }

 private:
  /// Of an INI, which has no runs.
  void other_lines(const Source& source, const Finding& f) {
    for (const Consequence& consequence : f.consequences) {
      if (consequence.interpreter.empty()) continue;
      labelled("also",
               fmt::format("line {}: {}", source.position(consequence.span.begin).line, consequence.interpreter));
    }
  }

  /// Where other runs stop because of the same mistake, each message once.
  void other_runs(const Source& source, const Finding& f) {
    constexpr size_t kMostLines = 4;
    std::vector<std::pair<std::string_view, std::vector<uint32_t>>> stops;
    for (const Consequence& consequence : f.consequences) {
      if (consequence.interpreter.empty()) continue;
      auto known = std::ranges::find(stops, consequence.interpreter, [](const auto& stop) { return stop.first; });
      if (known == stops.end()) known = stops.insert(stops.end(), {consequence.interpreter, {}});
      known->second.push_back(source.position(consequence.span.begin).line);
    }
    for (const auto& [message, lines] : stops) {
      std::string where = fmt::format("line {}", lines[0]);
      if (lines.size() > 1) {
        const size_t listed = std::min(lines.size(), kMostLines);
        where = fmt::format("lines {}", fmt::join(lines.begin(), lines.begin() + static_cast<ptrdiff_t>(listed), ", "));
        if (listed < lines.size()) where += fmt::format(" and {} more", lines.size() - listed);
      }
      labelled("other runs", fmt::format("the program stops because of {} instead: {}", where, message));
    }
  }

  /// A source line with the span underlined by `mark`, and words behind the underline or, where there is no room, below it.
  void line_of(const Source& source, Span span, char mark, std::string_view words, std::string_view color) {
    const std::string number = fmt::format("{:>5}", source.position(span.begin).line);
    const size_t gutter = number.size() + 3;
    const Snippet shown =
        snippet(source, span,
                style_.width == 0 ? kWidest : std::clamp(style_.width, gutter + kNarrowest, gutter + kWidest) - gutter);
    const std::string below = fmt::format("{}{} |{} ", c_.dim, std::string(number.size(), ' '), c_.reset);
    // Several places of one line are marked below it.
    if (std::pair line(&source, number + shown.text); std::exchange(last_line_, line) != line)
      out_ << fmt::format("{}{} |{} {}\n", c_.dim, number, c_.reset, shown.text);
    out_ << fmt::format("{}{}{}{}{}", below, std::string(shown.pad, ' '), color, std::string(shown.marked, mark),
                        c_.reset);
    const size_t used = gutter + shown.pad + shown.marked + 1;
    if (!words.empty() && (style_.width == 0 || used + columns(words) <= style_.width)) {
      out_ << ' ' << words;
    } else if (!words.empty()) {
      const std::string indent = below + "  ";
      out_ << '\n' << indent << wrapped(words, style_.width, indent, columns(indent));
    }
    out_ << '\n';
  }

  void labelled(std::string_view label, std::string_view words) {
    if (words.empty()) return;
    const std::string text = fmt::format("      {}= {}:{} {}", c_.cyan, label, c_.reset, printable(words));
    out_ << wrapped(text, style_.width, "        ") << '\n';
  }

  std::ostream& out_;
  const ReportStyle& style_;
  const Colors& c_;
  std::pair<const Source*, std::string> last_line_{};  // of the finding that is being written
};

}  // namespace

void Totals::count(const Finding& finding) {
  if (finding.severity == Severity::kError) ++errors;
  if (finding.severity == Severity::kWarning) ++warnings;
  if (finding.severity == Severity::kInfo) ++infos;
}

Totals totals_of(const std::vector<FileReport>& files) {
  Totals totals;
  totals.files = files.size();
  for (const FileReport& file : files) {
    for (const Finding& finding : file.findings) totals.count(finding);
  }
  return totals;
}

void write_text(std::ostream& out, const FileReport& file, const ReportStyle& style) {
  Writer writer(out, style);
  for (const Finding& f : file.findings) writer.finding(file, f);
}

std::string totals_text(const Totals& totals) {
  const auto count = [](size_t n, std::string_view what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
  const std::string files = count(totals.files, "file");
  if (totals.total() == 0) return fmt::format("nothing {}found in {}", totals.hidden > 0 ? "new " : "", files);
  std::string text;
  const auto add = [&](size_t n, std::string_view what) {
    if (n > 0) text += (text.empty() ? "" : ", ") + count(n, what);
  };
  add(totals.errors, "error");
  add(totals.warnings, "warning");
  add(totals.infos, "info");
  return text + " in " + files;
}

void write_statistics(std::ostream& out, const std::vector<FileReport>& files, const Library& library) {
  std::map<std::string_view, std::pair<size_t, std::string_view>> counts;
  Effort flow;
  for (const FileReport& file : files) {
    flow.steps += file.effort.steps;
    flow.merges += file.effort.merges;
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
  out << (library.called() == 0
              ? "\n"
              : fmt::format(", {} of them for {} calls from other files\n", library.called(), library.uses()));
}

}  // namespace owlint
