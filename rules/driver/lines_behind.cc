#include "rules/driver/lines_behind.h"

#include <algorithm>

namespace owlint::rules {
namespace {

// What comes later has hardly to do with the first line.
constexpr uint32_t kMostLines = 200;

/// Whether block delete takes a line away.
bool is_optional(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t");
  return first != std::string_view::npos && text[first] == '/';
}

}  // namespace

LinesBehind::LinesBehind(const Program& program, uint32_t line) : program_(program), first_(line), line_(line) {
  const auto& statements = program.syntax.statements;
  next_ =
      static_cast<StatementId>(std::ranges::upper_bound(statements, line, {}, &Statement::line) - statements.begin());
}

bool LinesBehind::next() {
  if (over_) return false;
  const Source& source = *program_.source;
  const uint32_t last = std::min(program_.syntax.last_code, first_ + kMostLines);
  while (line_ < last) {
    const Span text = source.line(++line_);
    begin_ = next_;
    while (next_ < program_.size() && program_.at(next_).line == line_) ++next_;
    if (is_optional(source.slice(text))) continue;
    if (passes_branch()) {
      if (over_) return false;
      continue;
    }
    words_ = words_of(source, text);
    if (words_.empty() && begin_ == next_) continue;
    for (StatementId id = begin_; id < next_; ++id) over_ = over_ || ends(id);
    return true;
  }
  return false;
}

/// Behind the branch of an `if` its others do not run.
bool LinesBehind::passes_branch() {
  if (begin_ == next_) return false;
  const Statement& s = program_.at(begin_);
  const BlockId id = program_.block_of[begin_];
  if (!(s.is(Keyword::kElse) || s.is(Keyword::kElseif)) || id == kNoBlock) return false;
  const Block& block = program_.blocks[id];
  if (program_.at(block.opener).line > first_) return false;
  over_ = block.end == kNoStatement;
  if (over_) return true;
  next_ = block.end + 1;
  line_ = program_.at(block.end).line;
  return true;
}

bool LinesBehind::ends(StatementId id) const {
  const Statement& s = program_.at(id);
  if (s.calls() || s.kind == LineKind::kRemap || s.kind == LineKind::kUserCode || s.opens_sub() ||
      s.is(Keyword::kEndsub))
    return true;
  const bool leaves = s.is(Keyword::kReturn) || s.has_m99() || s.kind == LineKind::kProgramEnd ||
      s.kind == LineKind::kPercent || s.kind == LineKind::kAbort;
  if (!leaves) return false;
  // In a block that begins behind the first line only some runs end there.
  const BlockId around = program_.open_above(program_.region_of[id], id);
  return around == kNoBlock || program_.at(program_.blocks[around].opener).line <= first_;
}

}  // namespace owlint::rules
