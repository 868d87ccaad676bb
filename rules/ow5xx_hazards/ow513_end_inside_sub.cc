// OW513 end-inside-sub: M2 or M30 in a sub whose caller has lines after the call.
// Depends on: M2 and M30 end the run everywhere, also in a called file (measured).
#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow513 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kEndsInSub) continue;
    const Elsewhere call = place_of(in, h.other, h.other_elsewhere);
    const Statement& s = p.at(h.statement);
    const Region& sub = p.regions[p.region_of[h.statement]];
    const bool fanuc = call.program->at(call.statement).kind == LineKind::kM98;
    // A sub of a called file that is not closed may end before the line: then the call names it.
    const std::string name = sub.name == kNoName ? call.program->label_at(call.statement) : p.label_text(sub.name);
    Finding& f = out.add(s.whole(),
                         "the program ends here, inside `" + name + "`: the lines after the call on " +
                             line_words(in, call) + " do not run");
    relate(in, f, call, "called here");
    f.help = fanuc ? "go back with `M99`; the program that calls the sub has the `M2`"
                   : "go back with `" + name + " endsub`; the program that calls the sub has the `M2`";
    f.reach = h.reach;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW513",
    .name = "end-inside-sub",
    .summary = "M2 or M30 in a sub ends the program: the lines after the call do not run",
    .group = Group::kHazards,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(An `M2` or `M30` in a sub, or in a called file instead of its `endsub`, that every run of the call
reaches, while the caller has more lines after the call. An `M2` inside an `if` is not reported, and
neither is a call inside an `if`: programs use that to abort on purpose.)",
            .why =
                R"(`M2` and `M30` end the whole program, not only the sub. There is no message; the job looks finished.
In the first program below the second hole is missing.)",
            .bad = R"(G21 G90
o<hole> sub
  G0 X#1
  G1 Z-5 F80
  G0 Z5
  M2
o<hole> endsub
G0 Z5
o<hole> call [10]
o<hole> call [30]
M2
)",
            .good = R"(G21 G90
o<hole> sub
  G0 X#1
  G1 Z-5 F80
  G0 Z5
o<hole> endsub
G0 Z5
o<hole> call [10]
o<hole> call [30]
M2
)",
            .fix = R"(Remove the `M2` from the sub. A called file needs none: it ends with `endsub`.)",
            .level_reason = "Warning: the program runs, but ends before the lines after the call.",
            .interpreter = "",
            .options = "",
            .moves = "X10",
            .moves_good = "X30",
        },
    .check = check,
};

}  // namespace owlint::rules::ow513
