// OW310 comment-on-oword-line: a comment on the line of an O-word.
// Depends on: comments after the O-word are ignored, also active ones such as MSG and PRINT; before
// or inside it they are errors of other rules.
#include <algorithm>

#include "rules/driver/stops.h"

namespace owlint::rules::ow310 {
namespace {

/// Whether nothing but comments and blanks is in `text`.
bool only_comments(std::string_view text) {
  for (size_t at = 0; at < text.size(); ++at) {
    if (text[at] == ';') return true;
    if (text[at] == '(')
      at = std::min(text.find(')', at), text.size());
    else if (text[at] != ' ' && text[at] != '\t' && text[at] != '\r')
      return false;
  }
  return true;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for (StatementId id = 0; id < p.size(); ++id) {
    const Statement& s = p.at(id);
    if (s.kind != LineKind::kOWord || !s.comment || p.syntax.error(s) != nullptr) continue;
    const std::string_view line = p.source->slice(s.whole());
    const size_t at = line.find_first_of("(;", std::max(s.label_to, s.keyword_to));
    if (at == std::string_view::npos) continue;
    Finding& f = out.add({s.offset + at, s.end()}, "a comment on the line of `" + p.head(id) + "`");
    f.help = "write the comment on a line of its own: this runs, but the documentation calls it undefined";
    f.reach = in.flow.reach(id);
    if (!only_comments(line.substr(at))) continue;
    // Never safe: on a line of its own a MSG or PRINT would begin to work.
    const std::string comment(line.substr(at, line.find_last_not_of(" \t\r") + 1 - at));
    size_t blanks = at;
    while (blanks > 0 && (line[blanks - 1] == ' ' || line[blanks - 1] == '\t')) --blanks;
    f.fixes.push_back({"move the comment to the line above",
                       false,
                       {{{s.offset, s.offset}, indent_of(*p.source, s) + comment + line_end(*p.source, s)},
                        {{s.offset + blanks, s.offset + at + comment.size()}, ""}}});
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW310",
    .name = "comment-on-oword-line",
    .summary = "a comment on an O-word line",
    .group = Group::kLine,
    .level = Severity::kInfo,
    .page =
        {
            .what =
                R"(A `( … )` or `;` comment on a line with an O-word. The documentation calls the result undefined.)",
            .why = R"(LinuxCNC runs such lines today, but **active comments do nothing there**: it neither shows nor
evaluates `(MSG,…)`, `(PRINT,…)` and `(DEBUG,…)` on an O-word line, although it executes the line. A
comment before the O-word, between label and keyword, or between `if` or `return` and the bracket
stops the program.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 0] (MSG,no contact: check the probe)
  M2
o100 endif
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 0]
  (MSG,no contact: check the probe)
  M2
o100 endif
G0 Z5
M2
)",
            .fix = R"(Write the comment on a line of its own, above or below. This rule is off unless you select it,
because an ordinary comment after an O-word is harmless in all versions that were measured.)",
            .level_reason = "Info: the documentation calls it undefined, but every version runs it.",
            .interpreter = "",
            .options = "--extend-select OW310",
        },
    .check = check,
};

}  // namespace owlint::rules::ow310
