// OW317 blank-in-number: two numbers with only a space between them.
// Depends on: LinuxCNC removes spaces before it reads a line, also inside numbers: `[1 2]` is 12, and `X10 20` is X1020.
#include <algorithm>

#include "analyzer/syntax/last_statement.h"
#include "rules/driver/idioms.h"

namespace owlint::rules::ow317 {
namespace {

/// The letter or sign before a number, behind blanks and a sign of the number; 0 at the line's begin.
char before_number(const Source& source, Span number, uint64_t line_begin) {
  for (uint64_t at = number.begin; at > line_begin;) {
    const char c = source.slice({--at, at + 1})[0];
    if (c != ' ' && c != '\t' && c != '-' && c != '+') return c;
  }
  return 0;
}

/// What a call was meant to pass: each value in its own brackets.
void explain_call(const Program& p, const Statement& s, Span span, Finding& f) {
  const std::string written(p.source->slice(span));
  std::string apart = written;
  for (size_t at = apart.find_first_of(" \t"); at != std::string::npos; at = apart.find_first_of(" \t", at + 3)) {
    const size_t end = apart.find_first_not_of(" \t", at);
    apart.replace(at, end - at, "] [");
  }
  std::string_view behind = p.source->slice({s.keyword_span().end, s.end()});
  behind = behind.substr(0, behind.find_first_of("(;\r"));
  const std::string all = arguments_in_brackets(behind);
  f.help = "write each argument in its own brackets: `" + (all.empty() ? "[" + apart + "]" : all) + "`";
  f.fixes.push_back({"write each argument in its own brackets", false, {{span, apart}}});
}

/// What stands before a number that is the value of a word: its letter may have been forgotten before the second one.
void explain_word(char letter, Finding& f) {
  const bool word = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
  if (word) f.help = "write the letter of the second number before it, or one number without a space";
}

void check(const Input& in, Reporter& out) {
  const Program& p = in.program;
  const Source& source = *p.source;
  uint64_t done = 0;  // a line whose O-word comes behind a mistake is read twice
  for (const Span span : p.syntax.split_numbers) {
    if (span.begin < done) continue;
    done = span.end;
    const StatementId id = last_statement(p.syntax, span.begin);
    const Statement* const s = id != kNoStatement && span.begin < p.at(id).end() ? &p.at(id) : nullptr;
    if (s != nullptr && s->has_error()) continue;  // what is wrong with the line is said there
    const size_t line_feed = span.begin == 0 ? std::string_view::npos : source.bytes().rfind('\n', span.begin - 1);
    const uint64_t line_begin = line_feed == std::string_view::npos ? 0 : line_feed + 1;
    const char before = before_number(source, span, line_begin);
    // Nobody forgets the letter of a number behind a code that runs: `G 0 1` is a G1 in columns.
    if (std::string_view("gGmM").find(before) != std::string_view::npos) continue;
    const std::string written(source.slice(span));
    std::string read = written;
    std::erase_if(read, [](char c) { return c == ' ' || c == '\t'; });
    Finding& f =
        out.add(span, "`" + written + "` is read as `" + read + "`: LinuxCNC removes spaces, also inside numbers");
    if (s != nullptr) f.reach = in.flow.reach(id);
    f.help = "write the number without a space";
    if (s != nullptr && s->is(Keyword::kCall))
      explain_call(p, *s, span, f);
    else
      explain_word(before, f);
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW317",
    .name = "blank-in-number",
    .summary = "a space inside a number: LinuxCNC reads one number",
    .group = Group::kLine,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(Two numbers with only a space between them: `o100 call [1 2]` with two values in one pair of brackets,
`G1 X10 20` with a forgotten `Y`, `#1 = 1 0`. A space between a letter and its number, as in `X 10`, is no
mistake, nor is one inside the number of a code: `G 0 1` is G1.)",
            .why = R"(LinuxCNC removes all spaces before it reads a line. `[1 2]` is the number 12: the sub gets **one
argument, 12**, and its `#2` is 0. `X10 20` is **X1020**. There is no message.)",
            .bad = R"(G21 G90
o100 sub
  G0 X#1 Y#2
o100 endsub
o100 call [1 2]
M2
)",
            .good = R"(G21 G90
o100 sub
  G0 X#1 Y#2
o100 endsub
o100 call [1] [2]
M2
)",
            .fix =
                R"(Write each argument in its own brackets, and the letter of a word before its number; write a number
without spaces.)",
            .level_reason = "Warning: LinuxCNC runs the line, with one number instead of two.",
            .interpreter = "",
            .options = "",
            .moves = "X12",
            .moves_good = "X1",
        },
    .check = check,
};

}  // namespace owlint::rules::ow317
