// OW702 number-malformed: a word without a number, or with one that is wrongly written.
// Depends on: a number is a sign, digits and one point at most, with a digit; blanks do not count. What follows it begins a
// new word. Errors in `[ ]` and in settings are OW303's.
#include <algorithm>
#include <cctype>

#include "rules/driver/idioms.h"
#include "rules/driver/words.h"

namespace owlint::rules::ow702 {
namespace {

/// From the word's letter on to the line's end, as the interpreter sees it.
std::string rest_of(const Input& in, const FlowStop& stop, const WordStop& at) {
  const Statement& s = in.program.at(stop.statement);
  return shown(*in.program.source, {at.span.begin, std::max(at.span.begin, s.end())});
}

char byte_at(const Program& p, uint64_t at) { return p.source->slice({at, at + 1})[0]; }
bool is_letter_o(char c) { return c == 'o' || c == 'O'; }
bool is_of_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; }

/// The whole word with an O at `o`: back to its letter, on over digits.
Span word_around(const Program& p, const Statement& s, uint64_t o) {
  Span word{o, o + 1};
  while (word.begin > s.offset && is_of_number(byte_at(p, word.begin - 1))) --word.begin;
  if (word.begin > s.offset) --word.begin;
  while (word.end < s.end() && (is_of_number(byte_at(p, word.end)) || is_letter_o(byte_at(p, word.end)))) ++word.end;
  return word;
}

Edit with_zeros(const Program& p, Span word) {
  std::string right(p.source->slice(word));
  std::ranges::replace(right, 'o', '0');
  std::ranges::replace(right, 'O', '0');
  return {word, right};
}

/// Words behind `from` with the same mistake, as `XO` in `GO XO`: fixed alone, one would only make the next one stop the line.
void add_further_zeros(const Program& p, const Statement& s, uint64_t from, std::vector<Edit>& edits) {
  for (uint64_t at = from; at < s.end(); ++at) {
    const char c = byte_at(p, at);
    if (c == '(' || c == ';') return;
    if (!is_letter_o(c) || at == s.offset ||
        (std::isalpha(static_cast<unsigned char>(byte_at(p, at - 1))) == 0 && !is_of_number(byte_at(p, at - 1))))
      continue;
    const Span word = word_around(p, s, at);
    at = word.end - 1;
    if (word.end == s.end() || (byte_at(p, word.end) != '<' && byte_at(p, word.end) != '['))
      edits.push_back(with_zeros(p, word));
  }
}

/// `X1O`, `GO X1`.
bool letter_for_zero(const Input& in, const FlowStop& stop, Finding& f) {
  const Program& p = in.program;
  const Statement& s = p.at(stop.statement);
  const auto error = word_error(p, stop);
  uint64_t o = 0;
  if (!error || !writes_o_for_zero(p, s, *error, &o)) return false;
  const Span word = word_around(p, s, o);
  Edit edit = with_zeros(p, word);
  f.span = word;
  f.message = "`" + std::string(p.source->slice(word)) + "` has the letter O in place of a zero";
  f.help = "write `" + edit.text + "`";
  const bool good = runs_with(p, s, edit);
  std::vector<Edit> edits{std::move(edit)};
  add_further_zeros(p, s, word.end, edits);
  f.fixes = {{f.help, good, std::move(edits), true}};
  return true;
}

/// `Gl X5`: an l or an i in place of a 1.
bool letter_for_one(const Input& in, const FlowStop& stop, Finding& f) {
  const Program& p = in.program;
  const auto error = word_error(p, stop);
  if (!error || !writes_letter_for_one(p, p.at(stop.statement), *error)) return false;
  f.span = {error->span.begin, error->span.begin + 2};
  const std::string written(p.source->slice(f.span));
  f.message = "`" + written + "` has a letter in place of a number";
  f.help = "write `" + written.substr(0, 1) + "1`";
  f.fixes = {{f.help, false, {{f.span, written.substr(0, 1) + "1"}}, true}};
  return true;
}

void malformed(const WordStop& at, const std::string& letter, const std::string& rest, Finding& f) {
  const auto points = [](std::string_view text) {
    const size_t end = std::min(text.find_first_not_of("0123456789.+-", 1), text.size());
    return std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '.');
  };
  if (points(rest) > 1) {
    const size_t end = std::min(rest.find_first_not_of("0123456789.+-", 1), rest.size());
    f.message = "`" + rest.substr(0, end) + "` has two decimal points";
    f.help = "remove one of them";
    return;
  }
  const char next = rest.size() > 1 ? rest[1] : '\0';
  if (next == '-' || next == '+') {
    f.message = "`" + rest.substr(0, 2) + "` is a sign without a number";
    f.help = "write the number after it";
  } else if (next == '.') {
    f.message = "`" + rest.substr(0, 2) + "` is a point without a digit";
    f.help = "write `" + letter + "0`, or the digits";
  } else if (next == '=' || next == ':') {
    f.message = "`" + letter + "` and its number need no `" + next + "`";
    f.help = "write the number right after `" + letter + "`";
  } else {
    f.message = "the value of `" + at.word + "` cannot be read";
    f.help = "write a number, `#` and a parameter, or a calculation in `[ ]`";
  }
}

