// For spreadsheets: a line a finding, as RFC 4180 has it.
#include <fmt/format.h>

#include "analyzer/findings/identity.h"
#include "analyzer/report/formats.h"

namespace owlint {
namespace {

/// A cell. Spreadsheets take what begins with one of these for a formula; an apostrophe before it makes it text.
std::string cell(std::string_view words) {
  std::string text = printable(words);
  if (!text.empty() && std::string_view("=+-@\t").find(text.front()) != std::string_view::npos) text.insert(0, 1, '\'');
  std::string out = "\"";
  for (const char c : text) out.append(c == '"' ? 2 : 1, c);
  return out + '"';
}

}  // namespace

void write_csv(std::ostream& out, const Reports& files, const ReportStyle& style) {
  out << "path,line,column,end_line,end_column,severity,code,rule,message,help,interpreter,reach,stops,scope,"
         "fingerprint\r\n";
  for (const FileReport& file : files) {
    const std::vector<std::string> prints = fingerprints(*file.source, file.findings);
    for (size_t i = 0; i < file.findings.size(); ++i) {
      const Finding& f = file.findings[i];
      const Source& source = source_of(file, f);
      const Position begin = source.position(f.span.begin);
      const Position end = source.position(f.span.end);
      out << fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n", cell(shown_path(source, style)),
                         begin.line, begin.column, end.line, end.column, severity_text(f.severity), f.code, f.rule,
                         cell(f.message), cell(f.help), cell(f.interpreter), reach_text(f.reach), f.stops,
                         cell(f.scope), prints[i]);
    }
  }
}

}  // namespace owlint
