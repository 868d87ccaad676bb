// OW214 label-shared: one label on several blocks of one scope, but no run gets to two of them.
// Depends on: a label is defined when its first line is reached, and never in a branch that is not
// taken.
#include "rules/driver/block_helpers.h"

namespace owlint::rules::ow214 {
namespace {

bool stands_in_its_label(const Program& p, BlockId block) {
  constexpr size_t kMaxDepth = 64;  // deeper nests are not looked through
  if (block == kNoBlock) return false;
  BlockId outer = p.blocks[block].parent;
  for (size_t depth = 0; outer != kNoBlock && depth < kMaxDepth; ++depth, outer = p.blocks[outer].parent) {
    if (p.blocks[outer].label == p.blocks[block].label) return true;
  }
  return false;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const auto& [first, later] : in.index.shared_labels) {
    if (has_stop(in, later) || has_stop(in, first)) continue;
    const bool exclusive = in_exclusive_branches(p, first, later);
    const Keyword kind = p.at(later).keyword;
    if (!exclusive && !in.flow.executed[later] && kind != Keyword::kDo) continue;  // OW102 to OW104
    // The `while` after a `do` with a used label is where the interpreter notices.
    const BlockId block = p.block_of[later];
    if (block != kNoBlock && p.blocks[block].end != kNoStatement && has_stop(in, p.blocks[block].end)) continue;
    // A `do` in a `do` with its label is OW510.
    if (kind == Keyword::kDo && stands_in_its_label(p, block)) continue;
    Finding& f = out.add(p.at(later).label_span(),
                         "label `" + p.label_text(p.at(later).label) + "` is also used for " +
                             with_article(p.at(first).keyword) + " on line " + std::to_string(p.at(first).line));
    relate(f, p, first, "`" + p.head(first) + "` is here");
    f.help = kind == Keyword::kDo
        ? "give this block another label: if one run gets to both, its `while` goes back to the first `do`"
        : "give this block another label: LinuxCNC stops if one run gets to both, also in two calls of a sub";
    f.reach = in.flow.reach(later);
    if (divided_by_machine(p, first, later)) f.weight = Weight::kAside;
    add_relabel_fix(in, later, f);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW214",
    .name = "label-shared",
    .summary = "one label on several blocks of a sub, in branches of which no run gets to two",
    .group = Group::kBlocks,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(Two blocks of the same sub or main program have the same label, but they are in different branches,
so that each run takes only one of them.)",
            .why = R"(The program runs, because the interpreter never gets to the second block. But put a loop around it
that takes one branch in the first pass and the other in the second, or call the sub twice, and the
program stops with `duplicate O-word label` when part of the work is already cut. A second `do` does
not stop: its `while` goes back to the first `do`.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  o110 if [#5063 GT -5]
    G10 L20 P1 Z0
  o110 endif
o100 else
  o110 if [#<_current_tool> GT 5]
    (MSG,not the probe in the spindle)
  o110 endif
o100 endif
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  o110 if [#5063 GT -5]
    G10 L20 P1 Z0
  o110 endif
o100 else
  o120 if [#<_current_tool> GT 5]
    (MSG,not the probe in the spindle)
  o120 endif
o100 endif
G0 Z5
M2
)",
            .fix = R"(Give each block a label of its own.)",
            .level_reason = "Warning: no run gets to both blocks now, but a run that does stops.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
    .label_shared = true,
};

}  // namespace owlint::rules::ow214
