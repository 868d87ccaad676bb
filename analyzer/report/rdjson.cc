// The diagnostic format of reviewdog. Its columns count bytes of UTF-8.
#include <nlohmann/json.hpp>

#include "analyzer/report/formats.h"

namespace owlint {
namespace {

using Json = nlohmann::ordered_json;

Json byte_position(const Source& source, uint64_t offset) {
  const Position at = source.position(offset);
  return {{"line", at.line}, {"column", offset - source.line(at.line).begin + 1}};
}

Json range(const Source& source, Span span) {
  return {{"start", byte_position(source, span.begin)}, {"end", byte_position(source, span.end)}};
}

Json diagnostic(const FileReport& file, const Finding& f, const ReportStyle& style) {
  const Source& source = source_of(file, f);
  const char* const severity = f.severity == Severity::kError ? "ERROR"
      : f.severity == Severity::kWarning                      ? "WARNING"
                                                              : "INFO";
  Json out{{"message", whole_message(f)},
           {"location", {{"path", json_path(source, style)}, {"range", range(source, f.span)}}},
           {"severity", severity},
           {"code", {{"value", f.code}}}};
  for (const Fix& fix : f.fixes) {
    if (fix.edits.size() != 1) continue;  // a suggestion is one replacement
    out["suggestions"].push_back(
        {{"range", range(source, fix.edits[0].span)}, {"text", printable_text(fix.edits[0].text)}});
  }
  for (const Related& related : related_lines(f)) {
    const Source& place = related.source == nullptr ? source : *related.source;
    out["relatedLocations"].push_back(
        {{"message", printable(related.message)},
         {"location", {{"path", json_path(place, style)}, {"range", range(place, related.span)}}}});
  }
  return out;
}

}  // namespace

void write_rdjson(std::ostream& out, const Reports& files, const ReportStyle& style) {
  Json report{{"source", {{"name", kToolName}}}, {"diagnostics", Json::array()}};
  for (const FileReport& file : files) {
    for (const Finding& f : file.findings) report["diagnostics"].push_back(diagnostic(file, f, style));
  }
  out << report.dump(2) << '\n';
}

}  // namespace owlint
