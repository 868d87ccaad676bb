// From a machine's INI to the subs and files that it names, and its outline.
#include "analyzer/lsp/features.h"
#include "analyzer/lsp/ini_document.h"
#include "analyzer/lsp/ini_uses.h"
#include "analyzer/lsp/places.h"
#include "analyzer/text/paths.h"
#include "analyzer/text/printable.h"

namespace owlint::lsp {

Json ini_definition(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const auto target = IniDocument(workspace, document).target_at(offset);
  if (!target || target->path.empty()) return nullptr;
  const Json top{{"line", 0}, {"character", 0}};
  Json begin{{"uri", uri_of_path(file_key(target->path))}, {"range", {{"start", top}, {"end", top}}}};
  if (target->sub.empty()) return begin;
  const Document* const file = workspace.document_of_path(target->path);
  const StatementId opener = file == nullptr ? kNoStatement : definition_in(*file, target->sub);
  return opener == kNoStatement ? begin : file->location(file->program().at(opener).label_span());
}

Json ini_references(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const auto target = IniDocument(workspace, document).target_at(offset);
  if (!target || target->sub.empty()) return nullptr;
  const Document* const file = target->path.empty() ? nullptr : workspace.document_of_path(target->path);
  Json out = Json::array();
  if (file != nullptr) {
    for (const Occurrence& o : sub_occurrences(workspace, *file, target->sub))
      out.push_back(o.document->location(o.span));
  }
  for (Json& use : ini_places_of_sub(workspace, file == nullptr ? document : *file, target->sub))
    out.push_back(std::move(use));
  return out;
}

Json ini_document_link(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  const IniDocument ini(workspace, document);
  Json out = Json::array();
  for (const IniLine& line : ini.text().lines()) {
    if (line.source != 0) continue;
    for (const IniTarget& target : ini.targets(line)) {
      if (target.path.empty()) continue;
      out.push_back({{"range", document.range(target.span)},
                     {"target", uri_of_path(file_key(target.path))},
                     {"tooltip", target.path}});
    }
  }
  return out;
}

Json ini_document_symbol(Workspace& workspace, const Json& params) {
  enum Symbol { kNamespaceSymbol = 3, kKeySymbol = 20 };
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  const IniDocument ini(workspace, document);
  const auto symbol = [&](std::string_view name, Symbol kind, Span range, Span selection) {
    return Json{{"name", printable(name)},
                {"kind", static_cast<int>(kind)},
                {"range", document.range(range)},
                {"selectionRange", document.range(selection)}};
  };
  Json out = Json::array();
  Span open;
  for (const IniLine& line : ini.text().lines()) {
    if (line.source != 0) continue;
    const std::string_view name = ini.text().name(line);
    if (line.kind == IniLine::Kind::kSection && !name.empty()) {
      open = line.span;
      out.push_back(symbol(name, kNamespaceSymbol, line.span, line.name));
    } else if (line.kind == IniLine::Kind::kKey && !name.empty() && !out.empty()) {
      open.end = line.span.end;
      out.back()["range"] = document.range(open);
      Json key = symbol(name, kKeySymbol, line.span, line.name);
      key["detail"] = printable(ini.text().value(line));
      out.back()["children"].push_back(std::move(key));
    }
  }
  return out;
}

}  // namespace owlint::lsp
