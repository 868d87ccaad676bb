// OW313 block-delete-misplaced: a `/` that is not the first thing on its line.
// Depends on: block delete is read only before the line number; a later `/` outside brackets is an
// error.
#include <algorithm>

#include "rules/driver/stops.h"

namespace owlint::rules::ow313 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id) {
  Finding& f =
      out.add(in.program.syntax.error(in.program.at(id))->span, "block delete `/` comes after the line number");
  f.help = "write the `/` before the `N`";
  const Statement& s = in.program.at(id);
  const uint64_t first = s.offset + indent_of(*in.program.source, s).size();
  Span slash = f.span;
  const std::string_view behind = in.program.source->slice({slash.end, s.end()});
  slash.end += std::min(behind.find_first_not_of("0123456789"), behind.size());  // the level of a skip
  if (slash != f.span) f.help += "; LinuxCNC has one level, so write no number behind it";
  const bool safe = slash == f.span && !bounds_sub(s);
  f.fixes.push_back({"write the `/` before the `N`", safe, {{{first, first}, "/"}, {slash, ""}}, true});
  return &f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError&) { report(in, out, id)->reach = in.flow.reach(id); });
}

}  // namespace

extern const Rule kRule{
    .code = "OW313",
    .name = "block-delete-misplaced",
    .summary = "block delete `/` after the line number",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A line such as `N40 /G0 Z5` or `N40 /o100 call`: the slash comes after the line number. Other
controls allow that, and also several skip levels such as `/2`.)",
            .why = R"(LinuxCNC looks for `/` only at the very start of the line. Elsewhere it stops with the message
below; `/2 G0 X5` stops with `Bad character '2' used`, and `o100 /if [1]` with `Unknown control
command in o word`, whether block delete is on or off. Skipped lines and subs that nothing calls are
not checked.)",
            .bad = R"(N10 G21 G90
N20 G0 X10 Y10 Z5
N30 G1 Z-2 F80
N40 /G1 Z-4
N50 G0 Z5
N60 M2
)",
            .good = R"(N10 G21 G90
N20 G0 X10 Y10 Z5
N30 G1 Z-2 F80
/N40 G1 Z-4
N50 G0 Z5
N60 M2
)",
            .fix = R"(Write the slash before the line number.)",
            .level_reason = "Error: the program stops here. Warning if no run gets to this line.",
            .interpreter = "Bad character '/' used",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow313
