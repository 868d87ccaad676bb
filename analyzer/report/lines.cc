// A line a finding: as compilers write it, and grouped by file.
#include <fmt/format.h>

#include "analyzer/report/formats.h"
#include "analyzer/text/width.h"

namespace owlint {
namespace {

/// gcc has no infos; it calls them notes.
std::string_view gcc_level(Severity severity) { return severity == Severity::kInfo ? "note" : severity_text(severity); }

}  // namespace

void write_gcc(std::ostream& out, const Reports& files, const ReportStyle& style) {
  for (const FileReport& file : files) {
    for (const Finding& f : file.findings) {
      const Source& source = source_of(file, f);
      const Position at = source.position(f.span.begin);
      out << fmt::format("{}:{}:{}: {}: {} [{}]\n", shown_path(source, style), at.line, at.column,
                         gcc_level(f.severity), printable(f.message), f.code);
    }
  }
}

void write_grouped(std::ostream& out, const Reports& files, const ReportStyle& style) {
  const std::string_view bold = style.color ? "\033[1m" : "";
  const std::string_view reset = style.color ? "\033[0m" : "";
  for (const FileReport& file : files) {
    if (file.findings.empty()) continue;
    out << fmt::format("{}{}{}\n", bold, shown_path(*file.source, style), reset);
    for (const Finding& f : file.findings) {
      const Position at = source_of(file, f).position(f.span.begin);
      const std::string row = fmt::format("  {:>5}:{:<3} {:<7} {}  {}", at.line, at.column, severity_text(f.severity),
                                          f.code, printable(f.message));
      out << wrapped(row, style.width, "        ") << '\n';
    }
    out << '\n';
  }
}

}  // namespace owlint
