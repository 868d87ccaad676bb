// Signature help in the brackets of a call; inlay hints: which argument is which, and what an end belongs to.
#include <algorithm>

#include "analyzer/lsp/features.h"
#include "analyzer/lsp/places.h"
#include "analyzer/report/summary.h"

namespace owlint::lsp {
namespace {

/// The brackets of a call's arguments, outermost only: offsets of `[` and of the byte after `]`.
std::vector<Span> arguments_of(const Document& document, const Statement& s) {
  const std::string_view line = std::string_view(document.text()).substr(s.offset, s.length);
  std::vector<Span> out;
  int depth = 0;
  for (size_t i = s.keyword_to; i < line.size(); ++i) {
    if (line[i] == ';' || (line[i] == '(' && depth == 0)) {
      const size_t close = line[i] == '(' ? line.find(')', i) : std::string_view::npos;
      if (close == std::string_view::npos) break;
      i = close;
    } else if (line[i] == '[' && depth++ == 0) {
      out.push_back({s.offset + i, s.offset + line.size()});
    } else if (line[i] == ']' && depth > 0 && --depth == 0) {
      out.back().end = s.offset + i + 1;
    }
  }
  return out;
}

}  // namespace

Json signature_help(Workspace& workspace, const Json& params) {
  const auto [document, offset] = place_of(workspace, params);
  const StatementId id = document.statement_at(offset);
  if (id == kNoStatement) return nullptr;
  const Statement& s = document.program().at(id);
  if (!s.is(Keyword::kCall) || s.label == kNoName || offset < s.offset + s.keyword_to) return nullptr;
  const std::string& name = document.program().name(s.label);
  const Sub sub = find_sub(workspace, document, name);
  if (sub.document == nullptr) return nullptr;
  const std::vector<Span> given = arguments_of(document, s);
  size_t active = 0;
  while (active + 1 < given.size() && offset >= given[active + 1].begin) ++active;
  const uint32_t count =
      std::max<uint32_t>(arguments_read(*sub.document, sub.opener), static_cast<uint32_t>(given.size()));
  std::string label = label_text(name) + " call";
  Json parameters = Json::array();
  for (uint32_t n = 1; n <= count; ++n) {
    const std::string parameter = "[#" + std::to_string(n) + "]";
    label += " " + parameter;
    parameters.push_back({{"label", parameter}});
  }
  Json signature{{"label", label}, {"parameters", parameters}};
  const std::string comment = leading_comment(*sub.document, sub.opener);
  if (!comment.empty()) signature["documentation"] = {{"kind", "markdown"}, {"value", "```\n" + comment + "\n```"}};
  return {{"signatures", Json::array({signature})}, {"activeSignature", 0}, {"activeParameter", active}};
}

Json inlay_hint(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  const Span within = document.span(params.at("range"));
  const Program& p = document.program();
  enum Kind { kType = 1, kParameter = 2 };
  Json out = Json::array();
  const auto first = std::ranges::lower_bound(p.syntax.statements, within.begin, {}, &Statement::end);
  for (auto s = first; s != p.syntax.statements.end() && s->offset <= within.end; ++s) {
    const auto id = static_cast<StatementId>(s - p.syntax.statements.begin());
    if (s->is(Keyword::kCall) && s->label != kNoName) {
      uint32_t n = 0;
      const Sub sub = find_sub(workspace, document, p.name(s->label));
      const flow::Summary* summary =
          sub.document == nullptr ? nullptr : &sub.document->data().of(sub.document->program().region_of[sub.opener]);
      for (const Span argument : arguments_of(document, *s)) {
        ++n;
        const bool unread = summary != nullptr && summary->known && !summary->any_number && n < 31 &&
            (summary->arguments >> n & 1) == 0;
        out.push_back({{"position", document.position(argument.begin)},
                       {"label", "#" + std::to_string(n) + (unread ? " (not read) =" : " =")},
                       {"kind", static_cast<int>(kParameter)},
                       {"paddingRight", true}});
      }
    }
    if (s->is(Keyword::kSub)) {
      const std::string summary = summary_text(p, document.data().of(p.region_of[id]));
      if (!summary.empty())
        out.push_back({{"position", document.position(s->head_span().end)},
                       {"label", summary},
                       {"kind", static_cast<int>(kType)},
                       {"paddingLeft", true}});
    }
    const BlockId block = p.block_of[id];
    if (block == kNoBlock || p.blocks[block].end != id || !ends_block(s->keyword)) continue;
    const std::string condition = condition_text(document, p.blocks[block].opener);
    if (condition.empty()) continue;
    out.push_back({{"position", document.position(s->head_span().end)},
                   {"label", std::string(spelling(p.blocks[block].kind)) + " " + condition},
                   {"kind", static_cast<int>(kType)},
                   {"paddingLeft", true}});
  }
  return out;
}

}  // namespace owlint::lsp
