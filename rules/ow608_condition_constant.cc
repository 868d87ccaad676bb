// OW608 condition-constant: a condition that comes out the same every time, and the branch that is never taken.
// Rests on: a condition that is 0 is false, any other is true.
#include "rules/parameters.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (const flow::FixedCondition& c : in.data.fixed()) {
    const Statement& s = p.at(c.statement);
    const std::string head = "`" + p.head(c.statement) + "`";
    if (c.same_as != kNoStatement) {
      Finding& f = out.add(s.head_span(), head + " is never true: a branch before it has the same condition");
      relate(f, p, c.same_as, "this branch is taken instead");
      f.help = "change one of the two conditions";
      f.reach = in.flow.reach(c.statement);
      continue;
    }
    const std::string says = s.is(Keyword::kWhile) && !c.truth ? "is false every time: the loop makes no further pass" : c.truth ? "is true every time" : "is false every time: its lines are never executed";
    Finding& f = out.add(s.head_span(), "the condition of " + head + " " + says);
    f.help = "check the comparison: its direction, its number, the parameter";
    f.reach = in.flow.reach(c.statement);
  }
}

}  // namespace

extern const Rule kOw608{
    .code = "OW608",
    .name = "condition-constant",
    .summary = "a condition that has the same value on every path; a branch that cannot be taken",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page = {
        .what = R"(A comparison that an earlier one has decided already, or that what was assigned before decides: an
inner `if` that contradicts the outer one, an `elseif` with the condition of a branch above it, a
`while` whose counter starts on the wrong side.

Nothing is said of `[1]` and `[0]`, which are written on purpose, nor of a number that is set once in
the program and is there to be changed by hand.)",
        .why = R"(LinuxCNC evaluates the condition and goes the same way every time, without a word. The lines of the
other branch are never executed: in the first program below the machine stays at X0.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
#1 = 0
G0 X0 Z5
o100 while [#1 GT 5]
  #1 = [#1 + 1]
  G0 X[#1 * 10]
o100 endwhile
M2
)",
        .good = R"(G21 G90
#1 = 0
G0 X0 Z5
o100 while [#1 LT 5]
  #1 = [#1 + 1]
  G0 X[#1 * 10]
o100 endwhile
M2
)",
        .fix = R"(Turn the comparison round, or compare with another number or parameter.)",
        .interpreter = "",
        .options = "",
        .moves = "X0",
        .moves_good = "X50",
    },
    .check = check,
};

}  // namespace owlint::rules
