#include "rules/driver/wrong_ends.h"

#include <algorithm>

#include "analyzer/syntax/line_text.h"
#include "analyzer/text/characters.h"

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
  const auto inner = std::ranges::find_if(p.blocks, [&](const Block& other) {
    return other.label == label && other.region == b.region && other.opener > b.opener && other.end < b.end &&
        other.kind != Keyword::kIf;
  });
  return inner == p.blocks.end() ? nullptr : &*inner;
}

uint32_t deleted_opener(const Program& p, NameId label, bool (*wanted)(Keyword)) {
  if (label == kNoName) return 0;
  const std::string_view bytes = p.source->bytes();
  uint32_t number = 0;
  for (size_t at = 0; at < bytes.size();) {
    const size_t end = std::min(bytes.find('\n', at), bytes.size());
    std::string_view line = bytes.substr(at, std::min<size_t>(end - at, kLineLimit));
    at = end + 1;
    ++number;
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (!line.starts_with('/')) continue;
    std::string text = small_letters(line.substr(1));
    std::erase_if(text, is_blank);
    if (text.size() > 1 && text[0] == 'n')
      text.erase(0, std::min(text.find_first_not_of("0123456789.", 1), text.size()));
    if (text.size() < 2 || text[0] != 'o') continue;
    const bool named = text[1] == '<';
    const size_t from = named ? 2 : std::min(text.find_first_not_of('0', 1), text.size());
    const size_t to = std::min(named ? text.find('>') : text.find_first_not_of("0123456789", from), text.size());
    const std::string_view rest = std::string_view(text).substr(std::min(named ? to + 1 : to, text.size()));
    if (text.substr(from, to - from) == p.name(label) && wanted(keyword_of(rest))) return number;
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
