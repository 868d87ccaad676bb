// OW216 endsub-early: an `endsub` that is not the last one of its sub.
// Depends on: in the program itself a definition ends at the first `endsub` with its label, also if
// that is inside a block; in a called file the interpreter enters at `sub` and leaves at the
// `endsub` that it executes.
#include <algorithm>

#include "rules/driver/stops.h"

namespace owlint::rules::ow216 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Region& region : p.regions) {
    if (region.early_end == kNoStatement) continue;
    // If the interpreter stops in the lines that are cut off, that stop is reported.
    bool stopped = false;
    for (StatementId id = region.early_end; id <= region.end; ++id) stopped = stopped || has_stop(in, id);
    if (stopped) continue;
    Finding& f = out.add(p.at(region.early_end).head_span(),
                         "`" + p.head(region.early_end) + "` comes before the sub's last `endsub` on line " +
                             std::to_string(p.at(region.end).line));
    relate(f, p, region.end, "the last `endsub` is here");
    f.help = "write `" + p.label_text(region.name) + " return` to leave the sub early";
    f.reach = in.flow.reach(region.early_end);
    if (p.sub_file) f.weight = Weight::kRemark;
    f.fixes.push_back({"write `return`", false, {{p.at(region.early_end).keyword_span(), "return"}}});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW216",
    .name = "endsub-early",
    .summary = "an early `endsub`, used like a `return`",
    .group = Group::kBlocks,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(An `endsub` inside an `if` or loop of its own sub, with another `endsub` at the end. The first one
was meant as an early return.)",
            .why = R"(In a called file, and in subs below the program end, LinuxCNC leaves the sub at the first `endsub`
that it executes, so this works as intended. In the program itself, above the call, the definition
ends at the first `endsub`. The lines after it run at once as main program and stop, usually at an
`endif` whose `if` LinuxCNC does not know. If that happens, it is reported there (OW106, OW101).
This rule is for programs that run now, and stop as soon as somebody moves the sub.)",
            .bad = R"(G21 G90 F80
o100 call [10]
o100 call [-5]
M2
o100 sub
  o110 if [#1 LE 0]
    o100 endsub
  o110 endif
  G81 X#1 Y10 Z-5 R2
  G80
o100 endsub
)",
            .good = R"(G21 G90 F80
o100 call [10]
o100 call [-5]
M2
o100 sub
  o110 if [#1 LE 0]
    o100 return
  o110 endif
  G81 X#1 Y10 Z-5 R2
  G80
o100 endsub
)",
            .fix = R"(Write `return` for every early exit, and keep one `endsub` as the last line of the sub, in files
too.)",
            .level_reason = "Warning: the program stops as soon as somebody moves the sub. Info in a called file, "
                            "where every version of LinuxCNC takes it for a `return`.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow216
