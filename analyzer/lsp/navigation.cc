// Definition and declaration, references, highlight.
#include "analyzer/lsp/features.h"
#include "analyzer/lsp/ini_uses.h"
#include "analyzer/lsp/places.h"

namespace owlint::lsp {
namespace {

Json locations(const std::vector<Occurrence>& all, bool with_definition) {
  Json out = Json::array();
  for (const Occurrence& o : all) {
    if (with_definition || !o.definition) out.push_back(o.document->location(o.span));
  }
  return out;
}

}  // namespace

Json definition(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const auto target = target_at(document, offset);
  if (!target) return nullptr;
  if (target->kind == Target::Kind::kSub) {
    const Sub sub = find_sub(workspace, document, target->name);
    if (sub.document == nullptr) return nullptr;
    return sub.document->location(sub.document->program().at(sub.opener).label_span());
  }
  for (const Occurrence& o : occurrences(workspace, document, *target, offset)) {
    if (o.definition) return document.location(o.span);
  }
  return nullptr;
}

Json references(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const auto target = target_at(document, offset);
  if (!target) return nullptr;
  const bool with_definition = !params.contains("context") || params.at("context").value("includeDeclaration", true);
  Json out = locations(occurrences(workspace, document, *target, offset), with_definition);
  if (target->kind != Target::Kind::kSub) return out;
  const Sub sub = find_sub(workspace, document, target->name);
  if (sub.document == nullptr || !sub.own_file) return out;
  for (Json& use : ini_places_of_sub(workspace, *sub.document, target->name)) out.push_back(std::move(use));
  return out;
}

Json document_highlight(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const auto target = target_at(document, offset);
  if (!target) return nullptr;
  const Program& p = document.program();
  Json out = Json::array();
  enum Kind { kText = 1, kRead = 2, kWrite = 3 };
  for (const Occurrence& o : occurrences(workspace, document, *target, offset)) {
    if (o.document != &document) continue;
    Span span = o.span;
    // Of a block the keywords are shown as well: if, elseif, else, endif.
    if (target->kind == Target::Kind::kBlock) span = p.at(document.statement_at(o.span.begin)).head_span();
    const Kind kind = target->kind != Target::Kind::kParameter ? kText : o.definition ? kWrite : kRead;
    out.push_back({{"range", document.range(span)}, {"kind", kind}});
  }
  return out;
}

}  // namespace owlint::lsp
