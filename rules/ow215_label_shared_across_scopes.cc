// OW215 label-shared-across-scopes: one number used in several scopes, or both as a sub and as a block.
// Rests on: subs have one name space for the run, all other labels are local to their sub, so this
// always works.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  // By label: the lines that open something with it, in their order.
  std::vector<std::pair<NameId, StatementId>> openers;
  for (StatementId id = 0; id < p.size(); ++id) {
    const Statement& s = p.at(id);
    if (s.kind != LineKind::kOWord || s.label == kNoName) continue;
    const BlockId block = p.block_of[id];
    if (s.is(Keyword::kSub) || (block != kNoBlock && p.blocks[block].opener == id)) openers.emplace_back(s.label, id);
  }
  std::ranges::sort(openers);
  for (size_t i = 0; i < openers.size();) {
    const auto [label, first] = openers[i++];
    bool reported = false;
    for (; i < openers.size() && openers[i].first == label; ++i) {
      const StatementId id = openers[i].second;
      const bool subs = p.at(first).opens_sub() || p.at(id).opens_sub();
      if (reported || (!subs && p.region_of[first] == p.region_of[id])) continue;
      reported = true;
      Finding& f = out.add(p.at(id).label_span(), "`" + p.label_text(label) + "` is also used by `" + p.head(first) + "` on line " + std::to_string(p.at(first).line));
      relate(f, p, first, "first used here");
      f.help = "labels are local to a sub, so this runs; different numbers are easier to read";
      f.reach = in.flow.reach(id);
    }
  }
}

}  // namespace

extern const Rule kOw215{
    .code = "OW215",
    .name = "label-shared-across-scopes",
    .summary = "one number used in several subs, or both as sub and as block",
    .group = Group::kBlocks,
    .level = Severity::kInfo,
    .page = {
        .what = R"(A number that labels blocks in more than one sub (or in a sub and in the main program), or that is a
sub in one place and a block in another.)",
        .why = R"(LinuxCNC keeps these apart and runs the program as written. It makes the program harder to read and
search, and copying a block from one sub into another turns it into a duplicate label that stops the
machine.)",
        .bad = R"(G21 G90
o100 sub
  o100 if [#1 GT 0]
    G81 X#1 Y10 Z-5 R2 F80
  o100 endif
  G80
o100 endsub
o100 call [#5420]
M2
)",
        .good = R"(G21 G90
o100 sub
  o110 if [#1 GT 0]
    G81 X#1 Y10 Z-5 R2 F80
  o110 endif
  G80
o100 endsub
o100 call [#5420]
M2
)",
        .fix = R"(Number each sub's blocks in a range of their own, for instance 110 to 199 inside `o100`. Shops with
many short subs that all start at `o101` may leave this rule off; it is off unless selected.)",
        .interpreter = "",
        .options = "--select OW215",
    },
    .check = check,
};

}  // namespace owlint::rules
