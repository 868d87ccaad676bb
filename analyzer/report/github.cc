// Workflow commands of GitHub Actions: each becomes an annotation beside the line. Escaping as GitHub's own toolkit does it:
// % and line ends in the message, and colons and commas in the properties as well.
#include <fmt/format.h>

#include "analyzer/report/formats.h"

namespace owlint {
namespace {

std::string command_text(std::string_view text, bool property) {
  std::string out;
  for (const char c : text) {
    if (c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ','))) {
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    } else {
      out.push_back(c);
    }
  }
  return out;
}

std::string_view command(Severity severity) {
  return severity == Severity::kError ? "error" : severity == Severity::kWarning ? "warning" : "notice";
}

}  // namespace

void write_github(std::ostream& out, const Reports& files, const ReportStyle& style) {
  for (const FileReport& file : files) {
    for (const Finding& f : file.findings) {
      const Source& source = source_of(file, f);
      const Position begin = source.position(f.span.begin);
      const Position end = source.position(f.span.end);
      std::string place = fmt::format("file={},line={},endLine={}", command_text(shown_path(source, style), true),
                                      begin.line, end.line);
      // Columns only mean something within one line.
      if (begin.line == end.line) place += fmt::format(",col={},endColumn={}", begin.column, end.column);
      out << fmt::format("::{} {},title={}::{}\n", command(f.severity), place,
                         command_text(fmt::format("{} {}", f.code, f.rule), true),
                         command_text(whole_message(f), false));
    }
  }
}

}  // namespace owlint
