// OW206 blocks-crossed: two blocks that overlap without one lying inside the other.
// Rests on: blocks opened while skipping are not seen at all, so the end of the inner one meets an
// undefined label whenever the outer one was skipped.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Block& inner : p.blocks) {
    if (inner.crossed == kNoBlock || inner.end == kNoStatement) continue;
    const Block& outer = p.blocks[inner.crossed];
    if (has_stop(in, inner.end) || has_stop(in, outer.end)) continue;  // reported there, with the same words
    Finding& f = out.add(p.at(inner.end).head_span(), "`" + p.head(inner.end) + "` stands outside `" + p.head_of(outer) + "`, in which its block was opened");
    relate(f, p, inner.opener, "`" + p.head_of(inner) + "` is opened here");
    relate(f, p, outer.end, "`" + p.head_of(outer) + "` ends here, before it");
    f.help = "close the inner block before the outer one ends";
    f.fixes.push_back(move_up(p, inner.end, inner.end, outer.end, "move it before `" + p.head(outer.end) + "`"));
    f.reach = in.flow.reach(inner.end);
  }
}

}  // namespace

extern const Rule kOw206{
    .code = "OW206",
    .name = "blocks-crossed",
    .summary = "two blocks that overlap without nesting",
    .group = Group::kBlocks,
    .level = Severity::kWarning,
    .page = {
        .what = R"(Two blocks of which the second begins inside the first but ends after it: `o100` opens, `o110`
opens, `o100` ends, `o110` ends. Mostly the two end labels have been exchanged. Where some run stops at
the inner end, that is reported there as OW106 or OW108; this rule speaks of the other cases.)",
        .why = R"(As long as the outer block is entered, it often runs as hoped. When it is skipped, the inner opening
line is skipped with it, and the interpreter stops at the inner end because it has never seen its
label. A loop that makes no pass has the same effect.

Under FEATURE 0x20 (`OWORD_WARNONLY`) LinuxCNC **crashes** at the end whose label it has not seen.)",
        .bad = R"(G21 G90
#<depth> = 2
o100 if [#<depth> GT 1]
  G0 X10
  o110 if [#<depth> LT 5]
    G0 Y10
o100 endif
    G0 Z5
  o110 endif
M2
)",
        .good = R"(G21 G90
#<depth> = 2
o100 if [#<depth> GT 1]
  G0 X10
  o110 if [#<depth> LT 5]
    G0 Y10
    G0 Z5
  o110 endif
o100 endif
M2
)",
        .fix = R"(End the inner block before the outer one.)",
        .interpreter = "",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
