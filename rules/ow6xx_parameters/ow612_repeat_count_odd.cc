// OW612 repeat-count-odd: a `repeat` count that is negative, zero or not a whole number.
// Depends on: the count is rounded to the nearest whole number, halves to the even one, and below 1 there is no pass
// (measured: 2.5 makes 2 passes, 3.5 makes 4, 0.5 none).
#include <cmath>

#include "rules/driver/stops.h"

namespace owlint::rules::ow612 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kRepeatCount) continue;
    const double count = std::stod(h.detail);
    const double passes = std::max(0.0, std::nearbyint(count));
    const std::string makes = passes == 0
        ? "no pass is made"
        : std::to_string(static_cast<long>(passes)) + (passes == 1 ? " pass is made" : " passes are made");
    const bool whole = count == std::nearbyint(count);
    Finding& f = out.add(p.at(h.statement).head_span(),
                         "`" + p.head(h.statement) + "` has the count " + h.detail + ": " + makes);
    f.help = whole ? "use a count of 1 or more, or remove the loop"
                   : "compute a whole number: `FUP[...]` rounds up, `FIX[...]` down";
    f.reach = h.reach;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW612",
    .name = "repeat-count-odd",
    .summary = "a `repeat` count that is negative, zero or not a whole number",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A `repeat` whose count is negative or not a whole number on some path, or is written as 0: for
example a depth divided by a step, `repeat [10/4]`.)",
            .why = R"(LinuxCNC rounds the count to the nearest whole number, and a half to the even one: 2.5 makes **2**
passes, 3.5 makes 4, 0.5 makes none. The rest of the depth is not cut. With 0 or less there is no
pass. There is no message.)",
            .bad = R"(G21 G90
#<depth> = 10
#<step> = 4
#<done> = 0
o100 repeat [#<depth> / #<step>]
  #<done> = [#<done> + #<step>]
o100 endrepeat
G0 X#<done>
M2
)",
            .good = R"(G21 G90
#<depth> = 10
#<step> = 4
#<done> = 0
o100 repeat [FUP[#<depth> / #<step>]]
  #<done> = [#<done> + #<step>]
o100 endrepeat
G0 X#<done>
M2
)",
            .fix = R"(Round on purpose, with `FUP` or `FIX`, and cut the rest in a last pass.)",
            .level_reason = "Warning: the program runs, with a different number of passes.",
            .interpreter = "",
            .options = "",
            .moves = "X8",
            .moves_good = "X12",
        },
    .check = check,
};

}  // namespace owlint::rules::ow612
