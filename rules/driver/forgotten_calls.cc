// Lines that were meant as calls, and what was meant as arguments of one.
#include <algorithm>

#include "analyzer/syntax/known_line.h"
#include "rules/driver/stops.h"

namespace owlint::rules {
namespace {

/// Whether an O-word without a keyword is the first thing in the program, where its number belongs.
bool begins_program(const Program& p, StatementId id) {
  const uint32_t plain = p.syntax.first_plain_line;
  if (plain != 0 && plain < p.at(id).line) return false;
  return id == 0 || (id == 1 && p.at(0).kind == LineKind::kPercent && !p.at(0).plain_code_follows);
}

}  // namespace

bool lacks_call(const Input& in, StatementId id) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  if (!s.is(Keyword::kBare) || s.name_open || s.refused) return false;
  if (s.label == kNoName) return s.label_expr != kNoExpr && !begins_program(p, id);
  const auto lines = p.by_label[s.label];
  if (std::ranges::any_of(lines, [&](StatementId line) { return p.at(line).is(Keyword::kSub); }))
    return s.named || !begins_program(p, id);
  const auto file = in.linked.search_path().find(p.name(s.label));
  if (!file || file->path == p.source->path()) return false;
  // A number may be the program's own.
  return s.named;
}

std::string arguments_in_comment(const Program& p, StatementId id) {
  const Statement& s = p.at(id);
  if (!s.is(Keyword::kCall) || s.value_count > 0) return {};
  std::string_view text = p.source->slice({s.offset + s.keyword_to, s.end()});
  std::string written;
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
    if (text.empty()) return written;
    const size_t close = text.find(')');
    if (text[0] != '(' || close == std::string_view::npos) return {};
    std::string_view values = text.substr(1, close - 1);
    while (!values.empty()) {
      values.remove_prefix(std::min(values.find_first_not_of(" \t"), values.size()));
      const size_t comma = std::min(values.find(','), values.size());
      const std::string value = "[" + std::string(values.substr(0, comma)) + "]";
      if (!surely_runs("#1=" + value)) return {};
      written += (written.empty() ? "" : " ") + value;
      values.remove_prefix(std::min(comma + 1, values.size()));
    }
    text.remove_prefix(close + 1);
  }
}

}  // namespace owlint::rules
