// OW001 suppression-unknown: a suppression comment with a code that no rule has.
// Depends on no fact about the interpreter: to LinuxCNC every suppression is an ordinary comment.
#include "analyzer/syntax/comment_command.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow001 {
namespace {

/// `(owlint ignore OW104)` and `( owlint : ignore OW104 )`: comments that owlint does not take for its own.
void check_marks(std::string_view bytes, uint64_t line, Reporter& out) {
  constexpr std::string_view kBlanks = " \t";
  const size_t line_end = bytes.find('\n', line);
  for (size_t at = bytes.find(kOwlint, line); at < line_end; at = bytes.find(kOwlint, at + 1)) {
    const size_t before = at == 0 ? std::string_view::npos : bytes.find_last_not_of(kBlanks, at - 1);
    if (before == std::string_view::npos || (bytes[before] != '(' && bytes[before] != ';')) continue;
    const size_t end = at + kOwlint.size();
    size_t behind = std::min(bytes.find_first_not_of(kBlanks, end), bytes.size());
    if (behind == end) continue;
    const bool colon = behind < bytes.size() && bytes[behind] == ':';
    if (colon) behind = std::min(bytes.find_first_not_of(kBlanks, behind + 1), bytes.size());
    constexpr std::string_view kIgnore = "ignore";
    const size_t last = behind + kIgnore.size();
    if (small_letters(bytes.substr(behind, kIgnore.size())) != kIgnore ||
        (last < bytes.size() && std::string_view(" \t)-\r\n").find(bytes[last]) == std::string_view::npos))
      continue;
    Finding& f = out.add({at, behind}, "a comment for owlint begins with `owlint:`, without a blank before the `:`");
    f.help = "write `owlint: ignore`";
    f.reach = Reach::kAlways;
    f.fixes.push_back({f.help, false, {{{at, behind}, "owlint: "}}});
  }
}

void check(const Input& in, Reporter& out) {
  if (in.suppressions_applied) return;
  for (const uint64_t line : in.program.syntax.owlint_lines) check_marks(in.program.source->bytes(), line, out);
  for (const Suppression& s : in.suppressions) {
    if (s.malformed) {
      Finding& f = out.add(s.span, "a comment for owlint has neither `ignore` nor `ignore-file`");
      f.help = "write `(owlint: ignore CODE because ...)`";
      f.reach = Reach::kAlways;
    } else if (small_letters(s.code) == "because") {
      Finding& f = out.add(s.span, "the code of a rule is missing before `because`");
      f.help = "write `(owlint: ignore CODE because ...)`";
      f.reach = Reach::kAlways;
    } else if (!known_prefix(s.code)) {
      Finding& f = out.add(s.span, "there is no rule `" + s.code + "`");
      const std::string_view near = nearest_rule(s.code);
      f.help =
          near.empty() ? "write an existing code; `owlint rules` lists all codes" : "write `" + std::string(near) + "`";
      f.reach = Reach::kAlways;
      // LinuxCNC passes comments on, so no change of one is safe.
      if (!near.empty()) f.fixes.push_back({"write `" + std::string(near) + "`", false, {{s.span, std::string(near)}}});
    }
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW001",
    .name = "suppression-unknown",
    .summary = "a suppression names a code that does not exist",
    .group = Group::kLinter,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A comment such as `(owlint: ignore OW999)` with a code that no rule has: usually a typing error, or
a prefix with an extra digit.)",
            .why = R"(A misspelt suppression suppresses nothing. The finding is still reported, and a reader of the
program believes that somebody has checked this line.

To LinuxCNC the line is an ordinary comment.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
(owlint: ignore OW999 because it was checked by the foreman)
G1 Z-2 F80
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G1 Z-2 F80
G0 Z5
M2
)",
            .fix =
                R"(Correct the code (`owlint rules` lists all of them) or remove the comment. A prefix such as `OW3` is
allowed; it means all codes that begin with it.)",
            .level_reason = "Warning: to LinuxCNC it is an ordinary comment; only owlint is affected.",
            .interpreter = "",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow001