Finding& report(const Input& in, Reporter& out, const FlowStop& stop) {
  const WordStop at = word_stop(in, stop);
  Finding& f = out.add(at.span, "");
  if (letter_for_zero(in, stop, f)) return f;
  const std::string rest = rest_of(in, stop, at);
  const std::string letter = rest.substr(0, 1);
  if (letter_for_one(in, stop, f)) return f;
  const std::string_view written =
      in.program.source->slice({at.span.begin, std::max(at.span.begin, in.program.at(stop.statement).end())});
  const size_t behind = written.find_first_not_of(" \t", 1);
  if (behind != std::string_view::npos && written[behind] == '(') {
    f.message = "a comment between `" + letter + "` and its number";
    f.help = "write the comment after the number";
  } else if (rest.starts_with("CR=")) {
    f.message = "`CR=` is the radius of an arc on Siemens";
    f.help = "write `R` and the number";
  } else if (stop.kind != StopKind::kNumberMalformed || rest.size() < 2 || rest[1] == ';') {
    f.message = "`" + letter + "` has no number";
    f.help = "write a number after `" + letter + "`, or remove it";
    if (rest.size() > 1 && std::string_view(",*/").find(rest[1]) != std::string_view::npos)
      f.help = "write a number in place of `" + rest.substr(1, 1) + "`";
    if (rest.size() > 1 && (rest[1] == '=' || rest[1] == ':')) malformed(at, letter, rest, f);
  } else {
    malformed(at, letter, rest, f);
  }
  if (stop.further == nullptr) explain_idiom(in, stop.statement, f);
  return f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) { return &report(in, out, stop); });
}

}  // namespace

extern const Rule kRule{
    .code = "OW702",
    .name = "number-malformed",
    .summary = "a word without a number, or with one that is wrongly written",
    .group = Group::kWords,
    .level = Severity::kError,
    .page =
        {
            .what =
                R"(A letter without a number (`G1 X Y5`), a number with two points (`X1.2.5`), a sign alone (`Z-`), or the
letter O in place of a zero (`GO X1`, `X1O`).)",
            .why = R"(LinuxCNC reads the word when it executes the line, and stops there: with `No characters found in
reading real value` at the end of the line, `Unknown word where unary operation could be` before
another word, `bad number format (trailing characters) parsing '1.2.5'` at a second point. Nothing of
the line is executed.

Blanks within a number do not count: `X1 0` is X10. There is no exponent either: `X1E5` is the two
words X1 and E5.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G1 Z-2.0.5 F80
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G1 Z-2.05 F80
G0 Z5
M2
)",
            .fix =
                R"(Write the number. `--fix` replaces the letter O by a zero; of two points, only you know which one is
meant.)",
            .level_reason = "Error: the program stops. Warning if it stops at an earlier line first.",
            .interpreter = "bad number format (trailing characters) parsing '-2.0.5'",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow702
