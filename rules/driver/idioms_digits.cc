// A letter that looks like a digit in a number: `Z-O.5`, `F1O0`, `#I00`. Before all idioms that take the letter for the begin of
// a word, of an O-word or of a name.
#include <algorithm>

#include "analyzer/syntax/known_line.h"
#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

bool is_of_number(char c) { return is_digit(c) || c == '.'; }
bool is_one(char c) { return c == 'i' || c == 'l'; }
bool is_sign(char c) { return c == '-' || c == '+'; }

/// A number with letters in it, without the sign and the letter of its word.
struct Token {
  size_t from = 0;
  size_t to = 0;
};

/// The characters without a blank between them around the place of the error, or behind the letter and sign that are there.
Token token_at(const RefusedLine& line) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const auto looks = [&](size_t i) { return is_of_number(text[i]) || text[i] == 'o' || is_one(text[i]); };
  size_t at = line.at;
  const bool of_word = line.kind() == StopKind::kNumberMalformed || line.kind() == StopKind::kNumberMissing;
  if (of_word && at < text.size() && is_small_letter(text[at])) ++at;
  if (at > 0 && at < text.size() && is_sign(text[at])) ++at;
  Token token{at, at};
  while (token.from > 0 && looks(token.from - 1) && (token.from == text.size() || !line.apart(token.from)))
    --token.from;
  while (token.to < text.size() && looks(token.to) && (token.to == token.from || !line.apart(token.to))) ++token.to;
  return token;
}

/// Whether each letter of the token surely stands for a digit: another meaning begins with a letter, too.
bool surely_digits(const RefusedLine& line, Token token) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const std::string_view number = text.substr(token.from, token.to - token.from);
  const char before = token.from == 0 ? '\n' : text[token.from - 1];
  const char behind = token.to == text.size() ? '\n' : text[token.to];
  if (behind == '<' || (is_small_letter(behind) && !line.apart(token.to))) return false;
  if (keyword_of(text.substr(token.to)) != Keyword::kUnknown) return false;  // `M5O100 endif`
  if (before == '<' || before == '_' || token.from == 0) return false;
  const bool begins_value = before == '#' || is_sign(before);
  for (size_t i = 0; i < number.size(); ++i) {
    if (is_of_number(number[i])) continue;
    const bool first = i == 0;
    if (first ? !begins_value : number[i - 1] != '.' && number[i] != 'o') return false;
  }
  if (before == '#' && line.is_parameter(number)) return false;
  // `#I`: a name of one letter; `N5O100`: the number of a program.
  const bool has_digit = std::ranges::any_of(number, is_digit);
  if (before == '#' && !has_digit) return false;
  const size_t o = number.find('o');
  return before != 'n' || o == std::string_view::npos || number.size() - o <= 2;
}

}  // namespace

/// `Z-O.5`, `F1O0`, `#I00`.
bool has_letter_for_digit(const RefusedLine& line, Finding& f) {
  const Token token = token_at(line);
  const std::string_view text = line.text.text().substr(0, line.end);
  std::string number(text.substr(token.from, token.to - token.from));
  const auto letter = std::ranges::find_if(number, is_small_letter);
  if (letter == number.end() || !surely_digits(line, token)) return false;
  const bool zero = *letter == 'o';
  const bool zeros_only = std::ranges::none_of(number, is_one);
  std::ranges::replace(number, 'o', '0');
  std::ranges::replace_if(number, is_one, '1');
  size_t from = token.from;
  if (is_sign(text[from - 1]) || text[from - 1] == '#') --from;
  if (from > 0 && is_small_letter(text[from - 1]) && !line.apart(from)) --from;
  const std::string right = line.written(from, token.from) + number;
  f.message = "`" + line.written(from, token.to) + "` has " +
      (zero ? "the letter O in place of a zero" : "a letter in place of a digit");
  f.help = "write `" + right + "`";
  line.propose(f, f.help, {line.put(token.from, token.to, number)}, zeros_only && text[token.from - 1] != '#');
  return true;
}

/// `#1E0`: what an exponent makes of a parameter is no number.
bool has_exponent_in_parameter(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  if (line.kind() != StopKind::kExpression || line.rest().empty() || line.rest()[0] != 'e') return false;
  size_t from = line.at;
  while (from > 0 && is_digit(text[from - 1])) --from;
  if (from == line.at || from == 0 || text[from - 1] != '#' || line.apart(line.at)) return false;
  size_t to = line.at + 1;
  while (to < text.size() && is_digit(text[to])) ++to;
  f.message = "`" + line.written(from - 1, to) + "`: the number of a parameter has digits only";
  f.help = "write the parameter's number, or its name in `< >`";
  return true;
}

}  // namespace owlint::rules
