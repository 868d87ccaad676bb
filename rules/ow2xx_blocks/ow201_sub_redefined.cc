// OW201 sub-redefined: a second definition of a sub that the run already knows.
// Depends on: all subs are in one table for the whole run, called files included; a second
// definition of the name is an error, also under 0x20.
#include "rules/driver/stops.h"

namespace owlint::rules::ow201 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id, const Elsewhere& first) {
  const std::string label = first.program->label_at(first.statement);
  Finding& f =
      out.add(in.program.at(id).head_span(), "sub `" + label + "` is already defined on " + line_words(in, first));
  relate(in, f, first, "first defined here");
  f.help = "rename or remove one of the two";
  return &f;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out,
            [&](const FlowStop& s) { return report(in, out, s.statement, place_of(in, s.other, s.other_elsewhere)); });
  std::unordered_map<NameId, StatementId> first;
  for (const Region& region : p.regions) {
    if (region.opener == kNoStatement || !p.at(region.opener).is(Keyword::kSub)) continue;
    const auto [entry, added] = first.try_emplace(region.name, region.opener);
    if (added || has_stop(in, region.opener)) continue;
    report(in, out, region.opener, {&p, entry->second})->reach = in.flow.reach(region.opener);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW201",
    .name = "sub-redefined",
    .summary = "two definitions of one sub, in one program or in several files",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(Two `sub` lines with the same label in one program, or a sub of the program with the name of a sub
that was already called from a file. Unlike labels of blocks, names of subs are global for the whole
run.)",
            .why =
                R"(The interpreter stops at the second `sub` line that a run gets to, even if the two subs are equal. A
second definition after `M2` or `M30`, or in a skipped block, is never reached: LinuxCNC uses the
first one, and changes in the other have no effect.)",
            .bad = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
o100 endsub
o100 sub
  G81 X#1 Y30 Z-8 R2 F80
o100 endsub
o100 call [10]
G80
M2
)",
            .good = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
o100 endsub
o110 sub
  G81 X#1 Y30 Z-8 R2 F80
o110 endsub
o100 call [10]
o110 call [10]
G80
M2
)",
            .fix = R"(Remove the old definition, or give one of the two another label and use it in the calls.)",
            .level_reason =
                "Error if a run gets to the second definition: the program stops there. Warning if no run does.",
            .interpreter = "redefining sub: o|100| already defined in file:PROGRAM",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow201
