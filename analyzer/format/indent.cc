#include "analyzer/format/indent.h"

#include <algorithm>

#include "analyzer/syntax/line_text.h"

namespace owlint {
namespace {

/// By statement: how much deeper its own line is than the level before it, and the lines after it. Both are sums.
struct Steps {
  std::vector<int> line, behind;
};

Steps find_steps(const Program& p) {
  Steps steps{std::vector<int>(p.size()), std::vector<int>(p.size())};
  const auto enclose = [&](StatementId opener, StatementId end) {
    ++steps.behind[opener];
    --steps.line[end];
    --steps.behind[end];
  };
  for (const Region& r : p.regions) {
    if (r.opener != kNoStatement && r.end != kNoStatement) enclose(r.opener, r.end);
  }
  for (BlockId id = 0; id < p.blocks.size(); ++id) {
    const Block& b = p.blocks[id];
    if (b.end == kNoStatement || b.crossed != kNoBlock) continue;
    enclose(b.opener, b.end);
    for (const StatementId part : p.parts[id]) --steps.line[part];
  }
  return steps;
}

}  // namespace

std::vector<Edit> indentation(const Program& program, const IndentStyle& style) {
  const Steps steps = find_steps(program);
  const std::string_view bytes = program.source->bytes();
  std::vector<Edit> edits;
  int level = 0;
  StatementId next = 0;
  for (size_t at = 0; at < bytes.size();) {
    const size_t feed = std::min(bytes.find('\n', at), bytes.size());
    // In front of a line's own statement there may be questions about it.
    int own = 0, behind = 0;
    for (; next < program.size() && program.at(next).offset <= feed; ++next) {
      own += steps.line[next];
      behind += steps.behind[next];
    }
    const int depth = std::max(0, level + own);
    const std::string_view line = bytes.substr(at, feed - at);
    const size_t blanks = std::min(line.find_first_not_of(" \t"), line.size());
    const size_t text = line.size() - blanks;
    // Blank lines and lines with other carriage returns than the one at their end stay as they are.
    const size_t cr = line.find('\r');
    const bool plain =
        text > 0 && line.substr(blanks) != "\r" && (cr == std::string_view::npos || cr + 1 == line.size());
    if (plain && text <= kLineLimit) {
      const size_t wanted = static_cast<size_t>(depth) * (style.spaces ? style.width : 1);
      std::string indent(std::min(wanted, kLineLimit - text), style.spaces ? ' ' : '\t');
      if (line.substr(0, blanks) != indent) edits.push_back({{at, at + blanks}, std::move(indent)});
    }
    level += behind;
    at = feed + 1;
  }
  return edits;
}

}  // namespace owlint
