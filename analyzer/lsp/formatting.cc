// Formatting: of the document, of a part, and of the line that was just ended.
#include <algorithm>

#include "analyzer/format/indent.h"
#include "analyzer/lsp/features.h"
#include "analyzer/lsp/places.h"

namespace owlint::lsp {
namespace {

Json edits_within(const Document& document, const Json& params, Span within) {
  const Json options = params.value("options", Json::object());
  IndentStyle style;
  style.spaces = options.value("insertSpaces", true);
  style.width = std::clamp<size_t>(options.value("tabSize", size_t{2}), 1, 16);
  Json out = Json::array();
  for (const Edit& edit : indentation(document.program(), style)) {
    if (edit.span.begin < within.begin || edit.span.begin > within.end) continue;
    out.push_back({{"range", document.range(edit.span)}, {"newText", edit.text}});
  }
  return out;
}

}  // namespace

Json formatting(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  return edits_within(document, params, {0, document.text().size()});
}

Json range_formatting(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  const Span span = document.span(params.at("range"));
  return edits_within(document, params, {document.line_at(span.begin).begin, span.end});
}

Json on_type_formatting(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  // The line that was ended may be an `else` or an end that belongs further out; the new one is empty so far.
  const size_t line = document.lines().line_of(offset);
  const size_t first = document.lines().start(line > 0 ? line - 1 : 0);
  return edits_within(document, params, {first, offset});
}

}  // namespace owlint::lsp
