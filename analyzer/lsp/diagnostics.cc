// Findings as diagnostics, pushed and pulled.
#include "analyzer/lsp/features.h"
#include "analyzer/report/pages.h"
#include "analyzer/report/report.h"
#include "analyzer/text/paths.h"

namespace owlint::lsp {
namespace {

int severity_number(Severity severity) {
  return severity == Severity::kError ? 1 : severity == Severity::kWarning ? 2 : 3;
}

/// The rule's own page where it is installed, else LinuxCNC's page about O-words.
std::string page_of(std::string_view code) {
  const std::string page = installed_rule_page(code);
  return page.empty() ? "https://linuxcnc.org/docs/html/gcode/o-code.html" : uri_of_path(page);
}

/// Lines that nothing can reach are shown faded.
bool is_unnecessary(const Finding& f) { return rule_of(f).fades; }

Json related_json(const Document& document, const Finding& f) {
  Json out = Json::array();
  const auto add = [&](const Related& r) {
    if (r.source == nullptr || r.source->path() == document.path()) {
      out.push_back({{"location", document.location(r.span)}, {"message", printable(r.message)}});
      return;
    }
    const Document other(uri_of_path(file_key(r.source->path())), r.source->path(), std::string(r.source->bytes()),
                         document.encoding());
    out.push_back({{"location", other.location(r.span)}, {"message", printable(r.message)}});
  };
  for (const Related& r : f.related) add(r);
  for (const Related& r : f.path) add(r);
  return out;
}

/// What the editor shows: what was seen, what LinuxCNC says, how to fix it.
std::string words(const Finding& f) {
  std::string text = printable(f.message);
  if (!f.interpreter.empty() && f.stops) text += "\nLinuxCNC says: " + printable(f.interpreter);
  if (!f.help.empty()) text += "\nfix: " + printable(f.help);
  return text;
}

}  // namespace

Json diagnostics_of(const Document& document, const std::vector<Finding>& findings) {
  Json out = Json::array();
  for (const Finding& f : findings) {
    Json d{{"range", document.range(f.span)},
           {"severity", severity_number(f.severity)},
           {"code", f.code},
           {"codeDescription", {{"href", page_of(f.code)}}},
           {"source", kToolName},
           {"message", words(f)},
           {"data", {{"code", f.code}, {"fixes", f.fixes.size()}}}};
    if (is_unnecessary(f)) d["tags"] = {1};
    if (Json related = related_json(document, f); !related.empty()) d["relatedInformation"] = std::move(related);
    out.push_back(std::move(d));
  }
  return out;
}

Json document_diagnostic(Workspace& workspace, const Json& params) {
  const std::string uri = params.at("textDocument").at("uri");
  const Document& document = workspace.document(uri);
  if (workspace.checked(uri) == nullptr && workspace.find_open(uri) != nullptr) workspace.check(uri);
  const Checked* known = workspace.checked(uri);
  const Checked checked = known != nullptr ? *known : workspace.check_alone(document.path());
  if (params.value("previousResultId", "") == checked.result_id)
    return {{"kind", "unchanged"}, {"resultId", checked.result_id}};
  return {{"kind", "full"}, {"resultId", checked.result_id}, {"items", diagnostics_of(document, checked.findings)}};
}

Json workspace_diagnostic(Workspace& workspace, const Json& params) {
  std::map<std::string, std::string> previous;
  for (const Json& entry : params.value("previousResultIds", Json::array()))
    previous[entry.at("uri")] = entry.at("value");
  Json items = Json::array();
  for (const auto& [path, checked] : workspace.check_everything()) {
    const Document* document = workspace.document_of_path(path);
    if (document == nullptr) continue;
    Json item{{"uri", document->uri()},
              {"version", document->version ? Json(*document->version) : Json(nullptr)},
              {"resultId", checked.result_id}};
    const auto before = previous.find(document->uri());
    if (before != previous.end() && before->second == checked.result_id) {
      item["kind"] = "unchanged";
    } else {
      item["kind"] = "full";
      item["items"] = diagnostics_of(*document, checked.findings);
    }
    items.push_back(std::move(item));
  }
  return {{"items", std::move(items)}};
}

}  // namespace owlint::lsp
