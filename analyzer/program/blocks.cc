// Pairs the parts of blocks, region by region. Where labels or keywords do not fit, it looks for the most likely
// reading: an end with the right label first, then a mistaken end, then the place that indentation points to.
#include <algorithm>

#include "analyzer/program/meant.h"

namespace owlint {
namespace {

/// The open blocks of each label, innermost first, as chains: labels belong to one region, and every region leaves
/// them all empty again, so one table serves the whole program.
class OpenBlocks {
 public:
  explicit OpenBlocks(size_t names) : innermost_(names, kNoBlock) {}

  void open(BlockId id, NameId label) {
    outer_.resize(id + 1, kNoBlock);
    outer_[id] = innermost_[label];
    innermost_[label] = id;
  }
  BlockId innermost(NameId label) const { return innermost_[label]; }
  BlockId outer(BlockId id) const { return outer_[id]; }
  void close(BlockId id, NameId label) {
    BlockId* at = &innermost_[label];
    while (*at != kNoBlock && *at != id) at = &outer_[*at];  // nearly always the first
    if (*at == id) *at = outer_[id];
  }

 private:
  std::vector<BlockId> innermost_;  // by label
  std::vector<BlockId> outer_;      // by block
};

class Matcher {
 public:
  Matcher(Program& program, RegionId region, OpenBlocks& by_label)
      : program_(program), region_(region), by_label_(by_label) {}

  void run(std::span<const StatementId> lines) {
    lines_ = lines;
    for (size_t i = 0; i < lines.size(); ++i) {
      index_ = i;
      note_definitions(lines[i]);
      line(lines[i]);
    }
    note_definitions(static_cast<StatementId>(program_.size()));
    while (!open_.empty()) {
      unclosed(open_.back(), lines.empty() ? 0 : lines.back() + 1);
      forget(open_.back());
      open_.pop_back();
    }
    for (const BlockId id : floating_) {
      if (block(id).end != kNoStatement) continue;
      block(id).crossed = kNoBlock;  // its end did not come after all
      forget(id);
    }
  }

 private:
  Block& block(BlockId id) { return program_.blocks[id]; }

  /// Definitions before `id` are in the innermost block that is open now.
  void note_definitions(StatementId id) {
    if (region_ != kMainRegion) return;
    for (; next_region_ < program_.regions.size() && program_.regions[next_region_].opener < id; ++next_region_) {
      if (!open_.empty()) program_.regions[next_region_].enclosing = open_.back();
    }
  }

  void line(StatementId id) {
    const Statement& s = program_.at(id);
    if (s.kind == LineKind::kWords && s.keyword != Keyword::kUnknown) return without_label(id, s.keyword);
    if (s.has_error() && (s.kind == LineKind::kWords || s.label == kNoName)) return unreadable(id);
    if (s.kind != LineKind::kOWord || s.label == kNoName) return;
    if (s.is(Keyword::kBare)) return misread(id);
    if (is_numbered(s)) return without_label(id, s.keyword);
    switch (s.keyword) {
      case Keyword::kWhile:
        if (const BlockId loop = find(Keyword::kDo, s.label); loop != kNoBlock) return close(loop, id);
        if (means_to_close(Keyword::kDo) && !comes_later(Keyword::kWhile, s.label)) return mistake(id);
        return begins_again(s) ? mistake(id) : open(id);
      case Keyword::kIf:
      case Keyword::kRepeat: return begins_again(s) ? mistake(id) : open(id);
      case Keyword::kDo: return open(id);
      case Keyword::kElseif:
      case Keyword::kElse: program_.block_of[id] = find(Keyword::kIf, s.label); return;
      case Keyword::kBreak:
      case Keyword::kContinue: program_.block_of[id] = by_label_.innermost(s.label); return;
      case Keyword::kEndif:
      case Keyword::kEndwhile:
      case Keyword::kEndrepeat: return end(id);
      case Keyword::kEndsub: return end_of_sub(id);
      default: return;
    }
  }

  void open(StatementId id) {
    const Statement& s = program_.at(id);
    Block b;
    b.kind = s.keyword;
    b.label = s.label;
    b.region = region_;
    b.opener = id;
    b.parent = open_.empty() ? kNoBlock : open_.back();
    const auto number = static_cast<BlockId>(program_.blocks.size());
    program_.block_of[id] = number;
    program_.blocks.push_back(b);
    open_.push_back(number);
    by_label_.open(number, s.label);
  }

  /// The innermost open block of that kind and label.
  BlockId find(Keyword kind, NameId label) {
    BlockId id = by_label_.innermost(label);
    while (id != kNoBlock && block(id).kind != kind) id = by_label_.outer(id);
    return id;
  }

  void forget(BlockId id) { by_label_.close(id, block(id).label); }

