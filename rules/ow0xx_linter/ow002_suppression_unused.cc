// OW002 suppression-unused: a suppression comment that suppresses no finding.
// Depends on no fact about the interpreter: to LinuxCNC every suppression is an ordinary comment.
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "rules/driver/behind_stops.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow002 {
namespace {

/// The code; with the blanks before it and the whole comment, or its line, where nothing else is left.
Span removed(const Input& in, const Suppression& unused) {
  const Source& source = *in.program.source;
  // They are in the order of the file.
  const auto comment = [](const Suppression& s) { return s.comment.begin; };
  const auto first = std::ranges::lower_bound(in.suppressions, unused.comment.begin, {}, comment);
  const bool alone = std::next(first) == in.suppressions.end() || comment(*std::next(first)) != unused.comment.begin;
  if (!alone) {
    Span span = unused.span;
    while (span.begin > unused.comment.begin &&
           std::string_view(" ,\t").find(source.bytes()[span.begin - 1]) != std::string_view::npos)
      --span.begin;
    return span;
  }
  const Span line = source.line(source.position(unused.comment.begin).line);
  const std::string_view text = source.slice(line);
  const uint64_t opened = line.begin + text.find_last_of("(;", unused.comment.begin - line.begin);
  const bool bracket = source.bytes()[opened] == '(';
  uint64_t closed = bracket ? line.begin + text.find(')', unused.comment.begin - line.begin) + 1 : line.end;
  const std::string_view around = source.slice({line.begin, opened});
  const bool whole = around.find_first_not_of(" \t") == std::string_view::npos &&
      source.slice({closed, line.end}).find_first_not_of(" \t\r") == std::string_view::npos;
  if (whole) return {line.begin, std::min<uint64_t>(line.end + 1, source.bytes().size())};
  return {opened, closed};
}

void check(const Input& in, Reporter& out) {
  if (!in.suppressions_applied) return;
  std::optional<BehindStops> unread;
  for (const Suppression& s : in.suppressions) {
    if (s.used || s.malformed || !known_prefix(s.code)) continue;
    // What it is for may show when the stop before it is corrected.
    if (!unread) unread.emplace(in.program, in.flow);
    if (s.line != 0 && unread->contains_line(in.program.source->line(s.line).begin)) continue;
    const std::string what = s.code.empty() ? "any rule" : "`" + s.code + "`";
    const std::string where = s.line == 0 ? "in this file" : "on line " + std::to_string(s.line);
    Finding& f = out.add(s.span, "nothing to suppress: no finding of " + what + " " + where);
    f.help = "remove it";
    // A blank or a comment between it and the line that is meant.
    const Source& source = *in.program.source;
    if (s.line > source.position(s.comment.begin).line && s.line <= in.program.syntax.lines) {
      const std::string_view next = source.slice(source.line(s.line));
      const size_t first = std::min(next.find_first_not_of(" \t\r"), next.size());
      const bool blank = first == next.size(), comment = !blank && (next[first] == '(' || next[first] == ';');
      if (blank || comment)
        f.help = fmt::format("remove it, or put it right before the line that is meant: line {} {}", s.line,
                             blank ? "is blank" : "begins with a comment");
    }
    f.reach = Reach::kAlways;
    f.fixes.push_back({"remove it", false, {{removed(in, s), ""}}});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW002",
    .name = "suppression-unused",
    .summary = "a suppression that suppresses nothing",
    .group = Group::kLinter,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A comment such as `(owlint: ignore OW301)`, but the line or file that it is for has no finding with
that code.)",
            .why = R"(The mistake has been fixed since, or the comment is at the wrong line. If it stays, it hides the
next mistake of that kind there.

To LinuxCNC the line is an ordinary comment.)",
            .bad = R"(G21 G90
G0 X0 Y0 Z5
o100 repeat [3]
  (owlint: ignore OW301)
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
M2
)",
            .good = R"(G21 G90
G0 X0 Y0 Z5
o100 repeat [3]
  G91 G0 X10
  G90 G1 Z-2 F80
  G0 Z5
o100 endrepeat
M2
)",
            .fix = R"(Remove the comment, or move it. A comment on a line of its own applies to the next line; a comment
at the end of a line applies to that line; `(owlint: ignore-file …)` applies to the whole file.)",
            .level_reason = "Warning: the machine is not affected, but the comment would hide the next mistake there.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow002
