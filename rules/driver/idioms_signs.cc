// Idioms of one sign that is too many, or missing: `50%`, `1 = 5`, `/2 G1 X5`, `[$5420]`, text in typographic quotes.
#include <algorithm>

#include "analyzer/syntax/look_alike.h"
#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

/// The length of the typographic quotation mark at a place of the file; 0 if there is none.
size_t quote_at(std::string_view text) {
  if (text.empty() || !is_foreign(text[0])) return 0;
  const Character c = character_at(text);
  const auto same = look_alike(c.code);
  return same && (same->plain == "\"" || same->plain == "'") ? c.length : 0;
}

}  // namespace

/// `/2 G1 X5`: other controllers have nine switches.
bool numbers_block_delete(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kBadCharacter || !line.statement.block_delete || line.at != 1) return false;
  const std::string_view rest = line.rest();
  if (rest.size() < 2 || rest[0] < '1' || rest[0] > '9' || !is_small_letter(rest[1])) return false;
  const std::string sign = line.written(0, 2);
  f.message = "`" + sign + "` is block delete with a number: LinuxCNC has only `/`";
  f.help = "write `/` without the number";
  line.propose(f, f.help, {line.put(1, 2, "")}, false);
  return true;
}

/// `#1 = 50%`, `F100%`.
bool has_percent(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kBadCharacter || line.at == 0 || line.text[line.at] != '%') return false;
  size_t letter = line.at;
  while (letter > 0 && (is_digit(line.text[letter - 1]) || line.text[letter - 1] == '.')) --letter;
  const bool number = letter < line.at && letter > 0;
  // `M30 %`: a line feed is missing.
  const bool of_code = letter > 0 && std::string_view("gmno").find(line.text[letter - 1]) != std::string_view::npos;
  const char before = line.text[line.at - 1];
  if ((!number && before != ']' && before != '>') || of_code) return false;
  f.message = "`%` behind a value: LinuxCNC has no percentages";
  f.help = "remove it";
  const uint64_t from = line.text.offset(line.at - 1) + 1;
  line.propose(f, "remove `%`", {{{from, line.text.offset(line.at) + 1}, ""}}, false);
  return true;
}

/// `1 = 5`.
bool assigns_to_number(const RefusedLine& line, Finding& f) {
  const size_t first = line.statement.block_delete ? 1 : 0;
  if (line.kind() != StopKind::kBadCharacter || line.at != first) return false;
  const std::string_view rest = line.rest();
  const size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
  if (digits == 0 || digits + 1 >= rest.size() || rest[digits] != '=' || rest[0] == '0') return false;
  const std::string number = line.written(line.at, line.at + digits);
  f.message = "the `#` is missing before `" + number + "`";
  f.help = "write `#" + number + " = " + line.written(line.at + digits + 1, line.end) + "`";
  line.propose(f, "write `#`", {line.put(line.at, line.at, "#")}, false);
  return true;
}

/// `[$5420 + 1]`, `X[$1]`.
bool has_dollar(const RefusedLine& line, Finding& f) {
  const std::string_view rest = line.rest();
  const size_t digits = rest.find_first_not_of("0123456789", 1);
  if (line.kind() != StopKind::kExpression || !rest.starts_with('$') || digits == 1 || rest.size() < 2) return false;
  const std::string number = line.written(line.at + 1, line.at + std::min(digits, rest.size()));
  f.message = "`$" + number + "` is no value: a parameter begins with `#`";
  f.help = "write `#" + number + "`";
  line.propose(f, f.help, {line.put(line.at, line.at + 1, "#")}, false);
  return true;
}

/// `[Y + #6]`: the letter of an axis for its position.
bool names_axis(const RefusedLine& line, Finding& f) {
  constexpr std::string_view kAxes = "xyzabcuvw";
  if (line.kind() != StopKind::kExpression || !line.error.message.starts_with("Unknown word")) return false;
  const std::string_view rest = line.rest();
  if (rest.empty() || kAxes.find(rest[0]) == std::string_view::npos || name_end(line, line.at) != line.at + 1)
    return false;
  if (rest.size() > 1 && rest[1] == '[') return false;
  if (line.is_parameter(rest.substr(0, 1))) return false;
  const std::string letter(rest.substr(0, 1));
  f.message = "`" + line.written(line.at, line.at + 1) + "` has no value of its own";
  f.help = "write `#<_" + letter + ">` for the position of the axis, or `#<" + letter + ">` if it is a parameter";
  line.propose(f, "write `#<_" + letter + ">`", {line.put(line.at, line.at + 1, "#<_" + letter + ">")}, false);
  return true;
}

/// `G0 X1 ‘slowly’`: text in typographic quotes behind words.
bool quotes_text(const RefusedLine& line, Finding& f) {
  const Source& source = *line.program.source;
  const uint64_t begin = line.error.span.begin;
  const std::string_view text = source.slice({begin, line.statement.end()});
  const size_t open = line.kind() == StopKind::kBadCharacter && line.at > 0 ? quote_at(text) : 0;
  if (open == 0 || line.before().ends_with('#') || line.before().ends_with('o')) return false;
  size_t to = open;
  while (to < text.size() && quote_at(text.substr(to)) == 0) to += character_at(text.substr(to)).length;
  const std::string inside(text.substr(open, to - open));
  if (to >= text.size() || inside.empty() || inside.find_first_of("();") != std::string::npos) return false;
  const size_t end = to + quote_at(text.substr(to));
  f.message = "`" + std::string(text.substr(0, end)) + "` is text in quotes, and LinuxCNC has none";
  f.help = "write it in a comment: `(" + inside + ")`";
  line.propose(f, "write `(" + inside + ")`", {{{begin, begin + end}, "(" + inside + ")"}}, false);
  return true;
}

}  // namespace owlint::rules