  void end(StatementId id) {
    const Statement& s = program_.at(id);
    if (const BlockId own = find(opener_of(s.keyword), s.label); own != kNoBlock) return close(own, id);
    if (open_.empty()) return;
    // No open block fits. The innermost one was probably meant if only its label or its keyword differs and its
    // proper end does not come later.
    Block& top = block(open_.back());
    const bool same_label = top.label == s.label;
    const bool same_kind = top.kind == opener_of(s.keyword);
    if ((same_label || same_kind) && !comes_later(top)) mistake(id);
  }

  /// Whether the keyword of the innermost block, with its label, was written once more in place of its end.
  bool begins_again(const Statement& s) {
    if (open_.empty()) return false;
    const Block& top = block(open_.back());
    return top.kind == s.keyword && top.label == s.label && !comes_later(top);
  }

  /// `o1 if` … `o1 endsub`, where `o1` is no sub.
  void end_of_sub(StatementId id) {
    const Region& region = program_.regions[region_];
    const Statement& s = program_.at(id);
    if (open_.empty() || s.refused || region.name == s.label || region.likely_end == id) return;
    if (block(open_.back()).label == s.label && !comes_later(block(open_.back()))) mistake(id);
  }

  /// The line is probably meant to end the innermost block.
  void mistake(StatementId id) {
    block(open_.back()).mistaken_end = id;
    program_.block_of[id] = open_.back();
    forget(open_.back());
    open_.pop_back();
  }

  /// Whether an end for blocks of this kind would be the innermost one's, whose own does not come.
  bool means_to_close(Keyword kind) {
    return !open_.empty() && block(open_.back()).kind == kind && !comes_later(block(open_.back()));
  }

  /// Whether the line number stands in place of the label, so that it need not be that of the block: line numbers rise.
  bool is_numbered(const Statement& s) {
    const LineError* const error = program_.syntax.error(s);
    if (!s.refused || error == nullptr || error->kind != StopKind::kLabelForgotten) return false;
    if (s.is(Keyword::kBreak) || s.is(Keyword::kContinue)) return by_label_.innermost(s.label) == kNoBlock;
    const Keyword opener = opener_of(s.keyword);
    return opener != Keyword::kUnknown && opener != Keyword::kSub && find(opener, s.label) == kNoBlock;
  }

  /// A line that is meant to end or divide a block, and is not read as an O-word.
  void unreadable(StatementId id) {
    if (open_.empty()) return;
    const Meant meant = meant_by(program_, id);
    // Another block's label is meant.
    const bool other = meant.label != kNoName && meant.label != block(open_.back()).label &&
        std::ranges::any_of(program_.by_label[meant.label], [&](StatementId line) { return line != id; });
    const bool until = block(open_.back()).kind == Keyword::kDo && begins_with_until(id);
    if (!other) without_label(id, until ? Keyword::kWhile : meant.keyword);
  }

  /// `until [...]`, `loop until [...]`, `o until [...]`: the end of a `do` in other languages.
  bool begins_with_until(StatementId id) const {
    std::string text = small_letters(program_.source->slice(program_.at(id).whole()).substr(0, kLineLimit));
    text.erase(std::min(text.find('['), text.size()));
    std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
    return text == "until" || text == "loopuntil" || text == "ountil";
  }

  /// A keyword whose label was forgotten, or is another one.
  void without_label(StatementId id, Keyword keyword) {
    if (ends_block(keyword) || keyword == Keyword::kWhile) {
      if (means_to_close(keyword == Keyword::kWhile ? Keyword::kDo : opener_of(keyword))) mistake(id);
    } else if (keyword == Keyword::kElse || keyword == Keyword::kElseif) {
      if (!open_.empty() && block(open_.back()).kind == Keyword::kIf) program_.block_of[id] = open_.back();
    } else if (keyword == Keyword::kBreak || keyword == Keyword::kContinue) {
      const auto loop =
          std::find_if(open_.rbegin(), open_.rend(), [&](BlockId b) { return block(b).kind != Keyword::kIf; });
      if (loop != open_.rend()) program_.block_of[id] = *loop;
    }
  }

  /// An end that LinuxCNC reads as a program number: its name has no `>`, or a comment stands before its keyword.
  void misread(StatementId id) {
    if (open_.empty()) return;
    Meant meant = meant_by(program_, id);
    // Without any keyword it can only be meant as the end.
    const Statement& s = program_.at(id);
    if (!s.has_error() && !s.name_open && block(open_.back()).kind != Keyword::kDo)
      meant = {end_of(block(open_.back()).kind), true, s.label, "", s.head_span(), 0};
    const Keyword opener = meant.keyword == Keyword::kWhile ? Keyword::kDo : opener_of(meant.keyword);
    // A name without its `>` that no other line has is no other block's.
    const bool unused = s.name_open && (meant.label == kNoName || program_.by_label[meant.label].empty());
    if (opener == Keyword::kUnknown || (meant.label != block(open_.back()).label && !unused)) return;
    if (block(open_.back()).kind == opener && (ends_block(meant.keyword) || opener == Keyword::kDo) &&
        !comes_later(block(open_.back())))
      mistake(id);
  }

