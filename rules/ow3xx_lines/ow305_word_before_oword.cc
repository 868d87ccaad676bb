// OW305 word-before-oword: a word, an assignment or a comment in front of the O-word.
// Depends on: only `/` and a line number may come before `o`; anywhere else `o` is not a letter the
// interpreter knows.
#include "rules/driver/idioms.h"

namespace owlint::rules::ow305 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Statement& s = in.program.at(id);
  const Span span = in.program.syntax.error(s)->span;
  Finding& f = out.add(span, "an O-word must come first on its line");
  f.help = "put it on a line of its own; only `/` and a line number may come before it";
  f.fixes.push_back(split_line(in.program, s, span.begin, "put the O-word on a line of its own"));
  f.fixes[0].safe =
      f.fixes[0].safe && calls_known_subs(in, std::string(in.program.source->slice({span.begin, s.end()})));
  explain_idiom(in, id, f);
  return &f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError&) { report(in, out, id)->reach = in.flow.reach(id); });
}

}  // namespace

extern const Rule kRule{
    .code = "OW305",
    .name = "word-before-oword",
    .summary = "a word before the O-word",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what = R"(An O-word that is not the first thing on its line: `M5 o100 call`, `G0 Z5 o110 endif`, `#1=3 o100
call [#1]`. Only the block delete `/` and a line number `N…` may come before it; not even a comment.)",
            .why = R"(The interpreter reads such a line as ordinary G-code and stops at the `o`. While it skips, or in a
sub that nothing calls, it does not see the O-word: an `endif` or `endwhile` on such a line does not
end its block, and LinuxCNC skips up to the end of the file.)",
            .bad = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
G0 Z5 o100 call [30]
M2
)",
            .good = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
G0 Z5
o100 call [30]
M2
)",
            .fix = R"(Write the O-word on a line of its own.)",
            .level_reason = "Error: the program stops here. Warning if no run gets to this line.",
            .interpreter = "Bad character 'o' used",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow305
