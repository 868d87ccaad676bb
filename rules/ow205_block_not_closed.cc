// OW205 block-not-closed: an `if`, `while`, `do` or `repeat` that is never closed.
// Rests on: a false condition skips to exactly that label and nothing but the end of the file ends
// the skip; a true one runs on without looking for an end.
#include <algorithm>

#include "rules/blocks.h"

namespace owlint::rules {
namespace {

/// Whether an end at the suggested line would be this block's: not inside a sub that stands in it, and no inner block with
/// its label takes it.
bool would_close(const Program& p, const Block& block) {
  const auto next = std::ranges::lower_bound(p.syntax.statements, block.suggested_line, {}, &Statement::line);
  const auto id = static_cast<StatementId>(next - p.syntax.statements.begin());
  if (id < p.size() && p.region_of[id] != block.region && p.regions[p.region_of[id]].opener != id) return false;
  return std::ranges::none_of(p.by_label[block.label], [&](StatementId line) {
    const BlockId other = p.block_of[line];
    if (line <= block.opener || line >= id || other == kNoBlock || p.blocks[other].opener != line) return false;
    return p.blocks[other].region == block.region && p.blocks[other].end == kNoStatement;
  });
}

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const BlockId number = p.block_of[id];
  Finding& f = out.add(p.at(id).head_span(), "`" + p.head(id) + "` is not closed");
  if (number == kNoBlock) return &f;
  const Block& block = p.blocks[number];
  const std::string end = p.label_text(block.label) + " " + std::string(spelling(end_of(block.kind))) + (block.kind == Keyword::kDo ? " [condition]" : "");
  f.help = "write `" + end + "` where the block ends";
  if (block.suggested_line != 0) {
    f.help = "write `" + end + "`, most likely before line " + std::to_string(block.suggested_line);
    const Span line = p.source->line(block.suggested_line);
    f.related.push_back({line, "`" + end + "` most likely belongs before this line", nullptr});
    const Statement& opener = p.at(id);
    if (block.kind != Keyword::kDo && would_close(p, block)) {
      f.fixes.push_back({"write `" + end + "` before line " + std::to_string(block.suggested_line), false,
                         {{{line.begin, line.begin}, indent_of(*p.source, opener) + end + line_end(*p.source, opener)}}});
    }
  }
  return &f;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  std::vector<bool> done(p.size());
  for_stops(in, out, [&](const FlowStop& s) {
    done[s.statement] = true;
    return report(in, out, s.statement);
  });
  for (const Block& block : p.blocks) {
    if (block.end != kNoStatement || done[block.opener] || has_stop(in, block.opener)) continue;
    // One mistake, one finding: the line that was meant to be the end speaks for it.
    if (block.mistaken_end != kNoStatement) continue;
    // So does a line with its label that the interpreter cannot read.
    if (p.at(block.opener).inner_cr || has_unreadable_line(in, block.label, block.region)) continue;
    // So does the end that stands outside, where the sub ends inside the block.
    const Region& region = p.regions[block.region];
    if (block.region != kMainRegion && region.end != kNoStatement) {
      const auto lines = p.by_label[block.label];
      const auto next = std::ranges::upper_bound(lines, region.end);
      if (next != lines.end() && p.region_of[*next] == kMainRegion && p.block_of[*next] == kNoBlock) continue;
    }
    report(in, out, block.opener)->reach = in.flow.reach(block.opener);
  }
}

}  // namespace

extern const Rule kOw205{
    .code = "OW205",
    .name = "block-not-closed",
    .summary = "`if`, `while`, `do` or `repeat` without its end",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page = {
        .what = R"(A block whose end with the same label is missing: no `endif`, no `endwhile`, no `endrepeat`, no
`while` for a `do`.)",
        .why = R"(What happens hangs on the day's values. Condition true: the lines below run once and nothing is
said, a loop does not loop. Condition false: everything to the end of the file is passed over, `M2`
included, and the interpreter stops there: the message speaks of the file's end, not of the block.
From 2.9.10 it reads `File ended with no percent sign (%) or program end (M2)`, in a program between
`%` signs `Failed to find sub 'O#100' before EOF`.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  G10 L20 P1 Z0
G0 Z5
M2
)",
        .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  G10 L20 P1 Z0
o100 endif
G0 Z5
M2
)",
        .fix = R"(Add the end with the block's label. If an end with another label stands where this one should be,
correct that label.)",
        .interpreter = "File ended with no percent sign or program end",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