  bool comes_later(const Block& b) const { return comes_later(b.kind, b.label); }

  /// Whether the end of a block of this kind and label follows.
  bool comes_later(Keyword kind, NameId label) const {
    // Bounded: an end further away than this is not looked for.
    constexpr size_t kHorizon = 4096;
    const auto lines = program_.by_label[label];
    auto at = std::ranges::upper_bound(lines, lines_[index_]);
    for (size_t n = 0; at != lines.end() && n < kHorizon; ++at, ++n) {
      if (program_.region_of[*at] != region_) continue;
      const Statement& s = program_.at(*at);
      if (s.is(end_of(kind))) return true;
      if (opens_block(s.keyword)) return false;
    }
    return false;
  }

  void close(BlockId closing, StatementId id) {
    // A block that another one has crossed is not on the stack any more; only its label is still known.
    while (block(closing).crossed == kNoBlock && open_.back() != closing) {
      const BlockId inner = open_.back();
      open_.pop_back();
      if (comes_later(block(inner))) {
        block(inner).crossed = closing;
        floating_.push_back(inner);
      } else {
        unclosed(inner, id);
        forget(inner);
      }
    }
    if (block(closing).crossed == kNoBlock) open_.pop_back();
    block(closing).end = id;
    program_.block_of[id] = closing;
    forget(closing);
  }

  /// Indentation of a line; -1 for blank lines and comments.
  int indent(std::string_view text) const {
    const size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos || std::string_view("(;\r").find(text[first]) != std::string_view::npos)
      return -1;
    return static_cast<int>(first);
  }

  /// Guesses where the missing end belongs: before the first line at the opener's own indentation or further out, and
  /// not after `limit`, where an enclosing block ends. Without indentation there is nothing to tell ties apart.
  void unclosed(BlockId id, StatementId limit) {
    Block& b = block(id);
    const Source& source = *program_.source;
    const Statement& opener = program_.at(b.opener);
    const int own = indent(source.slice(opener.whole()));
    const uint32_t limit_line = limit < program_.size() ? program_.at(limit).line : UINT32_MAX;
    // The search is bounded: a guess further away than this would not help anybody.
    constexpr int kHorizon = 400;
    const auto lines_of_label = program_.by_label[b.label];
    auto part = std::ranges::upper_bound(lines_of_label, b.opener);
    bool indented = false;
    int lines = 0;
    uint64_t at = opener.end() + 1;
    for (uint32_t number = opener.line + 1; at < source.bytes().size() && lines < kHorizon; ++number, ++lines) {
      const size_t feed = source.bytes().find('\n', at);
      const uint64_t end = feed == std::string_view::npos ? source.bytes().size() : feed;
      const int depth = indent(source.slice({at, std::min(end, at + 256)}));
      at = end + 1;
      if (number >= limit_line) {
        // Inside another block, that block's end is the last place; it is the only one when nothing lies between.
        if (indented || lines == 0) b.suggested_line = number;
        return;
      }
      while (part != lines_of_label.end() && program_.at(*part).line < number) ++part;
      if (part != lines_of_label.end() && program_.at(*part).line == number && program_.block_of[*part] == id) {
        // a part of this block: neither inside nor after it
      } else if (depth > own) {
        indented = true;
      } else if (depth >= 0) {
        if (indented) b.suggested_line = number;
        return;
      }
    }
  }

  Program& program_;
  RegionId region_;
  std::span<const StatementId> lines_;
  size_t index_ = 0;
  RegionId next_region_ = 1;
  std::vector<BlockId> open_;
  std::vector<BlockId> floating_;  // crossed by another block, their own end still to come
  OpenBlocks& by_label_;
};

}  // namespace

void index_parts(Program& program) {
  program.parts.assign(program.blocks.size(), static_cast<uint32_t>(program.size()), [&](StatementId id) {
    const Statement& s = program.at(id);
    return s.is(Keyword::kElse) || s.is(Keyword::kElseif) ? program.block_of[id] : kNoBlock;
  });
}

void match_blocks(Program& program) {
  program.blocks.clear();
  program.blocks.reserve(static_cast<size_t>(std::ranges::count_if(program.syntax.statements, [](const Statement& s) {
    return s.kind == LineKind::kOWord && opens_block(s.keyword);
  })));
  program.block_of.assign(program.size(), kNoBlock);
  Grouped lines;
  lines.assign(program.regions.size(), static_cast<uint32_t>(program.size()),
               [&](StatementId id) { return program.region_of[id]; });
  OpenBlocks by_label(program.syntax.names.size());
  for (RegionId region = 0; region < program.regions.size(); ++region)
    Matcher(program, region, by_label).run(lines[region]);
  index_parts(program);
  for (Region& region : program.regions) {
    // A block that never ends encloses nothing.
    if (region.enclosing != kNoBlock && program.blocks[region.enclosing].end == kNoStatement)
      region.enclosing = kNoBlock;
  }
}

}  // namespace owlint
