// From the interpreter's errors to rules: which rule speaks of which stop, and the parts of a finding that all
// rules about stops have in common.
#pragma once

#include <functional>
#include <string>

#include "rules/rule.h"

namespace owlint::rules {

/// The code of the rule that a stop belongs to. Tests map the interpreter's messages with the same table.
std::string_view code_of(const FlowStop& stop, const Program& program);
std::string_view code_of(StopKind kind, const Statement& statement);

/// Fills reach, stops, interpreter and the path of a finding about `stop`.
void describe_stop(const Input& in, const FlowStop& stop, Finding& finding);

/// Names the other stops that the mistake at `statement` leads to.
void add_consequences(const Input& in, StatementId statement, Finding& finding);

/// Calls `each` for every stop that belongs to the rule and is not the consequence of another mistake; `each` adds
/// the finding and returns it.
void for_stops(const Input& in, Reporter& out, const std::function<Finding*(const FlowStop&)>& each);

/// The same for the errors that FEATURE 0x20 turned into messages.
void for_warned(const Input& in, Reporter& out, const std::function<Finding*(const FlowStop&)>& each);

/// Whether some stop (or message under 0x20) of any rule is at this statement.
bool has_stop(const Input& in, StatementId statement);

/// Errors of reading that the rule is about but no run meets: calls `each` for those without a stop.
void for_unmet_errors(const Input& in, Reporter& out, const std::function<void(StatementId, const LineError&)>& each);

/// Adds "first defined here" and the like.
void relate(Finding& finding, const Program& program, StatementId statement, std::string message);
/// The same for a line that may be in another file; nothing where there is none.
void relate(const Input& in, Finding& finding, const Elsewhere& place, std::string message);

/// The line that a stop or hazard speaks of, in this file or another one.
Elsewhere place_of(const Input& in, StatementId here, const Elsewhere& elsewhere);
/// `line 12`, or `line 12 of probe.ngc`.
std::string line_words(const Input& in, const Elsewhere& place);
/// The line end that the statement's line has, for lines that a fix adds.
std::string line_end(const Source& source, const Statement& statement);
/// The blanks that the statement's line begins with.
std::string indent_of(const Source& source, const Statement& statement);
/// The first line of the outermost block, or of the sub, that `statement` stands in; the statement itself if it is in none.
/// What is put before it is out of all of them.
StatementId outermost(const Program& program, StatementId statement);
/// Moves the lines from `first` to `last` to before the line of `before`, which stands above them. Nobody knows what they
/// do on the way: never safe.
Fix move_up(const Program& program, StatementId first, StatementId last, StatementId before, std::string title);
/// Whether a line begins or ends a sub: made one, it changes what a definition holds that was passed over before.
bool bounds_sub(const Statement& statement);
/// The last part of a file's path.
std::string file_name(const Source& source);

/// `1st`, `2nd`... for arguments and passes.
std::string ordinal(size_t n);

/// The nearest of `candidates` to `word` (edit distance at most a third of its length, or `limit`); empty if none is.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates, size_t limit = SIZE_MAX);

/// A number that no O-word of the program uses, near `label`, as `o110`; each time another one, so that fixes can be made
/// together.
std::string free_label(const Input& in, NameId label);

}  // namespace owlint::rules
