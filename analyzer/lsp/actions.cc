// Quick fixes, `source.fixAll.owlint` with the safe ones, and for every finding: explain it, suppress it here.
#include <algorithm>

#include <fmt/format.h>

#include "analyzer/findings/edits.h"
#include "analyzer/findings/suppression.h"
#include "analyzer/lsp/features.h"
#include "analyzer/report/pages.h"
#include "analyzer/report/report.h"

namespace owlint::lsp {
namespace {

Json text_edits(const Document& document, const std::vector<Edit>& edits) {
  Json out = Json::array();
  for (const Edit& edit : edits) out.push_back({{"range", document.range(edit.span)}, {"newText", edit.text}});
  return out;
}

Json workspace_edit(const Document& document, Json edits) {
  const Json version = document.version ? Json(*document.version) : Json(nullptr);
  return {{"documentChanges",
           Json::array(
               {{{"textDocument", {{"uri", document.uri()}, {"version", version}}}, {"edits", std::move(edits)}}})}};
}

bool wanted(const Json& context, std::string_view kind) {
  if (!context.contains("only")) return true;
  return std::ranges::any_of(context.at("only"), [&](const Json& only) {
    const std::string prefix = only.get<std::string>();
    return kind == prefix || kind.starts_with(prefix + ".");
  });
}

Json diagnostic_in(const Json& context, const Finding& f, const Document& document) {
  Json out = Json::array();
  const Json range = document.range(f.span);
  for (const Json& d : context.value("diagnostics", Json::array())) {
    if (d.value("code", Json()) == f.code && d.value("range", Json()) == range) out.push_back(d);
  }
  return out;
}

}  // namespace

Json code_action(Workspace& workspace, const Json& params) {
  const std::string uri = params.at("textDocument").at("uri");
  const Document& document = workspace.document(uri);
  const Span span = document.span(params.at("range"));
  const Json context = params.value("context", Json::object());
  const Checked* known = workspace.checked(uri);
  const Checked checked = known != nullptr ? *known : workspace.check_alone(document.path());
  Json out = Json::array();
  for (const Finding& f : checked.findings) {
    if (f.span.begin > span.end || f.span.end < span.begin || !wanted(context, "quickfix")) continue;
    const Json diagnostics = diagnostic_in(context, f, document);
    const auto add = [&](Json action) {
      action["kind"] = "quickfix";
      if (!diagnostics.empty()) action["diagnostics"] = diagnostics;
      out.push_back(std::move(action));
    };
    bool first = true;
    for (const Fix& fix : f.fixes) {
      add({{"title", printable(fix.title)},
           {"isPreferred", first && fix.safe},
           {"edit", workspace_edit(document, text_edits(document, fix.edits))}});
      first = false;
    }
    add({{"title", fmt::format("suppress {} here", f.code)},
         {"edit",
          workspace_edit(document, text_edits(document, suppression_comments(*document.source(), {f}, "reason")))}});
    add({{"title", fmt::format("explain {} {}", f.code, f.rule)},
         {"command",
          {{"title", fmt::format("explain {}", f.code)}, {"command", "owlint.explain"}, {"arguments", {f.code}}}}});
  }
  if (wanted(context, "source.fixAll.owlint")) {
    const std::vector<Edit> edits = round_of_fixes(checked.findings, false).edits;
    if (!edits.empty())
      out.push_back({{"title", "fix everything that owlint can fix safely"},
                     {"kind", "source.fixAll.owlint"},
                     {"edit", workspace_edit(document, text_edits(document, edits))}});
  }
  return out;
}

Json execute_command(Workspace&, const Json& params) {
  if (params.at("command") != "owlint.explain") throw ResponseError{ErrorCode::kInvalidParams, "no such command"};
  const std::string code = params.at("arguments").at(0);
  const Rule* rule = find_rule(code);
  if (rule == nullptr) throw ResponseError{ErrorCode::kInvalidParams, "no such rule: " + code};
  return rule_page(*rule);
}

}  // namespace owlint::lsp
