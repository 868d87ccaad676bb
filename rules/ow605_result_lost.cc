// OW605 result-lost: a sub leaves something in #1 to #30 for its caller.
// Rests on: a call saves #1 to #30 and gives them back on return, all of them (measured).
#include "rules/parameters.h"

namespace owlint::rules {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  std::vector<bool> seen(p.regions.size());
  for (const Call& call : p.calls) {
    // In a sub, what it reads may be its own argument.
    if (call.target == UINT32_MAX || call.caller != kMainRegion || p.at(call.statement).kind == LineKind::kM98) continue;
    if (seen[call.target]) continue;  // the first call has the most behind it
    seen[call.target] = true;
    const uint32_t left = in.data.left_behind(call.target);
    for (uint32_t n = 1; left != 0 && n < flow::kFirstGlobalNumber; ++n) {
      if ((left >> n & 1) == 0 || !in.data.expects_from_call(call.statement, n)) continue;
      const StatementId assigned = in.data.last_assignment(call.target, n);
      const std::string number = "`#" + std::to_string(n) + "`";
      Finding& f = out.add(p.at(assigned).whole(), number + " is assigned here for the caller, but " + region_words(p, call.target) + " has its own " + number + ": the caller's is as before the call");
      relate(f, p, call.statement, "called from here, where " + number + " is read afterwards");
      f.help = "return it, as `endsub [" + number.substr(1, number.size() - 2) + "]`, and read `#<_value>`; or use a number above #30 or a name with `_`";
      f.reach = in.flow.reach(call.statement);
    }
  }
}

}  // namespace

extern const Rule kOw605{
    .code = "OW605",
    .name = "result-lost",
    .summary = "a sub assigns #1 to #30 for its caller: the values are restored on return",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page = {
        .what = R"(A sub that puts its result into one of `#1` to `#30` without using it, and a main program that reads
this number behind the call and never sets it itself.)",
        .why = R"(A call saves `#1` to `#30` and gives them back when the sub returns. What the sub has put there is gone:
the caller reads what it had before, usually 0. LinuxCNC says nothing.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
        .bad = R"(G21 G90
o100 sub
  #5 = [#1 + #2]
o100 endsub
G0 X50 Z5
o100 call [10] [20]
G0 X#5
M2
)",
        .good = R"(G21 G90
o100 sub
  #5 = [#1 + #2]
o100 endsub [#5]
G0 X50 Z5
o100 call [10] [20]
G0 X#<_value>
M2
)",
        .fix = R"(Return one value with `endsub [...]`. For several, use numbers above `#30` or names that begin with `_`.)",
        .interpreter = "",
        .options = "",
        .moves = "X0",
        .moves_good = "X30",
    },
    .check = check,
};

}  // namespace owlint::rules
