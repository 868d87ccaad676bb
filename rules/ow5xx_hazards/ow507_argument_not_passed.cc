// OW507 argument-not-passed: a call that does not pass an argument which the sub reads.
// Depends on: a call sets #1 to #30, and those without a value are 0, although the documentation
// says they keep the caller's value.
#include <algorithm>
#include <map>

#include "rules/driver/idioms.h"
#include "rules/driver/parameter_helpers.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow507 {
namespace {

using Reads = std::map<uint32_t, const Hazard*>;  // the first read of each argument, by its number

/// One finding for a call, however many arguments it lacks.
void report(const Input& in, Reporter& out, StatementId id, const Reads& reads) {
  const auto& [number, first] = *reads.begin();
  const Statement& call = in.program.at(id);
  const bool one = reads.size() == 1;
  uint32_t bits = 0;
  for (const auto& [n, read] : reads) bits |= 1U << n;
  const std::string passes = "`" + in.program.head(id) + "` passes " + std::to_string(call.value_count) +
      (call.value_count == 1 ? " argument" : " arguments");
  const std::string where = line_words(in, place_of(in, first->other, first->other_elsewhere));
  Finding& f = out.add(call.head_span(),
                       passes + ", but the sub reads " + argument_words(bits) + (one ? " on " : ", first on ") + where +
                           (one ? ": it is 0 there" : ": they are 0 there"));
  for (const auto& [n, read] : reads) {
    const Elsewhere place = place_of(in, read->other, read->other_elsewhere);
    const std::string name = "#" + std::to_string(n);
    relate(in, f, place, "`" + name + "` is read here");
    if (place.program != nullptr && place.statement != kNoStatement)
      f.related.back().span = read_span(*place.program, place.statement, name);
  }
  f.help = one
      ? "pass a " + ordinal(number) + " argument, or set `#" + std::to_string(number) + "` in the sub before it is read"
      : "pass " + std::to_string(reads.rbegin()->first) + " arguments, or set these in the sub before they are read";
  // `[-1 -2]` is one value, -3.
  const std::string written(in.program.source->slice({call.keyword_span().end, call.end()}));
  const std::string values = arguments_in_brackets(written.substr(0, written.find_first_of("(;\r")));
  if (std::ranges::count(values, '[') - std::ranges::count(written, '[') > 0)
    f.help = "each pair of brackets is one value: for several, write `" + values + "`";
  // Calls all over a shop that lack the same arguments of a sub in a file of its own are one question to its author.
  if (place_of(in, first->other, first->other_elsewhere).program != &in.program) {
    f.group = in.program.label_at(id) + " " + argument_words(bits);
    f.habit_severity = Severity::kInfo;
  }
  f.reach = first->reach;
}

/// Whether a blank does not divide two of the call's values, as OW317 says.
bool runs_together(const Program& p, const Statement& call) {
  const auto& split = p.syntax.split_numbers;
  const auto first = std::ranges::lower_bound(split, call.offset, {}, &Span::begin);
  return first != split.end() && first->begin < call.end();
}

void check(const Input& in, Reporter& out) {
  std::map<StatementId, Reads> calls;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind != HazardKind::kArgumentNotPassed || runs_together(in.program, in.program.at(h.statement))) continue;
    if (!arguments_in_comment(in.program, h.statement).empty()) continue;  // OW302
    calls[h.statement].try_emplace(h.number, &h);
  }
  for (const auto& [call, reads] : calls) report(in, out, call, reads);
}

}  // namespace

extern const Rule kRule{
    .code = "OW507",
    .name = "argument-not-passed",
    .summary = "the sub reads `#n`, but this call does not pass it: it is 0",
    .group = Group::kHazards,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A `call` with fewer values than the sub uses: the sub reads `#3`, but the call passes two values.

Arguments that the sub treats as optional are not reported: those that it tests (`if [#3 EQ 0]`,
`EXISTS[#3]`, or `#<depth> = #3` and then `if [#<depth> EQ 0]`), all arguments of a sub that reads
`#<n_args>`, and those that most calls leave out. If three or more calls in several files leave out the
same arguments, they seem to do so on purpose: that is an info.)",
            .why = R"(LinuxCNC sets arguments that are not passed to **0**. The documentation says that they keep the
caller's values, but the interpreter does not do that, so setting `#3` before the call does not
help. A depth, a feed or a safe height of 0 can mean a plunge or a rapid move through the part,
without a message.)",
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
            .fix = R"(Pass a value for every argument. If 0 means "use the default", pass `[0]` so that a reader can see
it, or test it in the sub.)",
            .level_reason =
                "Warning: the program runs with 0. Arguments that the sub treats as optional are not reported.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow507
