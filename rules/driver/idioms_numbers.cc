// Numbers as other programs print them, and words and values of which a part is missing.
#include <algorithm>
#include <array>
#include <charconv>

#include "analyzer/syntax/known_line.h"
#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

constexpr std::string_view kWordLetters = "xyzabcuvwdefhijklpqrst";

bool is_digit_or_point(char c) { return is_digit(c) || c == '.'; }

/// What a program prints for a number that it could not compute. Longer ones first.
constexpr std::string_view kNoNumbers[] = {"infinity", "inf", "nan", "qnan", "snan", "ind"};

/// The length of one of these at the begin of a text, 0 if there is none.
size_t no_number_at(std::string_view text) {
  const auto* const found =
      std::ranges::find_if(kNoNumbers, [&](std::string_view word) { return text.starts_with(word); });
  return found == std::end(kNoNumbers) ? 0 : found->size();
}

}  // namespace

std::string with_all_digits(std::string_view number) {
  constexpr size_t kMost = 20;
  double value = 0;
  const auto [end, problem] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (problem != std::errc{} || end != number.data() + number.size()) return {};
  std::array<char, 400> digits;
  const auto [last, full] =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
  if (full != std::errc{} || last - digits.data() > static_cast<std::ptrdiff_t>(kMost)) return {};
  return {digits.data(), last};
}

/// `[1e-3 * 2]`.
bool has_exponent(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kExpression || !line.error.message.starts_with("Unknown operation") ||
      !line.rest().starts_with('e') || line.at == 0 || !is_digit_or_point(line.text[line.at - 1]))
    return false;
  size_t to = line.at + 1;
  if (line.text[to] == '-' || line.text[to] == '+') ++to;
  if (!is_digit(line.text[to])) return false;
  while (is_digit(line.text[to])) ++to;
  size_t from = line.at;
  while (from > 0 && is_digit_or_point(line.text[from - 1])) --from;
  std::string number(line.text.text().substr(from, to - from));
  std::erase(number, '+');
  const std::string right = with_all_digits(number);
  f.message = "numbers have no exponent: LinuxCNC does not read `" + line.written(from, to) + "`";
  f.help = right.empty() ? "write the number with all its digits" : "write `" + right + "`";
  if (!right.empty()) line.propose(f, f.help, {line.put(from, to, right)}, true);
  return true;
}

/// `XNaN`, `X-inf`, `X1.#IND`.
bool is_no_number(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const bool of_word = line.kind() == StopKind::kWordUnreadable || line.kind() == StopKind::kNumberMissing ||
      line.kind() == StopKind::kNumberMalformed;
  size_t from = line.at;
  size_t to = 0;
  if (of_word && kWordLetters.find(text[from]) != std::string_view::npos) {
    to = from + 1;
    if (to < text.size() && (text[to] == '-' || text[to] == '+')) ++to;
    const size_t length = no_number_at(text.substr(to));
    to += length;
    // The end of the word, or the letter of the next one.
    const bool ends = length != 0 &&
        (to >= text.size() || line.apart(to) ||
         (to + 1 < text.size() && kWordLetters.find(text[to]) != std::string_view::npos &&
          (!is_small_letter(text[to + 1]) || no_number_at(text.substr(to + 1)) != 0)));
    if (!ends) return false;
  } else if (line.kind() == StopKind::kExpression && from > 1 && text[from - 1] == '#' &&
             is_digit_or_point(text[from - 2])) {
    const size_t length = no_number_at(text.substr(from));
    if (length == 0) return false;
    to = from + length;
    while (to < text.size() && is_digit(text[to])) ++to;  // `1.#IND00`
    --from;
    while (from > 0 && (is_digit_or_point(text[from - 1]) || text[from - 1] == '-')) --from;
  } else {
    return false;
  }
  f.message = "`" + line.written(from, to) + "` is no number: what wrote the program could not compute it";
  f.help = "correct that there, in the drawing or the settings, and write the program again";
  return true;
}

/// `G43.1 [5 - 2]`, `G0 X1 [#1 + 2]`.
bool lacks_letter_of_value(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kBadCharacter || line.at == 0 || line.text[line.at] != '[') return false;
  const std::string_view text = line.text.text().substr(0, line.end);
  const std::optional<size_t> close = behind_bracket(text, line.at);
  if (!close) return false;
  const std::string value = line.written(line.at, *close);
  if (!surely_runs("#1=" + value)) {
    f.message = "square brackets are for calculations, and this is none";
    f.help = "write a comment in `( )`";
    return true;
  }
  const bool tool_length = line.before().ends_with("g43.1") || line.before().ends_with("g43.2");
  f.message = "a letter is missing before `" + value + "`";
  f.help = "write the letter of the word, such as `" + std::string(tool_length ? "Z" : "X") + value + "`";
  return true;
}

/// `X[5+3 Y2`.
bool lacks_closing_bracket(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  if (line.kind() != StopKind::kExpression || line.statement.kind == LineKind::kOWord ||
      !line.error.message.starts_with("Unknown operation") || line.at + 1 >= text.size() ||
      kWordLetters.find(text[line.at]) == std::string_view::npos || !line.apart(line.at))
    return false;
  const char next = text[line.at + 1];
  const std::string_view before = line.before();
  const auto open = std::ranges::count(before, '[') - std::ranges::count(before, ']');
  if (open <= 0 || (!is_digit_or_point(next) && next != '-' && next != '#' && next != '[')) return false;
  const std::string closing(static_cast<size_t>(open), ']');
  f.message = "the bracket is not closed before `" + line.written(line.at, line.at + 2) + "`";
  f.help = "write `" + closing + "` after `" + line.written(before.rfind('['), line.at) + "`";
  const uint64_t behind = line.text.span(line.at - 1, line.at).end;
  line.propose(f, f.help, {{{behind, behind}, closing}}, false);
  return true;
}

/// `#1 = #2 = 5`.
bool assigns_twice(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kBadCharacter || line.text[line.at] != '=') return false;
  const std::string_view before = line.before();
  const size_t equal = before.rfind('=');
  const size_t second = before.rfind('#');
  if (equal == std::string_view::npos || second != equal + 1) return false;
  const size_t first = before.rfind('#', equal);
  const std::string_view text = line.text.text().substr(0, line.end);
  const std::optional<size_t> behind = behind_value(text, line.at + 1);
  if (first == std::string_view::npos || !behind) return false;
  const std::string value = line.written(line.at + 1, *behind);
  f.message = "one value is for one parameter: LinuxCNC does not go on behind `" + line.written(first, line.at) + "`";
  f.help = "write `" + line.written(second, line.at) + " = " + value + "` and `" + line.written(first, equal) + " = " +
      value + "`";
  return true;
}

}  // namespace owlint::rules
