// Symbols of a document and of the workspace, links to called files, how often a sub is called.
#include <algorithm>
#include <unordered_map>

#include "analyzer/lsp/features.h"
#include "analyzer/lsp/places.h"
#include "analyzer/text/paths.h"

namespace owlint::lsp {
namespace {

enum SymbolKind { kFunctionSymbol = 12, kNamespace = 3, kEvent = 24 };

Span whole_block(const Program& p, const Block& b) {
  const Statement& opener = p.at(b.opener);
  return {opener.offset, b.end == kNoStatement ? opener.end() : p.at(b.end).end()};
}

Json symbol(const Document& document, const std::string& name, int kind, const std::string& detail, Span range,
            Span selection) {
  Json out{{"name", name},
           {"kind", kind},
           {"range", document.range(range)},
           {"selectionRange", document.range(selection)},
           {"children", Json::array()}};
  if (!detail.empty()) out["detail"] = detail;
  return out;
}

/// Subs and blocks, outermost first; a block of the main program contains the subs defined in it.
struct Entry {
  Span range;
  Json json;
};

std::vector<Entry> entries(const Document& document) {
  const Program& p = document.program();
  std::vector<Entry> out;
  for (const Region& r : p.regions) {
    if (r.opener == kNoStatement) continue;
    const Statement& opener = p.at(r.opener);
    const Span range{opener.offset, r.last > r.opener ? p.at(r.last - 1).end() : opener.end()};
    const std::string comment = leading_comment(document, r.opener);
    out.push_back({range,
                   symbol(document, label_text(p.name(r.name)), kFunctionSymbol, comment.substr(0, comment.find('\n')),
                          range, opener.head_span())});
  }
  for (const Block& b : p.blocks) {
    const Span range = whole_block(p, b);
    out.push_back({range,
                   symbol(document, p.head_of(b), b.kind == Keyword::kIf ? kEvent : kNamespace,
                          condition_text(document, b.opener), range, p.at(b.opener).head_span())});
  }
  std::ranges::stable_sort(out, [](const Entry& a, const Entry& b) {
    return a.range.begin != b.range.begin ? a.range.begin < b.range.begin : a.range.end > b.range.end;
  });
  return out;
}

}  // namespace

Json document_symbol(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  std::vector<Entry> all = entries(document);
  // Nested by what is still open, closed from the end, so that no recursion follows the depth of the program.
  Json top = Json::array();
  std::vector<Entry> open;
  const auto close_until = [&](uint64_t begin) {
    while (!open.empty() && open.back().range.end <= begin) {
      Entry done = std::move(open.back());
      open.pop_back();
      (open.empty() ? top : open.back().json["children"]).push_back(std::move(done.json));
    }
  };
  constexpr size_t kDeepest = 100;  // clients nest by recursion
  for (Entry& entry : all) {
    close_until(entry.range.begin);
    if (open.size() >= kDeepest) continue;
    if (!open.empty()) entry.range.end = std::min(entry.range.end, open.back().range.end);
    open.push_back(std::move(entry));
  }
  close_until(UINT64_MAX);
  return top;
}

Json workspace_symbol(Workspace& workspace, const Json& params) {
  const std::string query = small_letters(params.at("query").get<std::string>());
  constexpr size_t kMost = 1000;
  Json out = Json::array();
  for (const std::string& path : workspace.program_files()) {
    const Document* document = workspace.document_of_path(path);
    if (document == nullptr) continue;
    const Program& p = document->program();
    for (const Region& r : p.regions) {
      if (r.opener == kNoStatement || out.size() >= kMost) continue;
      const std::string label = label_text(p.name(r.name));
      if (label.find(query) == std::string::npos) continue;
      out.push_back({{"name", label},
                     {"kind", static_cast<int>(kFunctionSymbol)},
                     {"location", document->location(p.at(r.opener).head_span())}});
    }
  }
  return out;
}

Json document_link(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  const Program& p = document.program();
  Json out = Json::array();
  for (const Call& call : p.calls) {
    if (call.callee == kNoName || call.target != kNoRegion) continue;
    const std::string path = workspace.called_file(document, p.name(call.callee));
    if (path.empty()) continue;
    out.push_back({{"range", document.range(p.at(call.statement).label_span())},
                   {"target", uri_of_path(file_key(path))},
                   {"tooltip", path}});
  }
  return out;
}

Json code_lens(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  const Program& p = document.program();
  Json out = Json::array();
  std::unordered_map<NameId, size_t> calls_here;
  for (const Call& call : p.calls) ++calls_here[call.callee];
  for (const Region& r : p.regions) {
    if (r.opener == kNoStatement) continue;
    // Other files can call only the sub that the file is named after.
    const bool own_file = find_sub(workspace, document, p.name(r.name)).own_file;
    size_t calls = own_file ? 0 : calls_here[r.name];
    for (const Occurrence& o :
         own_file ? sub_occurrences(workspace, document, p.name(r.name)) : std::vector<Occurrence>{}) {
      const StatementId at = o.document->statement_at(o.span.begin);
      if (at == kNoStatement) continue;
      const Statement& s = o.document->program().at(at);
      calls += s.calls() ? 1 : 0;
    }
    const std::string title = calls == 1 ? "1 call" : std::to_string(calls) + " calls";
    const Json range = document.range(p.at(r.opener).head_span());
    out.push_back({{"range", range}, {"command", {{"title", title}, {"command", ""}}}});
  }
  return out;
}

}  // namespace owlint::lsp
