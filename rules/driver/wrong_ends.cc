#include "rules/driver/wrong_ends.h"

namespace owlint::rules {

Span all_of_oword(const Program& p, const Statement& s) {
  const Span rest{s.keyword_span().end, s.end()};
  const std::string_view text = p.source->slice(rest);
  size_t at = text.find_first_not_of(" \t");
  if (at == std::string_view::npos || text[at] != '[') return s.head_span();
  for (int depth = 0; at < text.size(); ++at) {
    depth += text[at] == '[' ? 1 : text[at] == ']' ? -1 : 0;
    if (depth == 0) return {s.head_span().begin, rest.begin + at + 1};
  }
  return s.head_span();
}

bool tell_wrong_end(const Program& p, StatementId id, Finding& f) {
  const BlockId number = p.block_of[id];
  if (number == kNoBlock || p.blocks[number].mistaken_end != id) return false;
  const Block& block = p.blocks[number];
  const Statement& s = p.at(id);
  if (s.label != block.label || (!s.is(block.kind) && !s.is(Keyword::kEndsub))) return false;
  const std::string right = p.label_text(block.label) + " " + std::string(spelling(end_of(block.kind)));
  f.message = "`" + p.head(id) + "` does not close `" + p.head_of(block) + "` on line " +
      std::to_string(p.at(block.opener).line);
  if (s.is(block.kind)) f.message += ": LinuxCNC reads it as the beginning of another block";
  f.help = "write `" + right + (block.kind == Keyword::kDo ? " [...]`" : "`");
  f.related.clear();
  f.fixes.clear();
  relate(f, p, block.opener, "`" + p.head_of(block) + "` begins here");
  const bool whole = s.value_count > 0 || s.is(Keyword::kEndsub) || s.has_error();
  if (block.kind != Keyword::kDo && whole)
    f.fixes.push_back({"write `" + right + "`", false, {{all_of_oword(p, s), right}}});
  return true;
}

const Block* ended_again(const Program& p, BlockId loop, StatementId id) {
  if (loop == kNoBlock) return nullptr;
  const Block& b = p.blocks[loop];
  const NameId label = p.at(id).label;
  if (b.end == kNoStatement || b.end >= id || b.region != p.region_of[id]) return nullptr;
  if (b.label == label) return &b;
  if (label == kNoName) return nullptr;
  for (const StatementId opener : p.by_label[label]) {
    const BlockId inner = p.block_of[opener];
    if (inner == kNoBlock) continue;
    const Block& other = p.blocks[inner];
    if (other.region == b.region && other.opener > b.opener && other.end < b.end && other.kind != Keyword::kIf)
      return &other;
  }
  return nullptr;
}

uint32_t deleted_opener(const Program& p, NameId label, bool (*wanted)(Keyword)) {
  if (label == kNoName) return 0;
  for (auto at = p.left_out.lower_bound({label, Keyword{}}); at != p.left_out.end() && at->first.first == label; ++at) {
    if (wanted(at->first.second)) return at->second;
  }
  return 0;
}

bool tell_deleted_sub(const Program& p, StatementId call, Finding& f) {
  const auto begins_sub = [](Keyword keyword) { return keyword == Keyword::kSub; };
  const uint32_t line = deleted_opener(p, p.at(call).label, begins_sub);
  if (line == 0) return false;
  f.message = "`" + p.head(call) + "` has no sub where block delete is on: its `sub` line has a `/`";
  f.related.push_back({p.source->line(line), "where block delete is on, LinuxCNC leaves this line out", nullptr});
  f.help = "write the `/` on the calls and on all lines of the sub, or on none of them";
  return true;
}

}  // namespace owlint::rules
