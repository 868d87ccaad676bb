// OW507 argument-not-passed: a call that does not pass an argument which the sub reads.
// Rests on: a call sets #1 to #30, and those without a value are 0, although the documentation
// says they keep the caller's value.
#include <map>
#include <vector>

#include "rules/stops.h"

namespace owlint::rules {
namespace {

/// `#4`, or `#4`, `#5` and `#6`.
std::string listed(const std::vector<const Hazard*>& reads) {
  std::string out;
  for (size_t i = 0; i < reads.size(); ++i) out += (i == 0 ? "`#" : i + 1 == reads.size() ? " and `#" : ", `#") + std::to_string(reads[i]->number) + "`";
  return out;
}

/// One finding for a call, however many arguments it lacks. `reads` has the first read of each, by number.
void report(const Input& in, Reporter& out, const std::vector<const Hazard*>& reads) {
  const Hazard& first = *reads.front();
  const Statement& call = in.program.at(first.statement);
  const bool one = reads.size() == 1;
  const std::string passes = "`" + in.program.head(first.statement) + "` passes " + std::to_string(call.value_count) + (call.value_count == 1 ? " argument" : " arguments");
  const std::string where = line_words(in, place_of(in, first.other, first.other_elsewhere));
  Finding& f = out.add(call.head_span(), passes + ", but the sub reads " + listed(reads) + (one ? " on " : ", first on ") + where + (one ? ": it is 0 there" : ": they are 0 there"));
  for (const Hazard* read : reads) relate(in, f, place_of(in, read->other, read->other_elsewhere), "`#" + std::to_string(read->number) + "` is read here");
  f.help = one ? "pass a " + ordinal(first.number) + " argument, or set `#" + std::to_string(first.number) + "` in the sub before it is read"
               : "pass " + std::to_string(reads.back()->number) + " arguments, or set these in the sub before they are read";
  f.reach = first.reach;
}

void check(const Input& in, Reporter& out) {
  std::map<std::pair<StatementId, uint32_t>, const Hazard*> reads;  // by call and number
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind == HazardKind::kArgumentNotPassed) reads.try_emplace({h.statement, h.number}, &h);
  }
  std::vector<const Hazard*> of_call;
  for (auto at = reads.begin(); at != reads.end(); ++at) {
    of_call.push_back(at->second);
    if (const auto next = std::next(at); next != reads.end() && next->first.first == at->first.first) continue;
    report(in, out, of_call);
    of_call.clear();
  }
}

}  // namespace

extern const Rule kOw507{
    .code = "OW507",
    .name = "argument-not-passed",
    .summary = "the sub reads `#n`, but this call does not pass it: it is 0",
    .group = Group::kHazards,
    .level = Severity::kWarning,
    .page = {
        .what = R"(A `call` with fewer values than the sub uses: the sub reads `#3`, the call passes two.

What the sub tests is left out on purpose and not told of: `if [#3 EQ 0]`, or `#<depth> = #3` and then
`if [#<depth> EQ 0]`.)",
        .why = R"(LinuxCNC sets what was not passed to **0**. The documentation says that the caller's values stay,
but the interpreter does not do that, so a `#3` set before the call does not arrive either. A depth,
a feed or a safe height of 0 is a plunge to the zero face or a rapid through the part, with no
message.)",
        .bad = R"(G21 G90
o100 sub
  G0 X#1 Y#2
  G1 Z-5 F80
  G0 Z#3
o100 endsub
G0 Z5
o100 call [10] [10] [5]
o100 call [30] [10]
M2
)",
        .good = R"(G21 G90
o100 sub
  G0 X#1 Y#2
  G1 Z-5 F80
  G0 Z#3
o100 endsub
G0 Z5
o100 call [10] [10] [5]
o100 call [30] [10] [5]
M2
)",
        .fix = R"(Pass a value for every argument. If 0 is meant as "use the default", pass `[0]` so that it can be
seen, or test it in the sub.)",
        .interpreter = "",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
