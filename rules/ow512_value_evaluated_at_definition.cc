// OW512 value-evaluated-at-definition: the value of a `return` or `endsub` that can fail when the definition is
// passed over.
// Rests on: those values are evaluated whenever the line is not skipped to another label, and a
// definition is skipped to its own label; the parameters are those of the main program at that
// moment.
#include <algorithm>

#include "rules/stops.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& s) -> Finding* {
    const Statement& line = p.at(s.statement);
    const bool at_definition = std::ranges::any_of(in.flow.hazards, [&](const Hazard& h) {
      return h.kind == HazardKind::kValueAtDefinition && h.statement == s.statement;
    });
    Finding& f = out.add({line.offset + line.keyword_to, line.end()}, at_definition
        ? "LinuxCNC computes the value of `" + p.head(s.statement) + "` already when it passes the definition, before any call, and that can fail"
        : "the value of `" + p.head(s.statement) + "` cannot be computed");
    f.help = "compute the value into a parameter first, and return that";
    return &f;
  });
}

}  // namespace

extern const Rule kOw512{
    .code = "OW512",
    .name = "value-evaluated-at-definition",
    .summary = "a `return` or `endsub` value that can fail is evaluated when the definition is passed over",
    .group = Group::kHazards,
    .level = Severity::kError,
    .page = {
        .what = R"(A value on `return` or `endsub` that divides, takes a root, a logarithm, an arc sine or arc cosine,
or reads `#[…]`, with an argument of the sub in it. It matters for subs that are defined in the
program above their calls.)",
        .why = R"(LinuxCNC evaluates these values not only when the sub runs but **also while it reads over the
definition**. There is no argument then: `#1` is the main program's `#1`, usually 0, and an `if`
around the line does not protect it. The program stops before its first move with
`Attempt to divide by zero`, `Negative argument to sqrt`, `Zero or negative argument to ln`,
`Argument to asin out of range`, `Argument to acos out of range` or `Parameter number out of range`,
at a line that would be right in every call.

An undefined name does no harm there. In a called file, and in a sub below `M2` that is reached by
its first call, the value is evaluated only in the call. FEATURE 0x20 (`OWORD_WARNONLY`) changes
nothing here.)",
        .bad = R"(G21 G90
o<pitch> sub
  o110 if [#1 EQ 0]
    o<pitch> return [0]
  o110 endif
o<pitch> endsub [25.4 / #1]
G0 X10 Y10 Z5
o<pitch> call [20]
G1 Z[0 - #<_value>] F80
G0 Z5
M2
)",
        .good = R"(G21 G90
o<pitch> sub
  #<p> = 0
  o110 if [#1 NE 0]
    #<p> = [25.4 / #1]
  o110 endif
o<pitch> endsub [#<p>]
G0 X10 Y10 Z5
o<pitch> call [20]
G1 Z[0 - #<_value>] F80
G0 Z5
M2
)",
        .fix = R"(Compute the value on a line of its own into a local name and return the name: ordinary lines are
skipped in a definition, and a name that is not set yet does no harm there.)",
        .interpreter = "Attempt to divide by zero",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
