// Semantic tokens: full, changes since the last full answer, and a part.
#include <algorithm>
#include <array>

#include "analyzer/lsp/features.h"
#include "analyzer/lsp/lexer.h"

namespace owlint::lsp {
namespace {

// By TokenKind, in the protocol's own names, which every theme has colours for.
constexpr std::array<const char*, 8> kTypes = {"comment", "type",     "keyword",  "variable",
                                               "number",  "operator", "function", "macro"};

std::vector<uint32_t> encode(const Document& document, size_t first, size_t last) {
  std::vector<uint32_t> data;
  const std::string_view text = document.text();
  uint32_t line_before = 0;
  uint32_t character_before = 0;
  for (size_t number = first; number < last; ++number) {
    const Span span = document.lines().line(text, number);
    const std::string_view line = text.substr(span.begin, span.end - span.begin);
    character_before = number == line_before ? character_before : 0;
    for (const Token& token : tokenize(line)) {
      const uint32_t character = units(line.substr(0, token.begin), document.encoding());
      const uint32_t length = units(line.substr(token.begin, token.end - token.begin), document.encoding());
      const auto line_number = static_cast<uint32_t>(number);
      data.insert(data.end(),
                  {line_number - line_before, line_number == line_before ? character - character_before : character,
                   length, static_cast<uint32_t>(token.kind), 0});
      line_before = line_number;
      character_before = character;
    }
  }
  return data;
}

}  // namespace

Json semantic_tokens_legend() { return {{"tokenTypes", kTypes}, {"tokenModifiers", Json::array()}}; }

Json semantic_tokens_full(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  SentTokens& last = workspace.sent_tokens[document.uri()];
  last.data = encode(document, 0, document.lines().count());
  return {{"resultId", std::to_string(++last.id)}, {"data", last.data}};
}

Json semantic_tokens_delta(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  const auto known = workspace.sent_tokens.find(document.uri());
  if (known == workspace.sent_tokens.end() ||
      std::to_string(known->second.id) != params.at("previousResultId").get<std::string>()) {
    return semantic_tokens_full(workspace, params);
  }
  SentTokens& last = known->second;
  std::vector<uint32_t> data = encode(document, 0, document.lines().count());
  // One edit: what lies between the longest equal beginning and end.
  const size_t common = std::min(last.data.size(), data.size());
  size_t begin = 0;
  while (begin < common && last.data[begin] == data[begin]) ++begin;
  size_t end = 0;
  while (end < common - begin && last.data[last.data.size() - 1 - end] == data[data.size() - 1 - end]) ++end;
  Json edits = Json::array();
  if (begin + end < last.data.size() || begin + end < data.size()) {
    edits.push_back({{"start", begin},
                     {"deleteCount", last.data.size() - begin - end},
                     {"data",
                      std::vector<uint32_t>(data.begin() + static_cast<std::ptrdiff_t>(begin),
                                            data.end() - static_cast<std::ptrdiff_t>(end))}});
  }
  last.data = std::move(data);
  return {{"resultId", std::to_string(++last.id)}, {"edits", edits}};
}

Json semantic_tokens_range(Workspace& workspace, const Json& params) {
  const Document& document = workspace.document(params.at("textDocument").at("uri"));
  const Span span = document.span(params.at("range"));
  return {{"data", encode(document, document.lines().line_of(span.begin), document.lines().line_of(span.end) + 1)}};
}

}  // namespace owlint::lsp
