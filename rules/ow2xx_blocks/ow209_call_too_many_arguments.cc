// OW209 call-too-many-arguments: a `call` with more than 30 arguments.
// Depends on: a call fills #1 to #30; a 31st bracket is an error when the line is read.
#include "rules/driver/stops.h"

namespace owlint::rules::ow209 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id, Span extra) {
  Finding& f = out.add(extra, "`" + in.program.head(id) + "` passes more than 30 arguments");
  f.help = "a sub has only `#1` to `#30`: pass the rest in global parameters such as `#<_depth>`";
  return &f;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out,
            [&](const FlowStop& s) { return report(in, out, s.statement, p.syntax.error(p.at(s.statement))->span); });
  for_unmet_errors(in, out,
                   [&](StatementId id, const LineError& e) { report(in, out, id, e.span)->reach = in.flow.reach(id); });
}

}  // namespace

extern const Rule kRule{
    .code = "OW209",
    .name = "call-too-many-arguments",
    .summary = "more than 30 arguments on a `call`",
    .group = Group::kBlocks,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A `call` with more than 30 values in brackets.)",
            .why = R"(The arguments become `#1` to `#30` of the sub; there is no place for a 31st. `#31` and above are
global, so a sub that reads `#31` reads no argument. The interpreter stops at the line.)",
            .bad = R"(G21 G90
o100 sub
  G81 X#1 Y#2 Z#3 R2 F80
  X#4 Y#5 Z#6
  X#7 Y#8 Z#9
  X#10 Y#11 Z#12
  X#13 Y#14 Z#15
  X#16 Y#17 Z#18
  X#19 Y#20 Z#21
  X#22 Y#23 Z#24
  X#25 Y#26 Z#27
  X#28 Y#29 Z#30
  G80
o100 endsub
o100 call [0][0][-5] [9][0][-5] [18][0][-5] [27][0][-5] [36][0][-5] [0][9][-8] [9][9][-8] [18][9][-8] [27][9][-8] [36][9][-8] [2]
M2
)",
            .good = R"(G21 G90
o100 sub
  G81 X#1 Y#2 Z#3 R2 F80
  X#4 Y#5 Z#6
  X#7 Y#8 Z#9
  X#10 Y#11 Z#12
  X#13 Y#14 Z#15
  X#16 Y#17 Z#18
  X#19 Y#20 Z#21
  X#22 Y#23 Z#24
  X#25 Y#26 Z#27
  X#28 Y#29 Z#30
  G80
o100 endsub
o100 call [0][0][-5] [9][0][-5] [18][0][-5] [27][0][-5] [36][0][-5] [0][9][-8] [9][9][-8] [18][9][-8] [27][9][-8] [36][9][-8]
M2
)",
            .fix =
                R"(Split the work into several calls, or pass what is the same for all of them in a global name such as
`#<_depth>`.)",
            .level_reason = "Error if a run gets to the call: the program stops. Warning if no run does.",
            .interpreter = "Too many subroutine parameters",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow209
