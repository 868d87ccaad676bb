// OW210 call-too-deep: a chain of calls, or a recursion, beyond the limit of nine.
// Depends on: nine calls may be open at once; the tenth is an error. Each called file and M98 counts.
#include "rules/driver/ini_places.h"
#include "rules/driver/remap_rules.h"

namespace owlint::rules::ow210 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& s) -> Finding* {
    if (s.kind == StopKind::kRemapTooDeep) {
      const std::string code = p.head(s.statement);
      Finding& f = out.add(p.at(s.statement).head_span(),
                           "`" + code + "` can be the tenth remapped code inside each other; LinuxCNC allows nine");
      const NameId around = p.regions[p.region_of[s.statement]].name;
      if (around != kNoName && around == p.at(s.statement).label)
        f.message = "`" + code + "` is used in the sub that it runs, and runs that again and again";
      f.help = "only M6, M61, M62 to M68, M0, M1, M60, T, S and F are built-in codes within their own subs";
      if (const Ini::Entry* const entry = remap_entry(in, s.statement)) {
        relate_ini(f, *entry, "`" + code + "` is remapped here");
        const RemapLine remap = read_remap(entry->value, 0);
        if (remap.letter() == 'M') f.help = help_for_own_code(remap.m_number());
      }
      return &f;
    }
    Finding& f = out.add(p.at(s.statement).head_span(),
                         "`" + p.head(s.statement) + "` can be the tenth level of calls; LinuxCNC allows nine");
    const RegionId region = p.region_of[s.statement];
    const bool recursive = p.regions[region].name != kNoName && p.regions[region].name == p.at(s.statement).label;
    if (recursive) {
      f.message = "`" + p.head(s.statement) + "` calls its own sub" +
          (s.unproven ? "; owlint cannot tell how deep the calls nest" : " again and again") +
          ", and LinuxCNC allows nine levels";
      relate(f, p, p.regions[region].opener, "the sub begins here");
    }
    f.help = recursive ? "use a loop, or count the depth and stop before the tenth call"
                       : "call the subs one after the other instead";
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW210",
    .name = "call-too-deep",
    .summary = "calls or recursion more than nine levels deep",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(Calls nested more than nine deep, or a sub that calls itself, directly or through other subs, without
an exit.)",
            .why = R"(LinuxCNC allows nine calls inside each other. It stops at the tenth, in the middle of the ninth: a
pecking cycle that calls itself without an exit makes nine pecks and stops.)",
            .bad = R"(G21 G90
o<peck> sub
  G1 Z[0 - #1] F80
  G0 Z2
  o<peck> call [#1 + 2]
o<peck> endsub
G0 X10 Y10 Z2
o<peck> call [2]
M2
)",
            .good = R"(G21 G90
o<peck> sub
  #<depth> = 0
  o100 while [#<depth> LT #1]
    #<depth> = [#<depth> + 2]
    G1 Z[0 - #<depth>] F80
    G0 Z2
  o100 endwhile
o<peck> endsub
G0 X10 Y10 Z2
o<peck> call [12]
M2
)",
            .fix = R"(Use a `while` or `repeat` instead of recursion. A recursion with an exit works if it is never more
than nine levels deep.)",
            .level_reason = "Error if a run nests too deep: the program stops. Warning if the depth of a recursion "
                            "depends on values.",
            .interpreter = "Too many subroutine levels",
            .options = "",
        },
    .check = check,
    .of_callers = true,
};

}  // namespace owlint::rules::ow210
