// OW301 keyword-unknown: a word after the label that is no O-word keyword.
// Depends on: the keyword is checked whenever a line is read, while skipping too; only inside a sub
// that is being skipped it is accepted.
#include <algorithm>

#include "rules/driver/idioms.h"

namespace owlint::rules::ow301 {
namespace {

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  std::string word(p.source->slice(s.keyword_span()));
  std::erase_if(word, [](char c) { return c == ' ' || c == '\t'; });
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  Finding& f = out.add(s.keyword_span(), "`" + word + "` is not an O-word keyword");
  const std::string near = nearest(word, {kKeywordSpellings.begin(), kKeywordSpellings.end()});
  f.help =
      "write one of the keywords: sub, call, return, if, while, do, repeat and their ends; `owlint explain OW301` "
      "lists them";
  if (!near.empty()) {
    f.help = "write `" + near + "`";
    f.fixes.push_back({"write `" + near + "`", false, {{s.keyword_span(), near}}});
  }
  explain_idiom(in, id, f);
  return &f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError&) { report(in, out, id)->reach = Reach::kNever; });
}

}  // namespace

extern const Rule kRule{
    .code = "OW301",
    .name = "keyword-unknown",
    .summary = "an unknown word after the label",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A line with an O-word whose next word is none of `sub`, `endsub`, `call`, `do`, `while`, `endwhile`,
`repeat`, `endrepeat`, `if`, `elseif`, `else`, `endif`, `break`, `continue`, `return`. owlint
suggests the nearest of these. Often it is a word from another control or language: `goto`, `wend`,
`elsif`, `until`, `for`.)",
            .why =
                R"(The interpreter stops at the line, even in a branch that is not taken. Inside a sub it notices only
when the sub is called.

LinuxCNC recognises a keyword by its beginning: `endiff` is `endif` with an extra `f` and stops with
`Unexpected character after O-word`; `iff [1]` is `if` without its bracket. Spaces do not matter:
`end if` is `endif`.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  G0 Z5
o100 elsif [#5063 LT -9]
  G0 Z50
o100 else
  G0 Z20
o100 endif
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1]
  G0 Z5
o100 elseif [#5063 LT -9]
  G0 Z50
o100 else
  G0 Z20
o100 endif
M2
)",
            .fix = R"(Write a keyword that LinuxCNC knows. There is no jump to a line: replace `GOTO` by an `if` or a
loop.)",
            .level_reason = "Error if a run reads the line: the program stops. Warning if no run does.",
            .interpreter = "Unknown control command in o word",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow301
