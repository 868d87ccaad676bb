// OW211 call-style-mixed: the Fanuc style (M98, M99, bare O number) mixed with `sub`, `call`, `endsub`.
// Depends on: a frame remembers how it was called; `sub`, bare O, `endsub`, `return` and M99 each
// refuse the other style.

#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& s) -> Finding* {
    const Statement& line = p.at(s.statement);
    std::string message;
    std::string help;
    switch (s.kind) {
      case StopKind::kStyleNeedsM98:
        if (lacks_call(in, s.statement) && p.regions[p.region_of[s.statement]].opener != s.statement) {
          message = "`" + p.head(s.statement) + "` alone on a line calls nothing, and stops in a sub";
          help = "write `" + p.head(s.statement) + " call`";
          break;
        }
        message = "`" + p.head(s.statement) + "` is a Fanuc-style sub, but a `call` leads here";
        help = "call it with `M98 P" + p.label_at(s.statement).substr(1) + "`, or write it with `sub` and `endsub`";
        break;
      case StopKind::kStyleNeedsCall:
        message = "`" + p.head(s.statement) + "` is reached from `M98`, which only calls Fanuc-style subs";
        help = "call it with `" + p.label_at(s.statement) + " call`";
        break;
      case StopKind::kStyleNeedsM99:
        message = "`" + p.head(s.statement) + "` ends a sub that `M98` called";
        help = "end a Fanuc-style sub with `M99`";
        break;
      case StopKind::kFanucDisabled:
        message = line.kind == LineKind::kOWord ? "`" + p.head(s.statement) + "` without a keyword is a Fanuc-style program number, which this machine's INI turns off"
                                                : "`M98` is a Fanuc-style call, which this machine's INI turns off";
        help = "call with `call`, define with `sub` and `endsub`, or take `DISABLE_FANUC_STYLE_SUB` out of the INI";
        break;
      default:
        message = "`M99` ends a sub that a `call` called";
        help = "end the sub with `endsub`, leave it early with `return`";
        break;
    }
    Finding& f = out.add(line.kind == LineKind::kOWord ? line.head_span() : line.keyword_span(), std::move(message));
    f.help = std::move(help);
    relate(f, p, s.call, "called from here");
    return &f;
  });
  // One number both as a program number and as a sub: runs, but only one of them can be called.
  std::vector<bool> looked(p.syntax.names.size());
  for (const Region& region : p.regions) {
    if (region.name == kNoName || looked[region.name]) continue;
    looked[region.name] = true;
    if (region.opener == kNoStatement || has_stop(in, region.opener) || !p.at(region.opener).is(Keyword::kSub)) continue;
    for (const StatementId other : p.by_label[region.name]) {
      if (!p.at(other).is(Keyword::kBare) || has_stop(in, other) || lacks_call(in, other)) continue;
      Finding& f = out.add(p.at(region.opener).head_span(), "`" + p.label_text(region.name) + "` is both a program number and a sub");
      relate(f, p, other, "the program number stands here");
      f.help = "give the sub another number";
      f.reach = in.flow.reach(region.opener);
      break;
    }
  }
}

}  // namespace

extern const Rule kOw211{
    .code = "OW211",
    .name = "call-style-mixed",
    .summary = "M98, M99 or a bare `O` number mixed with `sub`, `call`, `endsub`",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page = {
        .what = R"(LinuxCNC knows two kinds of subprogram: `o100 sub` … `o100 endsub`, called by `o100 call`, and the
Fanuc kind `o100` … `M99`, called by `M98 P100`. The rule finds a call of one kind for a sub of the
other, `M99` in the first kind, and `endsub` or `return` in the second.)",
        .why = R"(The interpreter stops where the two meet: `'O.... sub' subroutine must be called with 'O.... call'`,
`Fanuc 'O....' subroutine must be called with 'M98'`,
`'O.... endsub' or 'O.... return' must follow 'O.... sub' subroutine definition`,
`Fanuc 'O....' subroutine definition must end with 'M99'`. A wrong end is only met after the body
has been cut. Unlike `call`, `M98` neither passes arguments nor restores `#1` to `#30`.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
o100 sub
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endsub
G0 X0 Y0 Z5
o100 call
M98 P100
M2
)",
        .good = R"(G21 G90
o100 sub
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endsub
G0 X0 Y0 Z5
o100 call
o100 call
M2
)",
        .fix = R"(Use one style for the sub and all its calls; `sub` and `call` are the richer one. The same program
may hold subs of both kinds, if each is called in its own way.)",
        .level_reason = "Error where a run mixes both: the program stops. Warning where no run does.",
        .interpreter = "'O.... sub' subroutine must be called with 'O.... call'",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
