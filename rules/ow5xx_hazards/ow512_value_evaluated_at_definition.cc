// OW512 value-evaluated-at-definition: the value of a `return` or `endsub` that can fail when the definition is
// skipped.
// Depends on: these values are computed unless the interpreter skips to another label, and it skips a
// definition to the sub's own label; the parameters are those of the main program at that moment.
#include <algorithm>

#include "rules/driver/stops.h"

namespace owlint::rules::ow512 {
namespace {

/// Whether the value divides by what only names without a value can make 0. They are no certain number there: in the runs that
/// were measured the division went well.
bool depends_on_names(const FlowStop& stop, std::string_view value) {
  if (!stop.interpreter.starts_with("Attempt to divide")) return false;
  bool names = false;
  for (size_t at = value.find('#'); at != std::string_view::npos; at = value.find('#', at + 1)) {
    const std::string_view behind = value.substr(at + 1);
    if (!behind.starts_with('<') || behind.starts_with("<_")) return false;
    names = true;
  }
  return names;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& s) -> Finding* {
    const Statement& line = p.at(s.statement);
    const bool at_definition = std::ranges::any_of(in.flow.hazards, [&](const Hazard& h) {
      return h.kind == HazardKind::kValueAtDefinition && h.statement == s.statement;
    });
    const Span value{line.offset + line.keyword_to, line.end()};
    const bool perhaps = at_definition && s.reach != Reach::kAlways && depends_on_names(s, p.source->slice(value));
    Finding& f = out.add(value,
                         at_definition ? "LinuxCNC also computes the value of `" + p.head(s.statement) +
                                 "` when it skips the definition, before any call, and there it " +
                                 (perhaps ? "can fail" : "fails")
                                       : "the value of `" + p.head(s.statement) + "` cannot be computed");
    f.unproven = perhaps;
    f.help = "compute the value into a parameter on a line before, and return the parameter";
    return &f;
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW512",
    .name = "value-evaluated-at-definition",
    .summary = "the value of a `return` or `endsub` is computed when the definition is skipped, and fails there",
    .group = Group::kHazards,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A value on `return` or `endsub` that uses an argument of the sub in a division, a root, a logarithm,
an arc sine or arc cosine, or in `#[…]`. It matters for subs that are defined above their calls.)",
            .why = R"(LinuxCNC computes these values not only when the sub runs, but **also when it skips the
definition**. At that time there are no arguments: `#1` is the main program's `#1`, usually 0, and
an `if` around the line does not help. The program stops before its first move with `Attempt to
divide by zero`, `Negative argument to sqrt`, `Zero or negative argument to ln`, `Argument to asin
out of range`, `Argument to acos out of range` or `Parameter number out of range`, at a line that is
right in every call.

An undefined name does no harm there. In a called file, and in a sub below `M2`, the value is
computed only in the call.)",
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
            .fix = R"(Compute the value on a line of its own into a local name, and return that name. Ordinary lines are
skipped with the definition, and a name that is not set yet does no harm there.)",
            .level_reason =
                "Error if the value cannot be computed on some run: the program stops. Warning if no run does.",
            .interpreter = "Attempt to divide by zero",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow512
