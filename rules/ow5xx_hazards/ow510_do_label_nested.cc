// OW510 do-label-nested: a `do` inside a `do` with the same label.
// Depends on: `do` accepts a used label and does not replace it, so the inner `while` goes back to
// the outer `do`.
#include <algorithm>

#include "rules/driver/block_helpers.h"

namespace owlint::rules::ow510 {
namespace {

/// What the flow has found of runs that never leave one of two loops; null if it has found none.
const Hazard* endless(const Input& in, StatementId outer, StatementId inner) {
  const auto found = std::ranges::find_if(in.flow.hazards, [&](const Hazard& h) {
    return h.kind == HazardKind::kEndlessLoop && (h.statement == outer || h.statement == inner);
  });
  return found == in.flow.hazards.end() ? nullptr : &*found;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Block& block : p.blocks) {
    if (block.kind != Keyword::kDo || block.parent == kNoBlock) continue;
    BlockId outer = block.parent;
    for (size_t depth = 0; outer != kNoBlock && depth < 64; ++depth) {
      if (p.blocks[outer].kind == Keyword::kDo && p.blocks[outer].label == block.label) break;
      outer = p.blocks[outer].parent;
    }
    if (outer == kNoBlock || p.blocks[outer].kind != Keyword::kDo || p.blocks[outer].label != block.label) continue;
    if (block.end == kNoStatement) continue;  // nothing goes back from it: OW205
    const StatementId opener = p.blocks[outer].opener;
    const Hazard* const never_left = endless(in, opener, block.opener);
    const std::string_view ends = never_left == nullptr ? ""
        : never_left->not_always                        ? ", and some runs may never end"
                                                        : ", and the program never ends";
    Finding& f = out.add(p.at(block.opener).head_span(),
                         "`" + p.head_of(block) + "` is inside a `do` with the same label: `" + p.head(block.end) +
                             "` on line " + std::to_string(p.at(block.end).line) + " goes back to the outer one");
    f.message += ends;
    relate(f, p, opener, "the outer `do` begins here");
    f.help = "give the inner loop a label of its own";
    f.reach = in.flow.reach(block.opener);
    f.never_ends = never_left != nullptr;
    f.unproven = never_left != nullptr && never_left->not_always;
    add_relabel_fix(in, block.opener, f);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW510",
    .name = "do-label-nested",
    .summary = "a `do` inside a `do` with the same label: never ends",
    .group = Group::kHazards,
    .level = Severity::kError,
    .page =
        {
            .what = R"(Two `do` loops with the same label, one inside the other.)",
            .why = R"(`do` is the only first line of a block that LinuxCNC does not check for a used label. The label
stays with the outer loop, so the inner `while` jumps back to the **outer** `do`. Values that the
outer loop sets at its start are set again, the inner counter never gets further, and the program
never ends. In the example the machine drills the first hole for ever. There is no message.

It is an error if some run certainly never ends. Otherwise it is a warning: the loops end, but not
as written.)",
            .bad = R"(G21 G90
#<y> = 0
o100 do
  #<x> = 0
  o100 do
    G81 X#<x> Y#<y> Z-5 R2 F80
    #<x> = [#<x> + 10]
  o100 while [#<x> LT 30]
  #<y> = [#<y> + 10]
o100 while [#<y> LT 20]
G80
M2
)",
            .good = R"(G21 G90
#<y> = 0
o100 do
  #<x> = 0
  o110 do
    G81 X#<x> Y#<y> Z-5 R2 F80
    #<x> = [#<x> + 10]
  o110 while [#<x> LT 30]
  #<y> = [#<y> + 10]
o100 while [#<y> LT 20]
G80
M2
)",
            .fix = R"(Give the inner loop a label of its own, on its `do` and its `while`.)",
            .level_reason = "Error: the program never ends.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow510
