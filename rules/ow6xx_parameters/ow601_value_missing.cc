// OW601 value-missing: `#<_value>` is read after a sub has returned without a value.
// Depends on: `endsub` and `return` set `#<_value>` to their value, or to 0 without one, and `#<_value_returned>` to 1 or 0;
// M99 returns without a value (measured).
#include <algorithm>

#include "rules/driver/parameter_helpers.h"

namespace owlint::rules::ow601 {
namespace {

/// Whether the program reads `#<_value_returned>` after the line and before the next call: then its author knows.
bool asks_afterwards(const Program& p, StatementId id) {
  constexpr StatementId kFar = 32;  // lines
  const NameId returned = p.syntax.names.find("_value_returned");
  if (returned == kNoName) return false;
  for (StatementId next = id; next < std::min<size_t>(id + kFar, p.size()); ++next) {
    if (p.at(next).is(Keyword::kCall) || p.region_of[next] != p.region_of[id]) return false;
    const flow::AccessTable line(p, std::span(&next, 1));
    if (std::ranges::count(line.lines(0, 1).all_reads(), flow::key_of_name(p.syntax, returned)) > 0) return true;
  }
  return false;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  if (!in.data.structure().regular) return;  // the sub that returns without a value may lack its own end
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kValueNotReturned || asks_afterwards(p, h.statement)) continue;
    const Elsewhere from = place_of(in, h.other, h.other_elsewhere);
    const std::string sub = returning_sub(from, "the sub that was called");
    Finding& f = out.add(p.at(h.statement).whole(),
                         "`#<_value>` is read here, but " + sub + " can return without a value: then it is 0");
    if (from.program != nullptr) relate(in, f, from, "this line returns without a value");
    f.help =
        "give every `return` and `endsub` of the sub a value, as `endsub [#1]`, or test `#<_value_returned>`, which is "
        "0 then";
    f.reach = h.reach;
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW601",
    .name = "value-missing",
    .summary = "`#<_value>` is read after a call whose sub may return no value",
    .group = Group::kDataFlow,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(`#<_value>` is read after a call, but the sub can return without a value: its `endsub` has none, or
a `return` inside an `if` has none.)",
            .why =
                R"(If a sub returns without a value, LinuxCNC sets `#<_value>` to **0**, without a message. A height, a
width or an angle of 0 then goes into the next move. `#<_value_returned>` says whether there was a
value: 1 or 0.)",
            .bad = R"(G21 G90
o100 sub
  o110 if [#1 GT 10]
    o100 return [#1 / 2]
  o110 endif
o100 endsub
G0 X50 Z5
o100 call [8]
G0 X#<_value>
M2
)",
            .good = R"(G21 G90
o100 sub
  o110 if [#1 GT 10]
    o100 return [#1 / 2]
  o110 endif
o100 endsub [#1]
G0 X50 Z5
o100 call [8]
G0 X#<_value>
M2
)",
            .fix =
                R"(Give `endsub` and every `return` a value, or test `#<_value_returned>` before you use the value.)",
            .level_reason = "Warning: the program runs with 0 instead of the value.",
            .interpreter = "",
            .options = "",
            .moves = "X0",
            .moves_good = "X8",
        },
    .check = check,
};

}  // namespace owlint::rules::ow601
