// OW213 return-other-label: a `return` inside a sub with a label other than the sub's.
// Depends on: an executed `return` leaves the running sub whatever its label says; only while
// skipping the label counts.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const StatementId id : in.index.sub_lines) {
    const Statement& s = p.at(id);
    const Region& region = p.regions[p.region_of[id]];
    if (!s.is(Keyword::kReturn) || s.label == kNoName || region.name == kNoName || s.label == region.name || has_stop(in, id)) continue;
    if (!p.at(region.opener).is(Keyword::kSub)) continue;
    Finding& f = out.add(s.label_span(), "`" + p.head(id) + "` returns from `" + p.label_text(region.name) + "`, the sub in which it stands");
    relate(f, p, region.opener, "the sub begins here");
    f.help = "write `" + p.label_text(region.name) + " return`";
    f.reach = in.flow.reach(id);
    f.fixes.push_back({"write `" + p.label_text(region.name) + " return`", false, {{s.label_span(), p.label_text(region.name)}}});
  }
}

}  // namespace

extern const Rule kOw213{
    .code = "OW213",
    .name = "return-other-label",
    .summary = "`return` with a label other than its sub's",
    .group = Group::kBlocks,
    .level = Severity::kInfo,
    .page = {
        .what = R"(A `return` in the body of a sub that carries another label, often that of the `if` it stands in.)",
        .why = R"(LinuxCNC does not compare the labels: the running sub is left, even if the label is the caller's.
Who reads `o110 return` may believe that only block `o110` is left, or that the sub `o110` is;
neither is so. What the label is good for is undocumented, so another version need not do the same.
The value of such a `return` is not evaluated where the definition is passed over, that of the sub's
own is.)",
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
        .fix = R"(Write the sub's own label. If only the `if` was to be left, take the `return` out.)",
        .level_reason = "Info: the program does what is meant, and LinuxCNC's own programs are written so.",
        .interpreter = "",
        .options = "--extend-select OW213",
    },
    .check = check,
};

}  // namespace owlint::rules
