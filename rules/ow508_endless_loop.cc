// OW508 endless-loop: a loop that no path leaves.
// Rests on: the interpreter has no limit on passes and reads ahead of the machine, so it never
// comes back.
#include <algorithm>

#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kEndlessLoop) continue;
    const Statement& s = p.at(h.statement);
    // A `do` in a `do` with its label is OW510.
    const auto nested = [&](const Block& b) {
      return b.kind == Keyword::kDo && b.label == s.label && b.opener > h.statement && p.block_of[h.statement] != kNoBlock &&
             b.opener < p.blocks[p.block_of[h.statement]].end;
    };
    if (s.is(Keyword::kDo) && std::ranges::any_of(p.blocks, nested)) continue;
    const std::string who = h.not_always ? "a run may never leave" : "no run leaves";
    Finding& f = out.add(s.head_span(), who + " the loop that begins with `" + p.head(h.statement) + "`");
    f.unproven = h.not_always;
    const BlockId block = p.block_of[h.statement];
    if (block != kNoBlock && p.blocks[block].end != kNoStatement) relate(f, p, p.blocks[block].end, "it goes back from here");
    f.help = "change in the loop what its condition tests, or leave it with `break`";
    f.reach = h.reach;
    f.never_ends = true;
  }
}

}  // namespace

extern const Rule kOw508{
    .code = "OW508",
    .name = "endless-loop",
    .summary = "a loop that no path leaves",
    .group = Group::kHazards,
    .level = Severity::kError,
    .page = {
        .what = R"(A `while` or `do` whose condition does not change in its body and that has no `break`, `return` or
program end inside: the counter is never counted, another one is, or the condition is constant. A
second `endwhile` or `endrepeat` for a loop that is already closed has the same effect.

Where some runs leave the loop and others never do, it is a warning.)",
        .why = R"(LinuxCNC says nothing. If there are moves in the loop the machine repeats them until it is stopped
by hand; if there are none the screen stands still, and the preview of the program does not finish
loading.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
G0 X0 Y0 Z5
#<z> = 0
o100 while [#<z> GT -10]
  G1 Z#<z> F80
  G1 X50 F300
  G0 Z5
  G0 X0
o100 endwhile
M2
)",
        .good = R"(G21 G90
G0 X0 Y0 Z5
#<z> = 0
o100 while [#<z> GT -10]
  #<z> = [#<z> - 2]
  G1 Z#<z> F80
  G1 X50 F300
  G0 Z5
  G0 X0
o100 endwhile
M2
)",
        .fix = R"(Change the value that the condition looks at, in every pass. For a program that is meant to run
until the operator stops it, suppress the finding with a reason.)",
        .interpreter = "",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
