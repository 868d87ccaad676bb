// From the interpreter's errors to rules: which rule reports which stop, and the parts of a finding that all rules about
// stops have in common.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "analyzer/program/meant.h"
#include "rules/driver/lint.h"
#include "rules/driver/rule.h"

namespace owlint::rules {

/// The code of the rule that a stop belongs to. Tests map the interpreter's messages with the same table.
std::string_view code_of(const FlowStop& stop, const Program& program);
std::string_view code_of(StopKind kind, const Statement& statement);

/// Group of a finding about a line behind the one at which every run stops: what it begins with.
inline constexpr std::string_view kBehind = "behind: ";

/// Fills reach, stops, interpreter and the path of a finding about `stop`.
void describe_stop(const Input& in, const FlowStop& stop, Finding& finding);

/// Adds the other stops that the mistake at `statement` causes.
void add_consequences(const Input& in, StatementId statement, Finding& finding);

/// The stops that belong to the rule and are not the consequence of another mistake.
std::span<const FlowStop* const> stops_of(const Input& in, const Reporter& out);
/// The errors of the rule that FEATURE 0x20 turned into messages.
std::span<const Hazard* const> warned_of(const Input& in, const Reporter& out);
/// Reading errors for this rule that no run reaches.
std::span<const StatementId> unmet_of(const Input& in, const Reporter& out);
/// A message of warned_of() as the stop that it would be without FEATURE 0x20; nothing if it still stops, with another
/// message: then that is the finding.
std::optional<FlowStop> as_stop(const Input& in, const Reporter& out, const Hazard& warned);

/// Calls `each` for every stop of the rule; `each` adds the finding and returns it, or null. (Templates, as most rules have
/// nothing to report in most programs: a std::function for each would cost more than all of them.)
template <typename Each>
void for_stops(const Input& in, Reporter& out, const Each& each) {
  for (const FlowStop* stop : stops_of(in, out)) {
    if (Finding* finding = each(*stop)) describe_stop(in, *stop, *finding);
  }
}

/// The same for the errors that FEATURE 0x20 turned into messages.
template <typename Each>
void for_warned(const Input& in, Reporter& out, const Each& each) {
  for (const Hazard* hazard : warned_of(in, out)) {
    const std::optional<FlowStop> stop = as_stop(in, out, *hazard);
    Finding* finding = stop ? each(*stop) : nullptr;
    if (finding == nullptr) continue;
    finding->reach = hazard->reach;
    finding->interpreter = hazard->interpreter;
  }
}

/// Whether some stop (or message under 0x20) of any rule is at this statement.
bool has_stop(const Input& in, StatementId statement);

/// Calls `each` for the reading errors of this rule that no run reaches.
template <typename Each>
void for_unmet_errors(const Input& in, Reporter& out, const Each& each) {
  for (const StatementId id : unmet_of(in, out)) each(id, *in.program.syntax.error(in.program.at(id)));
}

/// Adds "first defined here" and the like.
void relate(Finding& finding, const Program& program, StatementId statement, std::string message);
/// The same for a line that may be in another file; does nothing if there is none.
void relate(const Input& in, Finding& finding, const Elsewhere& place, std::string message);

/// The line that a stop or hazard names, in this file or another one.
Elsewhere place_of(const Input& in, StatementId here, const Elsewhere& elsewhere);
/// `line 12`, or `line 12 of probe.ngc`.
std::string line_words(const Input& in, const Elsewhere& place);
/// The line end that the statement's line has, for lines that a fix adds.
std::string line_end(const Source& source, const Statement& statement);
/// The spaces at the beginning of the statement's line.
std::string indent_of(const Source& source, const Statement& statement);
/// Puts what stands from `at` on on a line of its own, below. Safe only where both lines are surely ones that LinuxCNC runs,
/// and all runs stop at the line as it is.
Fix split_line(const Program& program, const Statement& statement, uint64_t at, std::string title);
/// The first line of the outermost block or sub around `statement`; the statement itself if there is none. A line before it
/// is outside of all of them.
StatementId outermost(const Program& program, StatementId statement);
/// Moves the lines from `first` to `last` up, before the line of `before`. Never safe: the moved lines may run in another
/// order.
Fix move_up(const Program& program, StatementId first, StatementId last, StatementId before, std::string title);
/// Whether a line begins or ends a sub: a line that becomes one changes what is inside a definition.
bool bounds_sub(const Statement& statement);
/// Whether an O-word without a keyword has the label of a sub, in the program or in a file, and is not the program's own
/// number: then its `call` was forgotten.
bool lacks_call(const Input& in, StatementId statement);
/// The arguments of a call that has them in round brackets, `(1) (2)` or `(1, 2)`, where they are a comment, as they must be
/// written: `[1] [2]`. Empty if there are no such comments, or one of them is no value.
std::string arguments_in_comment(const Program& program, StatementId call);
/// The last part of a file's path.
std::string file_name(const Source& source);

/// What is wrong with the character that a text begins with, which only looks like another: `U+2212 MINUS SIGN looks
/// like "-"`.
std::string look_alike_text(std::string_view text);
/// Of a name that nothing defines: another one of the program that looks like it, and how they differ. Empty if there is none.
std::string look_alike_name(const Input& in, std::string_view name);

/// `1st`, `2nd`... for arguments and passes.
std::string ordinal(size_t n);

/// The nearest of `candidates` to `word` (edit distance at most a third of its length, or `limit`); empty if none is.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates, size_t limit = SIZE_MAX);

/// Why LinuxCNC does not read a line as what it is meant to be: `the name on line 5 has no ">"`.
std::string misread_words(const Program& program, StatementId line);
/// Names that line in a finding about another one, with how to write it, and a fix. `right`: its label and keyword.
void name_misread(const Program& program, StatementId line, const std::string& right, Finding& finding);

/// A number that no O-word of the program uses, near `label`, as `o110`; each time another one, so that fixes can be made
/// together.
std::string free_label(const Input& in, NameId label);
/// Advice that shows an O-word with `o100`, with a number in its place that the program does not use.
std::string with_free_label(const Input& in, std::string advice);

}  // namespace owlint::rules
