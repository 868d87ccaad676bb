// OW203 sub-in-block: a sub that is defined inside an `if` or a loop.
// Depends on: a definition exists only after its `sub` line was reached, and reaching the line a
// second time is an error.
#include <unordered_set>

#include "rules/driver/stops.h"

namespace owlint::rules::ow203 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const Block& block = p.blocks[p.regions[p.region_of[id]].enclosing];
  const bool loop = block.kind != Keyword::kIf;
  Finding& f = out.add(p.at(id).head_span(),
                       "sub `" + p.label_at(id) + "` is defined inside `" + p.head_of(block) + "`" +
                           (loop ? ": the second pass defines it again" : ": if that is skipped, the sub is unknown"));
  relate(f, p, block.opener, "the block begins here");
  f.help = "move the definition out of the block, before the first call";
  const Region& region = p.regions[p.region_of[id]];
  if (region.end != kNoStatement)
    f.fixes.push_back(move_up(p, id, region.end, outermost(p, id), "move the definition out of the block"));
  return &f;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  std::unordered_set<NameId> not_found;
  if (const auto lost = in.index.by_code.find("OW208"); lost != in.index.by_code.end()) {
    for (const FlowStop* s : lost->second) not_found.insert(p.at(s->statement).label);
  }
  for (const Region& region : p.regions) {
    if (region.opener == kNoStatement || region.enclosing == kNoBlock || has_stop(in, region.opener)) continue;
    if (!p.at(region.opener).is(Keyword::kSub)) continue;
    const bool reported = not_found.contains(region.name);  // the call that does not find it says so
    if (!reported) report(in, out, region.opener)->reach = in.flow.reach(region.opener);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW203",
    .name = "sub-in-block",
    .summary = "a sub defined inside an `if` or loop: it may not exist, or be defined twice",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A `sub` … `endsub` inside an `if`, `while`, `do` or `repeat`. The sub then exists only if the
program runs through that block.)",
            .why = R"(In a loop the interpreter stops at the `sub` line in the second pass, when the work of the first
pass is already done. If an `if` is skipped, the sub does not exist: a later call looks for it up to
the end of the file and stops with `EOF in file … seeking o-word`. If the `if` is taken, it
works.)",
            .bad = R"(G21 G90
#<x> = 0
o100 while [#<x> LT 40]
  o200 sub
    G81 X#1 Y10 Z-5 R2 F80
  o200 endsub
  o200 call [#<x>]
  #<x> = [#<x> + 10]
o100 endwhile
G80
M2
)",
            .good = R"(G21 G90
o200 sub
  G81 X#1 Y10 Z-5 R2 F80
o200 endsub
#<x> = 0
o100 while [#<x> LT 40]
  o200 call [#<x>]
  #<x> = [#<x> + 10]
o100 endwhile
G80
M2
)",
            .fix = R"(Move the sub to the top of the program, before the block. To choose between two subs, define both
and choose the `call`.)",
            .level_reason = "Error if a run stops: the sub is missing, or defined twice. Warning if no run does.",
            .interpreter = "sub: o|200| found in illegal location",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow203
