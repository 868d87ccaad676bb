// OW307 zero-for-letter-o: the figure zero typed where the letter O belongs.
// Depends on: a line cannot begin with a digit; while skipping, the line is not an O-word and ends
// nothing.
#include "rules/driver/stops.h"

namespace owlint::rules::ow307 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const LineError* error = in.program.syntax.error(in.program.at(id));
  Finding& f = out.add(error->span, "this O-word begins with the digit zero instead of the letter O");
  f.help = "write the letter `o`";
  f.fixes.push_back({"write the letter `o`",
                     !bounds_sub(in.program.at(id)),
                     {{{error->span.begin, error->span.begin + 1}, "o"}},
                     true});
  return &f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError&) { report(in, out, id)->reach = in.flow.reach(id); });
}

}  // namespace

extern const Rule kRule{
    .code = "OW307",
    .name = "zero-for-letter-o",
    .summary = "the digit 0 instead of the letter O",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A line such as `0100 sub` or `01 endif` that begins with the digit zero and looks like an O-word. On
many screens and printouts the two look the same.)",
            .why = R"(The interpreter stops at the line. While it skips, or in a sub that nothing calls, it ignores the
line: a `01 else` does not count, a `01 endif` does not end its block, and LinuxCNC skips everything
below, up to the end of the file.)",
            .bad = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
0100 call [30]
M2
)",
            .good = R"(G21 G90
o100 sub
  G81 X#1 Y10 Z-5 R2 F80
  G80
o100 endsub
o100 call [10]
o100 call [30]
M2
)",
            .fix = R"(Write a small `o`: it does not look like a zero.)",
            .level_reason = "Error: the program stops here. Warning if no run gets to this line.",
            .interpreter = "Bad character '0' used",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow307
