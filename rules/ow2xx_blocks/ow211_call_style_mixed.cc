// OW211 call-style-mixed: the Fanuc style (M98, M99, bare O number) mixed with `sub`, `call`, `endsub`.
// Depends on: a frame remembers how it was called; `sub`, bare O, `endsub`, `return` and M99 each
// refuse the other style.

#include "rules/driver/block_helpers.h"
#include "rules/driver/idioms.h"

namespace owlint::rules::ow211 {
namespace {

/// The line of G70, G71 or G72 that has called the sub for its contour; nothing if it was another call.
const Statement* contour_of(const Input& in, const FlowStop& s) {
  const Elsewhere call = place_of(in, s.call, s.call_elsewhere);
  if (call.program == nullptr || call.program->at(call.statement).kind != LineKind::kContour) return nullptr;
  return &call.program->at(call.statement);
}

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
        if (contour_of(in, s) != nullptr) {
          const std::string label = p.label_at(s.statement);
          message = "`" + p.head(s.statement) + "` is a Fanuc-style sub, but `Q" + label.substr(1) +
              "` of a contour needs one with `sub`";
          help = "write it as `" + label + " sub` … `" + label + " endsub`";
          break;
        }
        message = "`" + p.head(s.statement) + "` is a Fanuc-style sub, but it is called with `call`";
        help = "call it with `M98 P" + p.label_at(s.statement).substr(1) + "`, or write it with `sub` and `endsub`";
        break;
      case StopKind::kStyleNeedsCall:
        message = "`" + p.head(s.statement) + "` is called with `M98`, which only calls Fanuc-style subs";
        help = "call it with `" + p.label_at(s.statement) + " call`";
        break;
      case StopKind::kStyleNeedsM99:
        message = "`" + p.head(s.statement) + "` ends a sub that was called with `M98`";
        help = "end a Fanuc-style sub with `M99`";
        break;
      case StopKind::kFanucDisabled:
        message = line.kind == LineKind::kOWord ? "`" + p.head(s.statement) +
                "` without a keyword is a Fanuc-style program number, but this machine's INI turns these off"
                                                : "`M98` is a Fanuc-style call, which this machine's INI turns off";
        help = "call with `call` and define with `sub` and `endsub`, or remove `DISABLE_FANUC_STYLE_SUB` from the INI";
        break;
      default:
        message = "`M99` ends a sub that was called with `call`";
        help = "end the sub with `endsub`; leave it early with `return`";
        break;
    }
    Finding& f = out.add(line.kind == LineKind::kOWord ? line.head_span() : line.keyword_span(), std::move(message));
    f.help = std::move(help);
    if (is_forgotten_end(p, s.statement)) {
      tell_forgotten_end(p, s.statement, f);
    } else if (s.kind == StopKind::kStyleNeedsM98) {
      explain_idiom(in, s.statement, f);  // `o100 (why) sub`
    }
    relate(f, p, s.call, "called here");
    return &f;
  });
  // One number both as a program number and as a sub: runs, but only one of them can be called.
  std::vector<bool> looked(p.syntax.names.size());
  for (const Region& region : p.regions) {
    if (region.name == kNoName || looked[region.name]) continue;
    looked[region.name] = true;
    if (region.opener == kNoStatement || has_stop(in, region.opener) || !p.at(region.opener).is(Keyword::kSub))
      continue;
    for (const StatementId other : p.by_label[region.name]) {
      if (!p.at(other).is(Keyword::kBare) || has_stop(in, other) || lacks_call(in, other)) continue;
      Finding& f = out.add(p.at(region.opener).head_span(),
                           "`" + p.label_text(region.name) + "` is both a program number and a sub");
      relate(f, p, other, "the program number is here");
      f.help = "give the sub another number";
      f.reach = in.flow.reach(region.opener);
      break;
    }
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW211",
    .name = "call-style-mixed",
    .summary = "M98, M99 or a bare `O` number mixed with `sub`, `call`, `endsub`",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(LinuxCNC has two kinds of subs: `o100 sub` … `o100 endsub`, called with `o100 call`, and the Fanuc
kind `o100` … `M99`, called with `M98 P100`. This rule finds calls of one kind for a sub of the
other kind, `M99` in the first kind, and `endsub` or `return` in the second.)",
            .why = R"(The interpreter stops where the two are mixed: `'O.... sub' subroutine must be called with 'O....
call'`, `Fanuc 'O....' subroutine must be called with 'M98'`, `'O.... endsub' or 'O.... return' must
follow 'O.... sub' subroutine definition`, `Fanuc 'O....' subroutine definition must end with
'M99'`. If the end is of the wrong kind, it stops only after the sub has run. Unlike `call`, `M98`
does not pass arguments and does not restore `#1` to `#30`.)",
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
            .fix =
                R"(Use one kind for the sub and all its calls; `sub` and `call` can do more. A program may have subs of
both kinds if each is called in its own way.)",
            .level_reason = "Error if a run mixes both: the program stops. Warning if no run does.",
            .interpreter = "'O.... sub' subroutine must be called with 'O.... call'",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow211
