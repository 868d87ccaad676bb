// OW304 text-after-oword: something left on the line after the O-word is complete.
// Depends on: the rest of the line is an error, unless lines were being skipped when it was read: then it
// is swallowed, also on the line that ends the skip.
#include "analyzer/syntax/known_line.h"
#include "rules/driver/idioms.h"

namespace owlint::rules::ow304 {
namespace {

/// Whether the words after such a line were never dropped, and would run where they are put: after a jump they would not.
bool runs_on(Keyword keyword) { return opens_block(keyword) || keyword == Keyword::kCall; }

/// Whether the text is an O-word that begins or ends something: on a line of its own it is a block without its other end.
bool is_block_line(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t");
  return first != std::string_view::npos && (text[first] == 'o' || text[first] == 'O') &&
      small_letters(text).find("call") == std::string::npos;
}

Finding* report(const Input& in, Reporter& out, StatementId id) {
  const Program& p = in.program;
  const Statement& s = p.at(id);
  std::string text(p.source->slice(s.rest_span()));
  if (text.size() > 40) text = text.substr(0, 37) + "...";
  Finding& f = out.add(s.rest_span(), "`" + text + "` after `" + p.head(id) + "`: only a comment is allowed here");
  const std::string written = std::string(spelling(s.keyword)) + text.substr(0, text.find_first_of(" \t([;"));
  const std::string near = s.keyword_to == s.rest_from
      ? nearest(written, {kKeywordSpellings.begin(), kKeywordSpellings.end()})
      : std::string();
  if (!near.empty() && near != written && written.find_first_of("0123456789") == std::string::npos) {
    f.help = "write `" + near + "`";
    const Span word{s.offset + s.keyword_from, s.offset + s.rest_from + written.size() - spelling(s.keyword).size()};
    // Text that is allowed after one keyword may be an error after another.
    const bool takes_value = near == "if" || near == "elseif" || near == "while" || near == "repeat" ||
        near == "call" || near == "return" || near == "endsub";
    if (takes_value || text.find('[') == std::string::npos)
      f.fixes.push_back({"write `" + near + "`", false, {{word, near}}});
  } else if (surely_refused(p.source->slice(s.rest_span()))) {
    f.help = "remove it, or put it in a comment";
  } else {
    f.help = "put it on a line of its own, or remove it";
    Fix fix = split_line(p, s, s.rest_span().begin, "put it on a line of its own");
    fix.safe = fix.safe && runs_on(s.keyword) && !is_block_line(p.source->slice(s.rest_span())) &&
        calls_known_subs(in, std::string(p.source->slice(s.rest_span())));
    f.fixes.push_back(std::move(fix));
  }
  explain_idiom(in, id, f);
  return &f;
}

/// Whether it is the `sub` of a file's own name. Measured: the first call looks for it, later ones read the line.
bool begins_file(const Program& p, StatementId id) {
  return p.sub_file && p.at(id).is(Keyword::kSub) && p.at(id).label == p.entry;
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError& error) {
    if (p.at(id).inner_cr) return;
    Finding* f = report(in, out, id);
    f->reach = in.flow.reach(id);
    if (begins_file(p, id)) {
      f->message += "; LinuxCNC ignores it in the first call of the file only";
      f->stops = true;
      f->reach = Reach::kMaybe;
      f->interpreter = error.message;
      return;
    }
    // Where no run gets, nobody has ignored it.
    if (f->reach != Reach::kNever) f->message += "; LinuxCNC ignores it here without a message";
  });
}

}  // namespace

extern const Rule kRule{
    .code = "OW304",
    .name = "text-after-oword",
    .summary = "other text on the line after the O-word",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(Moves, M-codes, a second O-word or anything else after a complete O-word: `o100 if [#1 GT 0] G0 X5`,
`o100 endif M2`, `o100 return 5`. An O-word needs a line of its own.)",
            .why =
                R"(The interpreter stops at the line. But if it is skipping when it reads the line, it ignores the text
without a message, even on the line where the skip ends. So `o100 endif G0 Z50` stops the program if
the `if` was true, and **leaves out the retract** if it was false. The same is true for `else`,
`elseif`, `endwhile`, `endrepeat` and for the `endsub` of a definition.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [#5070 EQ 1] G10 L20 P1 Z0
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
            .fix = R"(Write the rest on the next line.)",
            .level_reason = "Error if a run gets here: the program stops. Warning if LinuxCNC ignores the text without "
                            "a message, or no run gets here.",
            .interpreter = "Unexpected character after O-word",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow304
