// OW213 return-other-label: a `return` inside a sub with a label other than the sub's.
// Depends on: an executed `return` leaves the running sub whatever its label says; only while
// skipping the label counts.
#include "rules/driver/stops.h"

namespace owlint::rules::ow213 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const StatementId id : in.index.sub_lines) {
    const Statement& s = p.at(id);
    const Region& region = p.regions[p.region_of[id]];
    if (!s.is(Keyword::kReturn) || s.label == kNoName || region.name == kNoName || s.label == region.name ||
        has_stop(in, id))
      continue;
    if (!p.at(region.opener).is(Keyword::kSub)) continue;
    Finding& f = out.add(s.label_span(),
                         "`" + p.head(id) + "` returns from `" + p.label_text(region.name) + "`, the sub around it");
    relate(f, p, region.opener, "the sub begins here");
    f.help = "write `" + p.label_text(region.name) + " return`";
    f.reach = in.flow.reach(id);
    f.fixes.push_back(
        {"write `" + p.label_text(region.name) + " return`", false, {{s.label_span(), p.label_text(region.name)}}});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW213",
    .name = "return-other-label",
    .summary = "a `return` with a label other than its sub's",
    .group = Group::kBlocks,
    .level = Severity::kInfo,
    .page =
        {
            .what = R"(A `return` in a sub, but with another label, often that of the `if` around it.)",
            .why =
                R"(LinuxCNC does not compare the labels: it leaves the running sub, whatever the label is. A reader of
`o110 return` may think that it leaves only block `o110`, or the sub `o110`; both are wrong. The
documentation does not say what the label is for, so another version may do something else. The
value of such a `return` is not computed when the definition is skipped, unlike the value of a
`return` with the sub's own label.)",
            .bad = R"(G21 G90
o100 sub
  o110 if [#1 LE 0]
    o110 return
  o110 endif
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
o100 call [#5420]
M2
)",
            .good = R"(G21 G90
o100 sub
  o110 if [#1 LE 0]
    o100 return
  o110 endif
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
o100 call [#5420]
M2
)",
            .fix = R"(Write the sub's own label. If the program should only leave the `if`, remove the `return`.)",
            .level_reason = "Info: the program does what is intended, and LinuxCNC's own programs do this too.",
            .interpreter = "",
            .options = "--extend-select OW213",
        },
    .check = check,
};

}  // namespace owlint::rules::ow213
