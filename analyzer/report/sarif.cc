// SARIF 2.1.0, as code scanning services read it.
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analyzer/findings/identity.h"
#include "analyzer/report/formats.h"
#include "analyzer/report/pages.h"
#include "analyzer/text/paths.h"

namespace owlint {
namespace {

using Json = nlohmann::ordered_json;

const char* level(Severity severity) {
  return severity == Severity::kError ? "error" : severity == Severity::kWarning ? "warning" : "note";
}

constexpr std::string_view kMark = "\xEF\xBB\xBF";  // byte order mark

class SarifWriter {
 public:
  explicit SarifWriter(const ReportStyle& style) : style_(style) {
    for (const Rule* rule : catalogue()) index_.emplace(rule->code, index_.size());
  }

  Json run(const Reports& files) const {
    Json results = Json::array();
    for (const FileReport& file : files) {
      const std::vector<std::string> prints = fingerprints(*file.source, file.findings);
      for (size_t i = 0; i < file.findings.size(); ++i) results.push_back(result(file, file.findings[i], prints[i]));
    }
    return {{"tool", {{"driver", driver()}}},
            {"originalUriBaseIds", {{"%SRCROOT%", {{"uri", fmt::format("file://{}/", percent_encoded(style_.root))}}}}},
            {"columnKind", "unicodeCodePoints"},
            {"results", std::move(results)}};
  }

 private:
  static Json driver() {
    Json rules = Json::array();
    for (const Rule* rule : catalogue()) {
      rules.push_back(
          {{"id", rule->code},
           {"name", rule->name},
           {"shortDescription", text(rule->summary)},
           {"fullDescription", text(rule->page.what)},
           {"help",
            {{"text", text(fmt::format("{}\n\n{}", rule->page.why, rule->page.fix))["text"]},
             {"markdown", braces_doubled(rule_page(*rule))}}},
           {"defaultConfiguration", {{"enabled", rule->level != Severity::kInfo}, {"level", level(rule->level)}}},
           {"properties", {{"tags", {group_title(rule->group)}}}}});
    }
    return {{"name", kToolName},
            {"version", kToolVersion},
            {"informationUri", "https://linuxcnc.org/docs/html/gcode/o-code.html"},
            {"rules", std::move(rules)}};
  }

  Json artifact(const Source& source) const {
    const std::string path = file_key(source.path());
    const std::string_view below = std::string_view(path).substr(std::min(path.size(), style_.root.size() + 1));
    if (style_.root.empty() || !path.starts_with(style_.root + "/"))
      return {{"uri", "file://" + percent_encoded(path)}};
    return {{"uri", percent_encoded(below)}, {"uriBaseId", "%SRCROOT%"}};
  }

  /// In SARIF a byte order mark is not part of the text: the columns of its line begin after it.
  static Json region(const Source& source, Span span) {
    const bool marked = has_mark(source);
    const auto column = [&](const Position& at) {
      return marked && at.line == 1 && at.column > 1 ? at.column - 1 : at.column;
    };
    const Position begin = source.position(span.begin);
    const Position end = source.position(span.end);
    return {
        {"startLine", begin.line}, {"startColumn", column(begin)}, {"endLine", end.line}, {"endColumn", column(end)}};
  }

  static bool has_mark(const Source& source) { return source.slice({0, kMark.size()}) == kMark; }

  /// What a fix replaces; the byte order mark can only be given in bytes.
  static Json deleted(const Source& source, Span span) {
    const bool mark = has_mark(source) && span.begin < kMark.size() && span.end > span.begin;
    return mark ? Json{{"byteOffset", span.begin}, {"byteLength", span.end - span.begin}} : region(source, span);
  }

  /// Single ones would be placeholders.
  static std::string braces_doubled(std::string_view words) {
    std::string out;
    for (const char c : words) out.append(c == '{' || c == '}' ? 2 : 1, c);
    return out;
  }

  /// A message; a bracket before a parenthesis would be a link.
  static Json text(std::string_view words) {
    std::string out = braces_doubled(words);
    for (size_t at = 0; (at = out.find("](", at)) != std::string::npos; at += 3) out.insert(at, 1, '\\');
    return {{"text", std::move(out)}};
  }

  Json physical(const Source& source, Span span) const {
    return {{"artifactLocation", artifact(source)}, {"region", region(source, span)}};
  }

  Json place(const Source& own, const Related& related) const {
    const Source& source = related.source == nullptr ? own : *related.source;
    return {{"physicalLocation", physical(source, related.span)}, {"message", text(printable(related.message))}};
  }

  /// The branch outcomes that lead to the finding, and the finding itself.
  Json code_flow(const Source& source, const Finding& f) const {
    Json locations = Json::array();
    for (const Related& step : f.path)
      locations.push_back({{"location", place(source, step)}, {"importance", "essential"}});
    locations.push_back({{"location", place(source, {f.span, f.message, nullptr})}, {"importance", "essential"}});
    return {{"threadFlows", Json::array({{{"locations", std::move(locations)}}})}};
  }

  Json fix(const Source& source, const Fix& made) const {
    Json replacements = Json::array();
    for (const Edit& edit : made.edits) {
      replacements.push_back(
          {{"deletedRegion", deleted(source, edit.span)}, {"insertedContent", {{"text", printable_text(edit.text)}}}});
    }
    return {{"description", text(printable(made.title))},
            {"artifactChanges",
             Json::array({{{"artifactLocation", artifact(source)}, {"replacements", std::move(replacements)}}})}};
  }

  Json result(const FileReport& file, const Finding& f, const std::string& print) const {
    const Source& source = source_of(file, f);
    Json location{{"physicalLocation", physical(source, f.span)}};
    if (!f.scope.empty())
      location["logicalLocations"] = Json::array({{{"fullyQualifiedName", printable(f.scope)}, {"kind", "function"}}});
    Json out{{"ruleId", f.code},
             {"ruleIndex", index_.at(f.code)},
             {"level", level(f.severity)},
             {"message", text(whole_message(f))},
             {"locations", Json::array({std::move(location)})}};
    for (const Related& related : related_lines(f)) {
      Json entry = place(source, related);
      entry["id"] = out.contains("relatedLocations") ? out["relatedLocations"].size() : 0;
      out["relatedLocations"].push_back(std::move(entry));
    }
    if (f.reach != Reach::kNever && !f.path.empty()) out["codeFlows"] = Json::array({code_flow(source, f)});
    for (const Fix& one : f.fixes) out["fixes"].push_back(fix(source, one));
    out["partialFingerprints"] = {{"owlint/v1", print}};
    out["properties"] = {{"reach", reach_text(f.reach)}, {"stops", f.stops}};
    return out;
  }

  const ReportStyle& style_;
  std::map<std::string_view, size_t> index_;
};

}  // namespace

void write_sarif(std::ostream& out, const Reports& files, const ReportStyle& style) {
  const Json report{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                    {"version", "2.1.0"},
                    {"runs", Json::array({SarifWriter(style).run(files)})}};
  out << report.dump(2) << '\n';
}

}  // namespace owlint
