#include "analyzer/report/json.h"

#include "analyzer/report/report.h"

namespace owlint {
namespace {

using Json = nlohmann::ordered_json;

Json position(const Source& source, uint64_t offset) {
  const Position p = source.position(offset);
  return {{"line", p.line}, {"column", p.column}, {"offset", p.offset}};
}

}  // namespace

Json finding_json(const Source& source, const Finding& f) {
  const auto place_in = [](Json& json, const Source& file, Span span) {
    json["start"] = position(file, span.begin);
    json["end"] = position(file, span.end);
  };
  const auto place = [&](Json& json, Span span) { place_in(json, source, span); };
  Json json;
  json["code"] = f.code;
  json["rule"] = f.rule;
  json["severity"] = severity_text(f.severity);
  json["message"] = printable(f.message);
  place(json, f.span);
  json["reach"] = reach_text(f.reach);
  json["stops"] = f.stops;
  if (!f.interpreter.empty()) json["interpreter"] = printable(f.interpreter);
  if (!f.help.empty()) json["help"] = printable(f.help);
  json["related"] = Json::array();
  std::vector<Related> places = f.related;
  places.insert(places.end(), f.path.begin(), f.path.end());
  for (const Related& related : places) {
    const Source& file = related.source == nullptr ? source : *related.source;
    Json entry{{"path", as_utf8(file.path())}, {"message", printable(related.message)}};
    place_in(entry, file, related.span);
    json["related"].push_back(std::move(entry));
  }
  json["fixes"] = Json::array();
  for (const Fix& fix : f.fixes) {
    Json entry{{"title", printable(fix.title)}, {"safe", fix.safe}, {"edits", Json::array()}};
    for (const Edit& edit : fix.edits) {
      Json change;
      place(change, edit.span);
      change["text"] = printable_text(edit.text);
      entry["edits"].push_back(std::move(change));
    }
    json["fixes"].push_back(std::move(entry));
  }
  if (!f.consequences.empty()) {
    json["consequences"] = Json::array();
    for (const Consequence& c : f.consequences) {
      Json entry{{"code", c.code}, {"interpreter", printable(c.interpreter)}};
      place(entry, c.span);
      json["consequences"].push_back(std::move(entry));
    }
  }
  if (!f.block_delete.empty()) json["block_delete"] = f.block_delete;
  if (!f.versions.empty()) json["versions"] = f.versions;
  return json;
}

void write_json(std::ostream& out, const std::vector<FileReport>& files) {
  Json report;
  report["schema"] = "owlint-report-1";
  report["tool"] = {{"name", kToolName}, {"version", kToolVersion}};
  report["files"] = Json::array();
  for (const FileReport& file : files) {
    Json entry{{"path", as_utf8(file.source->path())}, {"findings", Json::array()}};
    for (const Finding& f : file.findings) entry["findings"].push_back(finding_json(*file.source, f));
    report["files"].push_back(std::move(entry));
  }
  const Totals totals = totals_of(files);
  report["summary"] = {
      {"files", totals.files}, {"errors", totals.errors}, {"warnings", totals.warnings}, {"infos", totals.infos}};
  out << report.dump(2) << '\n';
}

void write_jsonl(std::ostream& out, const FileReport& file) {
  for (const Finding& f : file.findings) {
    Json line{{"path", as_utf8(file.source->path())}};
    line.update(finding_json(*file.source, f));
    out << line.dump() << '\n';
  }
}

}  // namespace owlint
