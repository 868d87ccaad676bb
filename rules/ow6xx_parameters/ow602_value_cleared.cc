// OW602 value-cleared: `#<_value>` is read after another call has set it to 0.
// Depends on: every `endsub`, `return` and M99 without a value sets `#<_value>` to 0, whatever call came before (measured).
#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow602 {
namespace {

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  if (!in.data.structure().regular) return;  // the sub that returns none may lack its own end
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kValueCleared) continue;
    const Elsewhere from = place_of(in, h.other, h.other_elsewhere);
    const std::string sub = returning_sub(from, "another sub");
    Finding& f = out.add(p.at(h.statement).whole(),
                         "`#<_value>` is 0 here: after the call that returned a value, the program called " + sub +
                             ", which returns none");
    if (from.program != nullptr) relate(in, f, from, "`#<_value>` becomes 0 here");
    f.help = "copy the value right after the call that returns it: `#<result> = #<_value>`";
    f.reach = h.reach;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW602",
    .name = "value-cleared",
    .summary = "`#<_value>` is read after another call has set it to 0",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A sub returns a value, but the program reads it only after a call of another sub, which returns
none.)",
            .why = R"(There is one `#<_value>` for all subs. A sub that returns without a value, or with M99, sets it to
**0**; so does a definition that is skipped. There is no message.)",
            .bad = R"(G21 G90
o100 sub
o100 endsub [#1 * 2]
o200 sub
  M8
o200 endsub
G0 X50 Z5
o100 call [10]
o200 call
G0 X#<_value>
M2
)",
            .good = R"(G21 G90
o100 sub
o100 endsub [#1 * 2]
o200 sub
  M8
o200 endsub
G0 X50 Z5
o100 call [10]
#<width> = #<_value>
o200 call
G0 X#<width>
M2
)",
            .fix = R"(Copy the value into a parameter of your own on the line after the call.)",
            .level_reason = "Warning: the program runs with the value of the other call, or 0.",
            .interpreter = "",
            .options = "",
            .moves = "X0",
            .moves_good = "X20",
        },
    .check = check,
};

}  // namespace owlint::rules::ow602
