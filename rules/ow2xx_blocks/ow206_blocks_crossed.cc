// OW206 blocks-crossed: two blocks that overlap, neither inside the other.
// Depends on: the interpreter does not see blocks that it skips, so the end of the inner one has an
// undefined label if the outer one was skipped.
#include "rules/driver/stops.h"

namespace owlint::rules::ow206 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Block& inner : p.blocks) {
    if (inner.crossed == kNoBlock || inner.end == kNoStatement) continue;
    const Block& outer = p.blocks[inner.crossed];
    if (has_stop(in, inner.end) || has_stop(in, outer.end)) continue;  // reported there, with the same words
    Finding& f =
        out.add(p.at(inner.end).head_span(),
                "`" + p.head(inner.end) + "` is outside `" + p.head_of(outer) + "`, but its block begins inside");
    relate(f, p, inner.opener, "`" + p.head_of(inner) + "` begins here");
    relate(f, p, outer.end, "`" + p.head_of(outer) + "` ends here");
    f.help = "close the inner block before the end of the outer one";
    f.fixes.push_back(move_up(p, inner.end, inner.end, outer.end, "move it before `" + p.head(outer.end) + "`"));
    f.reach = in.flow.reach(inner.end);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW206",
    .name = "blocks-crossed",
    .summary = "two blocks that overlap",
    .group = Group::kBlocks,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(Two blocks that overlap: the second begins inside the first but ends after it. `o100` begins, `o110`
begins, `o100` ends, `o110` ends. Usually the two end labels are swapped. If some run stops at the
inner end, that is reported there as OW106 or OW108. This rule is for all other cases.)",
            .why = R"(As long as the program enters the outer block, it often runs as intended. If the outer block is
skipped, the first line of the inner block is skipped too, and the interpreter stops at the inner
end because it does not know the label. The same happens with a loop that makes no pass.

Under FEATURE 0x20 (`OWORD_WARNONLY`) LinuxCNC **crashes** at the end whose label it does not know.)",
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
            .level_reason = "Warning: crossed blocks run as long as the outer block runs. If they stop, another rule "
                            "reports an error.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow206
