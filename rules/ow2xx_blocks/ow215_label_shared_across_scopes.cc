// OW215 label-shared-across-scopes: one number used in several scopes, or both as a sub and as a block.
// Depends on: labels of subs are global, all other labels are local to their sub, so this always
// works.
#include "rules/driver/stops.h"

namespace owlint::rules::ow215 {
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
      Finding& f = out.add(p.at(id).label_span(),
                           "`" + p.label_text(label) + "` is also used by `" + p.head(first) + "` on line " +
                               std::to_string(p.at(first).line));
      relate(f, p, first, "first used here");
      f.help = "this runs, because labels are local to a sub; different numbers are easier to read";
      f.reach = in.flow.reach(id);
    }
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW215",
    .name = "label-shared-across-scopes",
    .summary = "one number used in several subs, or both as sub and as block",
    .group = Group::kBlocks,
    .level = Severity::kInfo,
    .page =
        {
            .what =
                R"(A number that labels blocks in more than one sub (or in a sub and in the main program), or a number
that is a sub in one place and a block in another.)",
            .why =
                R"(LinuxCNC keeps these apart and runs the program as written. But the program is harder to read and to
search. If you copy a block from one sub into another, the label is there twice, and the program
stops.)",
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
            .fix = R"(Give the blocks of each sub a range of numbers of their own, for example 110 to 199 inside `o100`.
If you have many short subs that all start at `o101`, leave this rule off; it is off unless you
select it.)",
            .level_reason = "Info: it runs, and many programs begin with the same number in each sub.",
            .interpreter = "",
            .options = "--extend-select OW215",
        },
    .check = check,
};

}  // namespace owlint::rules::ow215
