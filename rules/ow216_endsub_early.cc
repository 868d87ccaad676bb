// OW216 endsub-early: an `endsub` that is not the last one of its sub.
// Rests on: passing over a definition in the program ends at the first `endsub` with the label,
// whatever block it stands in; in a called file the interpreter enters at `sub` and leaves at the
// `endsub` it executes.
#include <algorithm>

#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Region& region : p.regions) {
    if (region.early_end == kNoStatement) continue;
    // Where the interpreter stops in what is left of the body, that stop says so.
    bool stopped = false;
    for (StatementId id = region.early_end; id <= region.end; ++id) stopped = stopped || has_stop(in, id);
    if (stopped) continue;
    Finding& f = out.add(p.at(region.early_end).head_span(), "`" + p.head(region.early_end) + "` comes before the sub's last `endsub` on line " + std::to_string(p.at(region.end).line));
    relate(f, p, region.end, "the last `endsub` stands here");
    f.help = "write `" + p.label_text(region.name) + " return` for an early way out";
    f.reach = in.flow.reach(region.early_end);
    f.fixes.push_back({"write `return`", false, {{p.at(region.early_end).keyword_span(), "return"}}});
  }
}

}  // namespace

extern const Rule kOw216{
    .code = "OW216",
    .name = "endsub-early",
    .summary = "`endsub` before the sub's last one",
    .group = Group::kBlocks,
    .level = Severity::kWarning,
    .page = {
        .what = R"(An `endsub` inside an `if` or loop of its own sub, with another `endsub` at the end: meant as an
early return.)",
        .why = R"(In a called file, and for subs below the program end, LinuxCNC leaves the sub at the first `endsub` that
it executes, so this works as meant. In the program itself, above the call, the definition ends at the
first `endsub`: what follows runs at once as main program and stops, mostly at an `endif` whose `if` it
has never seen. Where that happens it is reported there (OW106, OW101); this rule speaks of the programs
that run, and that stop as soon as somebody moves the sub.)",
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
        .fix = R"(Write `return` for every early way out and keep one `endsub` as the last line of the sub, in files
too.)",
        .interpreter = "",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
