// OW205 block-not-closed: an `if`, `while`, `do` or `repeat` that is never closed.
// Depends on: if the condition is false, the interpreter skips to that label or to the end of the
// file; if it is true, it goes on and does not look for an end.
#include <algorithm>

#include "rules/driver/block_helpers.h"
#include "rules/driver/wrong_ends.h"

namespace owlint::rules::ow205 {
namespace {

/// Whether an end at the suggested line would be this block's: not inside a sub within the block, and no inner block with
/// its label takes it.
bool would_close(const Program& p, const Block& block) {
  const auto next = std::ranges::lower_bound(p.syntax.statements, block.suggested_line, {}, &Statement::line);
  const auto id = static_cast<StatementId>(next - p.syntax.statements.begin());
  if (id < p.size() && p.region_of[id] != block.region && p.regions[p.region_of[id]].opener != id) return false;
  return std::ranges::none_of(p.by_label[block.label], [&](StatementId line) {
    const BlockId other = p.block_of[line];
    if (line > block.opener && line < id && p.at(line).opens_sub()) return true;
    if (line <= block.opener || line >= id || other == kNoBlock || p.blocks[other].opener != line) return false;
    return p.blocks[other].region == block.region && p.blocks[other].end == kNoStatement;
  });
}

/// A line that was probably meant to end the block: without a label, or a `while` with another one.
void name_mistaken_end(const Program& p, const Block& block, StatementId id, Finding& f) {
  const Statement& end = p.at(block.mistaken_end);
  const std::string label = p.label_text(block.label);
  const std::string right = label + " " + std::string(spelling(end_of(block.kind)));
  const std::string began = "`" + p.head_of(block) + "` on line " + std::to_string(p.at(block.opener).line);
  if (id == block.mistaken_end) {
    f.message = "`" + p.head(id) + "` does not close " + began +
        (end.label == block.label ? ": LinuxCNC reads it as the beginning of another block"
                                  : ": it has another label, so it begins a new loop");
    relate(f, p, block.opener, "`" + p.head_of(block) + "` begins here");
    f.help = "write `" + right + "`";
  } else if (end.is(Keyword::kBare) || end.keyword == Keyword::kUnknown ||
             (end.kind == LineKind::kOWord && end.label == kNoName)) {
    f.message += ": " + misread_words(p, block.mistaken_end);
    name_misread(p, block.mistaken_end, right, f);
    return;
  } else {
    const std::string line = "line " + std::to_string(end.line);
    f.message += end.label == kNoName ? ": `" + std::string(spelling(end.keyword)) + "` on " + line + " has no label"
                                      : ": `" + p.head(block.mistaken_end) + "` on " + line + " does not end it";
    relate(f, p, block.mistaken_end, "this is probably meant to be `" + right + "`");
    f.help = "write `" + right + "` on " + line;
  }
  if (end.label == kNoName) {
    f.fixes.push_back({"write the label `" + label + "`",
                       false,
                       {{{end.keyword_span().begin, end.keyword_span().begin}, label + " "}}});
  } else if (end.label == block.label && end.is(block.kind)) {
    f.fixes.push_back({"write `" + right + "`", false, {{all_of_oword(p, end), right}}});
  } else if (end.is(Keyword::kWhile)) {
    f.fixes.push_back({"write `" + label + "`", false, {{end.label_span(), label}}});
  }
}

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const BlockId number = p.block_of[id];
  Finding& f = out.add(p.at(id).head_span(), "`" + p.head(id) + "` is not closed");
  if (number == kNoBlock) return &f;
  const Block& block = p.blocks[number];
  if (block.mistaken_end != kNoStatement) {
    name_mistaken_end(p, block, id, f);
    return &f;
  }
  if (block.end != kNoStatement && p.at(block.end).refused) {
    const std::string line = "line " + std::to_string(p.at(block.end).line);
    f.message += ": LinuxCNC cannot read " + line + " as its end";
    relate(f, p, block.end, "this should be its end");
    f.help = "write `" + p.head(block.end) + "` on " + line;
    return &f;
  }
  const std::string end = p.label_text(block.label) + " " + std::string(spelling(end_of(block.kind))) +
      (block.kind == Keyword::kDo ? " [condition]" : "");
  f.help = "write `" + end + "` where the block ends";
  if (block.suggested_line != 0) {
    f.help = "write `" + end + "`, probably before line " + std::to_string(block.suggested_line);
    const Span line = p.source->line(block.suggested_line);
    f.related.push_back({line, "`" + end + "` probably belongs before this line", nullptr});
    const Statement& opener = p.at(id);
    if (block.kind != Keyword::kDo && would_close(p, block)) {
      f.fixes.push_back(
          {"write `" + end + "` before line " + std::to_string(block.suggested_line),
           false,
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
    if (block.mistaken_end != kNoStatement) {
      // Not for a `while`: LinuxCNC takes it as the beginning of a new loop.
      if (is_forgotten_end(p, block.mistaken_end) && !has_stop(in, block.mistaken_end))
        report(in, out, block.opener)->reach = in.flow.reach(block.opener);
      const Statement& end = p.at(block.mistaken_end);
      const bool opens = (end.is(Keyword::kWhile) || end.is(block.kind)) && !end.refused;
      if (opens && !has_stop(in, block.mistaken_end) && !done[block.mistaken_end])
        report(in, out, block.mistaken_end)->reach = in.flow.reach(block.mistaken_end);
      continue;
    }
    // So does a line with its label that the interpreter cannot read.
    if (p.at(block.opener).inner_cr || has_unreadable_line(in, block.label, block.region) ||
        has_misread_opener(in, block.opener))
      continue;
    // So does the end that is outside, where the sub ends inside the block.
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

extern const Rule kRule{
    .code = "OW205",
    .name = "block-not-closed",
    .summary = "`if`, `while`, `do` or `repeat` without its end",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A block whose end with the same label is missing: no `endif`, no `endwhile`, no `endrepeat`, or no
`while` for a `do`.)",
            .why = R"(The result depends on the condition. If it is true, the lines below run once without a message; a
loop does not loop. If it is false, the interpreter skips everything up to the end of the file,
including `M2`, and stops there. The message is about the end of the file, not about the block. From
2.9.10 on it is `File ended with no percent sign (%) or program end (M2)`; in a program between `%`
signs it is `Failed to find sub 'O#100' before EOF`.)",
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
            .fix = R"(Add the end with the block's label. If an end with another label is in its place, correct that
label.)",
            .level_reason = "Error if a run skips the block: LinuxCNC reads to the end of the file and stops. Warning "
                            "if no run does.",
            .interpreter = "File ended with no percent sign or program end",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow205
