// OW302 condition-missing: `if`, `elseif`, `while` or `repeat` without a value in brackets.
// Depends on: when one of these is evaluated the next character must be `[`; on a line that is
// skipped it is not looked at. Round brackets are a comment, so a call runs without the arguments in them.
#include <set>

#include "analyzer/syntax/known_line.h"
#include "rules/driver/idioms.h"
#include "rules/driver/wrong_ends.h"

namespace owlint::rules::ow302 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  const std::string word(spelling(s.keyword));
  const std::string what = s.is(Keyword::kRepeat) ? "count" : "condition";
  Finding& f = out.add(s.head_span(), "`" + p.head(id) + "` is not followed by `[`");
  std::string rest(p.source->slice({s.offset + s.keyword_to, s.end()}));
  rest = rest.substr(0, rest.find_first_of("(;"));
  while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t')) rest.erase(0, 1);
  while (!rest.empty() && (rest.back() == ' ' || rest.back() == '\t' || rest.back() == '\r')) rest.pop_back();
  if (rest.empty() || rest.find_first_of("[]=") != std::string::npos) {
    f.help = "put the " + what + " in brackets, after `" + word + "`";
  } else {
    f.help = "write `" + word + " [" + rest + "]`";
    const uint64_t from = p.source->bytes().find(rest, s.offset + s.keyword_to);
    f.fixes.push_back({"put the " + what + " in brackets",
                       false,
                       {{{from, from}, "["}, {{from + rest.size(), from + rest.size()}, "]"}}});
  }
  if (!tell_wrong_end(p, id, f)) explain_idiom(in, id, f);
  return &f;
}

/// Calls whose arguments are in round brackets: the sub gets none of them, and there is no message.
void report_arguments(const Input& in, Reporter& out) {
  std::set<StatementId> calls;
  for (const Hazard& h : in.flow.hazards) {
    if (h.kind == HazardKind::kArgumentNotPassed) calls.insert(h.statement);
  }
  for (const StatementId id : calls) {
    const std::string written = arguments_in_comment(in.program, id);
    if (written.empty()) continue;
    const Statement& s = in.program.at(id);
    const Span comments{s.offset + s.keyword_to, s.end()};
    Finding& f = out.add(s.head_span(),
                         "`" + in.program.head(id) +
                             "` is followed by round brackets, and they are a comment: the sub gets no arguments");
    f.help = "write `" + in.program.head(id) + " " + written + "`";
    f.fixes.push_back({"write square brackets", false, {{comments, " " + written}}});
    f.reach = in.flow.reach(id);
  }
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError&) { report(in, out, id)->reach = in.flow.reach(id); });
  report_arguments(in, out);
}

}  // namespace

extern const Rule kRule{
    .code = "OW302",
    .name = "condition-missing",
    .summary = "`if`, `elseif`, `while` or `repeat` without `[`, or arguments in round brackets",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A condition or a count that is missing or not in square brackets: `o100 if #1 GT 5`, `o100 repeat
3`, `o100 while (#1 LT 3)`. Also the arguments of a call in round brackets: `o100 call (1) (2)`.)",
            .why = R"(LinuxCNC stops when it runs the line. Round brackets are a comment in LinuxCNC, so a condition in
them is lost; a comment between the keyword and the bracket has the same effect. In a skipped branch
there is no message, so the mistake may wait for the first run that gets there. A call with its
arguments in round brackets passes none of them, and there is **no message**.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if #5070 EQ 1
  G10 L20 P1 Z0
o100 endif
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  G10 L20 P1 Z0
o100 endif
G0 Z5
M2
)",
            .fix = R"(Write the whole condition, or the count, in one pair of square brackets.)",
            .level_reason = "Error if a run gets here: the program stops. Warning if no run does, or for a call "
                            "without its arguments.",
            .interpreter = "Left bracket missing after 'if'",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow302
