// Folding, and growing the selection: line, branch, block, sub, program.
#include <algorithm>

#include "analyzer/lsp/features.h"
#include "analyzer/lsp/places.h"

namespace owlint::lsp {

Json folding_range(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  const Program& p = document.program();
  Json out = Json::array();
  const auto fold = [&](uint64_t from, uint64_t to, const char* kind) {
    const size_t first = document.lines().line_of(from);
    const size_t last = document.lines().line_of(to);
    if (last <= first) return;
    Json range{{"startLine", first}, {"endLine", last}};
    if (kind != nullptr) range["kind"] = kind;
    out.push_back(std::move(range));
  };
  for (const Region& r : p.regions) {
    if (r.opener != kNoStatement && r.end != kNoStatement) fold(p.at(r.opener).offset, p.at(r.end).offset, nullptr);
  }
  for (BlockId id = 0; id < p.blocks.size(); ++id) {
    const Block& b = p.blocks[id];
    if (b.end == kNoStatement) continue;
    // Each branch for itself: an `else` stays in sight.
    uint64_t from = p.at(b.opener).offset;
    for (const StatementId part : p.parts[id]) {
      const uint64_t before = p.at(part).offset;
      fold(from, before > 0 ? before - 1 : 0, nullptr);
      from = before;
    }
    fold(from, p.at(b.end).offset, nullptr);
  }
  // Comments of several lines.
  const std::string_view text = document.text();
  size_t begun = SIZE_MAX;
  for (size_t line = 0; line <= document.lines().count(); ++line) {
    bool comment = false;
    if (line < document.lines().count()) {
      const Span span = document.lines().line(text, line);
      const size_t first = text.find_first_not_of(" \t", span.begin);
      comment = first < span.end && (text[first] == '(' || text[first] == ';');
    }
    if (comment && begun == SIZE_MAX) begun = line;
    if (comment || begun == SIZE_MAX) continue;
    if (line - begun > 1) out.push_back({{"startLine", begun}, {"endLine", line - 1}, {"kind", "comment"}});
    begun = SIZE_MAX;
  }
  return out;
}

Json selection_range(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  const Program& p = document.program();
  Json out = Json::array();
  for (const Json& position : params.at("positions")) {
    const uint64_t offset = document.offset(position);
    std::vector<Span> spans{{0, document.text().size()}};
    const RegionId region = region_at(document, offset);
    if (region != kMainRegion) {
      const Region& r = p.regions[region];
      spans.push_back({p.at(r.opener).offset, p.at(std::max<StatementId>(r.last, r.opener + 1) - 1).end()});
    }
    for (BlockId id = 0; id < p.blocks.size(); ++id) {
      const Block& b = p.blocks[id];
      if (b.end == kNoStatement || p.at(b.opener).offset > offset || p.at(b.end).end() < offset) continue;
      spans.push_back({p.at(b.opener).offset, p.at(b.end).end()});
      // The branch: the lines between two parts.
      StatementId from = b.opener;
      StatementId to = b.end;
      for (const StatementId part : p.parts[id])
        (p.at(part).offset <= offset ? from : to) = p.at(part).offset <= offset ? part : std::min(to, part);
      const Span branch{std::min<uint64_t>(p.at(from).end() + 1, document.text().size()), p.at(to).offset};
      if (branch.begin <= offset && offset < branch.end) spans.push_back(branch);
    }
    spans.push_back(document.line_at(offset));
    std::ranges::stable_sort(spans, [](Span a, Span b) { return a.end - a.begin > b.end - b.begin; });
    Json range;
    Span around{0, UINT64_MAX};
    for (const Span span : spans) {
      if (span.begin < around.begin || span.end > around.end || span == around || offset < span.begin ||
          offset > span.end)
        continue;
      Json inner{{"range", document.range(span)}};
      if (!range.is_null()) inner["parent"] = std::move(range);
      range = std::move(inner);
      around = span;
    }
    out.push_back(std::move(range));
  }
  return out;
}

}  // namespace owlint::lsp
