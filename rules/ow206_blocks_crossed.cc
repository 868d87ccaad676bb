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
    f.reach = in.flow.reach(inner.end);
  }
}

}  // namespace

extern const Rule kOw206{
    .code = "OW206",
    .name = "blocks-crossed",
    .summary = "two blocks that overlap without nesting",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page = {
        .what = R"(Two blocks of which the second begins inside the first but ends after it: `o100` opens, `o110`
opens, `o100` ends, `o110` ends. Mostly the two end labels have been exchanged.)",
        .why = R"(As long as the outer block is entered, it often runs as hoped. When it is skipped, the inner opening
line is skipped with it, and the interpreter stops at the inner end because it has never seen its
label. A loop that makes no pass has the same effect.

Under FEATURE 0x20 (`OWORD_WARNONLY`) LinuxCNC **crashes** at the end whose label it has not seen.)",
        .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  o110 if [#5063 GT -5]
    G10 L20 P1 Z0
o100 endif
  o110 endif
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
o100 endif
G0 Z5
M2
)",
        .fix = R"(End the inner block before the outer one.)",
        .interpreter = "undefined O-word label: 'o110 endif'",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
