// OW507 argument-not-passed: a call that does not pass an argument which the sub reads.
// Rests on: a call sets #1 to #30, and those without a value are 0, although the documentation
// says they keep the caller's value.
#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kArgumentNotPassed) continue;
    const Statement& call = p.at(h.statement);
    const Elsewhere read = place_of(in, h.other, h.other_elsewhere);
    const std::string number = "`#" + std::to_string(h.number) + "`";
    Finding& f = out.add(call.head_span(), "`" + p.head(h.statement) + "` passes " + std::to_string(call.value_count) + (call.value_count == 1 ? " argument" : " arguments") + ", but the sub reads " + number + " on " + line_words(in, read) + ": it is 0 there");
    relate(in, f, read, number + " is read here");
    f.help = "pass a " + ordinal(h.number) + " argument, or set " + number + " in the sub before it is read";
    f.reach = h.reach;
  }
}

}  // namespace

extern const Rule kOw507{
    .code = "OW507",
    .name = "argument-not-passed",
    .summary = "the sub reads `#n`, but this call does not pass it: it is 0",
    .group = Group::kHazards,
    .level = Severity::kWarning,
    .page = {
        .what = R"(A `call` with fewer values than the sub uses: the sub reads `#3`, the call passes two.)",
        .why = R"(LinuxCNC sets what was not passed to **0**. The documentation says that the caller's values stay,
but the interpreter does not do that, so a `#3` set before the call does not arrive either. A depth,
a feed or a safe height of 0 is a plunge to the zero face or a rapid through the part, with no
message.)",
        .bad = R"(G21 G90
o100 sub
  G0 X#1 Y#2
  G1 Z-5 F80
  G0 Z#3
o100 endsub
G0 Z5
o100 call [10] [10] [5]
o100 call [30] [10]
M2
)",
        .good = R"(G21 G90
o100 sub
  G0 X#1 Y#2
  G1 Z-5 F80
  G0 Z#3
o100 endsub
G0 Z5
o100 call [10] [10] [5]
o100 call [30] [10] [5]
M2
)",
        .fix = R"(Pass a value for every argument. If 0 is meant as "use the default", pass `[0]` so that it can be
seen.)",
        .interpreter = "",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
