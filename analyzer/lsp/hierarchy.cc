// The call hierarchy over O-calls and M98. An item's data is its document and the name of the sub; the main program of a
// document has the empty name.
#include <map>

#include "analyzer/lsp/features.h"
#include "analyzer/lsp/places.h"

namespace owlint::lsp {
namespace {

Json item(const Document& document, RegionId region) {
  const Program& p = document.program();
  const Region& r = p.regions[region];
  const bool main = r.opener == kNoStatement;
  const std::string file = document.path().substr(document.path().rfind('/') + 1);
  const Span span = main ? Span{0, document.text().size()}
                         : Span{p.at(r.opener).offset, p.at(std::max<StatementId>(r.last, r.opener + 1) - 1).end()};
  const Span selection = main ? Span{0, 0} : p.at(r.opener).head_span();
  return {{"name", main ? file : label_text(p.name(r.name))},
          {"kind", main ? 1 : 12},
          {"detail", file},
          {"uri", document.uri()},
          {"range", document.range(span)},
          {"selectionRange", document.range(selection)},
          {"data", {{"uri", document.uri()}, {"sub", main ? "" : p.name(r.name)}}}};
}

RegionId region_named(const Document& document, const std::string& name) {
  const Program& p = document.program();
  if (name.empty()) return kMainRegion;
  if (const RegionId sub = p.find_sub(name); sub != kNoRegion) return sub;
  throw ResponseError{ErrorCode::kRequestFailed, "this sub no longer exists"};
}

}  // namespace

Json prepare_call_hierarchy(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const auto target = target_at(document, offset);
  if (target && target->kind == Target::Kind::kSub) {
    const Sub sub = find_sub(workspace, document, target->name);
    if (sub.document != nullptr)
      return Json::array({item(*sub.document, sub.document->program().region_of[sub.opener])});
  }
  return nullptr;
}

Json incoming_calls(Workspace& workspace, const Json& params) {
  const Json data = params.at("item").at("data");
  const std::string name = data.at("sub");
  Json out = Json::array();
  if (name.empty()) return out;  // nobody calls a main program
  std::map<std::pair<const Document*, RegionId>, Json> callers;
  for (const Occurrence& o : sub_occurrences(workspace, workspace.document(data.at("uri")), name)) {
    const StatementId at = o.document->statement_at(o.span.begin);
    if (at == kNoStatement) continue;
    const Statement& s = o.document->program().at(at);
    if (!s.calls()) continue;
    callers.try_emplace({o.document, o.document->program().region_of[at]}, Json::array())
        .first->second.push_back(o.document->range(o.span));
  }
  for (const auto& [caller, ranges] : callers)
    out.push_back({{"from", item(*caller.first, caller.second)}, {"fromRanges", ranges}});
  return out;
}

Json outgoing_calls(Workspace& workspace, const Json& params) {
  const Json data = params.at("item").at("data");
  const Document& document = workspace.document(data.at("uri"));
  const Program& p = document.program();
  const RegionId region = region_named(document, data.at("sub"));
  std::map<NameId, Json> callees;
  for (const Call& call : p.calls) {
    if (call.caller != region || call.callee == kNoName) continue;
    callees.try_emplace(call.callee, Json::array())
        .first->second.push_back(document.range(p.at(call.statement).label_span()));
  }
  Json out = Json::array();
  for (const auto& [callee, ranges] : callees) {
    const Sub sub = find_sub(workspace, document, p.name(callee));
    if (sub.document == nullptr) continue;
    out.push_back({{"to", item(*sub.document, sub.document->program().region_of[sub.opener])}, {"fromRanges", ranges}});
  }
  return out;
}

}  // namespace owlint::lsp
