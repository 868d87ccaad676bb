// OW218 call-forgotten: the label of a sub on a line of its own, without `call`.
// Depends on: an O-word without a keyword is a Fanuc-style program number and does nothing; inside a sub it stops.
#include <algorithm>

#include "rules/driver/stops.h"

namespace owlint::rules::ow218 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const StatementId id : in.index.program_numbers) {
    if (has_stop(in, id) || !lacks_call(in, id)) continue;
    // In a sub it stops, which is said where the sub is called.
    if (p.at(id).label == kNoName && p.region_of[id] != kMainRegion) continue;
    const std::string label = p.label_at(id);
    Finding& f = out.add(p.at(id).label_span(), "`" + label + "` alone on a line calls nothing");
    const auto lines = p.at(id).label == kNoName ? std::span<const StatementId>{} : p.by_label[p.at(id).label];
    const auto sub = std::ranges::find_if(lines, [&](StatementId line) { return p.at(line).is(Keyword::kSub); });
    if (sub != lines.end()) relate(f, p, *sub, "the sub is defined here");
    f.help = "write `" + label + " call` to call the sub";
    f.reach = in.flow.reach(id);
    const uint64_t end = p.at(id).label_span().end;
    f.fixes.push_back({"write `" + label + " call`", false, {{{end, end}, " call"}}});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW218",
    .name = "call-forgotten",
    .summary = "the label of a sub without `call`",
    .group = Group::kBlocks,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(`o<drill>` or `o100` alone on a line, if the program defines that sub, or if a file has its name. A
label that is computed, such as `o#1`, alone on a line.)",
            .why = R"(LinuxCNC takes an O-word without a keyword for a Fanuc-style program number and goes on with the
next line. It does not call the sub, and there is **no message**. Inside a sub the line stops the
program with `Nested subroutine definition` or `Fanuc 'O....' subroutine must be called with 'M98'`.

A number as the first word of the program is the program's own number, and is not reported.)",
            .bad = R"(G21 G90
o<drill> sub
  G0 X#1 Y10
  G81 X#1 Y10 Z-5 R2 F80
  G80
o<drill> endsub
G0 X0 Y0 Z5
o<drill>
M2
)",
            .good = R"(G21 G90
o<drill> sub
  G0 X#1 Y10
  G81 X#1 Y10 Z-5 R2 F80
  G80
o<drill> endsub
G0 X0 Y0 Z5
o<drill> call [20]
M2
)",
            .fix =
                R"(Write `call` after the label, with the arguments in brackets. If the line is left over, remove it.)",
            .level_reason = "Error if the program stops here. Warning if it runs on, without the sub.",
            .interpreter = "",
            .options = "",
            .moves = "X0",
            .moves_good = "X20",
        },
    .check = check,
};

}  // namespace owlint::rules::ow218
