// Idioms of calculations: one that is not in brackets, a fraction, a function in round brackets, and what only looks like a
// calculation: a checksum, and a slash in the middle of a line.
#include <algorithm>
#include <optional>

#include "analyzer/syntax/known_line.h"
#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

/// The function that a text begins with, and its bracket: `sqrt[`; empty if there is none.
std::string_view function_at(std::string_view text, char bracket) {
  const auto begins = [&](std::string_view name) {
    return text.starts_with(name) && text.size() > name.size() && text[name.size()] == bracket;
  };
  const auto* found = std::ranges::find_if(kFunctionNames, begins);
  return found == std::end(kFunctionNames) ? std::string_view() : text.substr(0, found->size() + 1);
}

/// The start of the value before the error: after the last `=`, or after the last word's letter.
size_t value_start(const RefusedLine& line) {
  const std::string_view before = line.before();
  const size_t equal = before.rfind('=');
  const size_t start = equal == std::string_view::npos ? 0 : equal + 1;
  size_t depth = 0;
  for (size_t i = line.at; i-- > start;) {
    const char c = before[i];
    if (c == ']' || c == '>') ++depth;
    if ((c == '[' || c == '<') && depth > 0) --depth;
    if (depth > 0 || !is_small_letter(c)) continue;
    const bool alone = i == 0 || !is_small_letter(before[i - 1]);  // else it is a function's last one
    if (alone) return i + 1;
    while (i > start && is_small_letter(before[i - 1])) --i;
  }
  return start;
}

/// How many characters the operator has that a text begins with; 0 if it begins with none.
size_t operator_length(std::string_view text) {
  if (text.starts_with("**")) return 2;
  if (!text.empty() && std::string_view("+-*/").find(text[0]) != std::string_view::npos) return 1;
  const auto* word = std::ranges::find_if(kWordOperators, [&](std::string_view w) {
    return text.starts_with(w) && text.size() > w.size() && !is_small_letter(text[w.size()]);
  });
  return word == std::end(kWordOperators) ? 0 : word->size();
}

/// Where the calculation ends whose first operator is at the error; nothing if no value follows one of its operators.
std::optional<size_t> calculation_end(const RefusedLine& line) {
  const std::string_view text = line.text.text().substr(0, line.end);
  std::optional<size_t> at = line.at;
  while (const size_t length = operator_length(text.substr(*at))) {
    at = behind_value(text, *at + length);
    if (!at) return at;
  }
  return at == line.at ? std::nullopt : at;
}

/// Whether a blank stands between two digits, which LinuxCNC reads as one number.
bool divides_number(const RefusedLine& line, size_t from, size_t to) {
  const auto digit = [&](size_t i) { return is_digit(line.text[i]) || line.text[i] == '.'; };
  for (size_t i = from + 1; i < to; ++i) {
    if (digit(i - 1) && digit(i) && line.text.offset(i) > line.text.offset(i - 1) + 1) return true;
  }
  return false;
}

/// `1 1/2`, whose whole number and fraction are a sum: `1+1/2`. Empty for other calculations.
std::string as_sum(std::string_view written) {
  const bool negative = written.starts_with('-');
  const auto number = [&](std::string_view& text) {
    const std::string_view digits = text.substr(0, std::min(text.find_first_not_of("0123456789"), text.size()));
    text.remove_prefix(digits.size());
    return std::string(digits);
  };
  const auto skip = [](std::string_view& text, std::string_view what) {
    const size_t skipped = std::min(text.find_first_not_of(what), text.size());
    text.remove_prefix(skipped);
    return skipped > 0;
  };
  std::string_view rest = written.substr(negative ? 1 : 0);
  const std::string whole = number(rest);
  if (whole.empty() || !skip(rest, " \t")) return {};
  const std::string upper = number(rest);
  skip(rest, " \t");
  if (upper.empty() || !rest.starts_with('/')) return {};
  rest.remove_prefix(1);
  skip(rest, " \t");
  const std::string lower = number(rest);
  if (lower.empty() || !rest.empty()) return {};
  return (negative ? "-" + whole + "-" : whole + "+").append(upper).append("/").append(lower);
}

/// `1-1/2`, which drawings in inches have for 1 1/2: the sum. Empty for other calculations.
std::string mixed_fraction(std::string_view written) {
  const size_t sign = written.find('-');
  const size_t slash = written.find('/');
  if (sign == 0 || sign == std::string_view::npos || slash == std::string_view::npos || slash < sign) return {};
  const std::string_view lower = written.substr(slash + 1);
  constexpr std::string_view kLower[] = {"2", "4", "8", "16", "32", "64"};
  const std::string_view upper = written.substr(sign + 1, slash - sign - 1);
  const bool digits = written.substr(0, sign).find_first_not_of("0123456789") == std::string_view::npos &&
      !upper.empty() && upper.find_first_not_of("0123456789") == std::string_view::npos;
  const bool proper = upper.size() < lower.size() || (upper.size() == lower.size() && upper < lower);
  if (!digits || !proper || std::ranges::find(kLower, lower) == std::end(kLower)) return {};
  return std::string(written.substr(0, sign)).append("+").append(written.substr(sign + 1));
}

/// The exclusive or of a line's bytes before `end`, as the firmware of printers checks them.
int checksum_of(std::string_view bytes) {
  int sum = 0;
  for (const char c : bytes) sum ^= static_cast<unsigned char>(c);
  return sum;
}

/// Whether the text from `from` on is words of G-code, not prose.
bool are_words(const RefusedLine& line, size_t from) {
  std::string_view text = line.text.text().substr(from, line.end > from ? line.end - from : 0);
  if (text.empty()) return false;
  while (!text.empty()) {
    if (!is_small_letter(text[0])) return false;
    const std::optional<size_t> behind = behind_value(text, 1);
    if (!behind) return false;
    text.remove_prefix(*behind);
  }
  return true;
}

std::string without_edges(std::string text) {
  text.erase(text.find_last_not_of(" \t\r") + 1);
  return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
}

}  // namespace

std::optional<size_t> behind_bracket(std::string_view text, size_t at) {
  for (int depth = 0; at < text.size(); ++at) {
    depth += text[at] == '[' ? 1 : text[at] == ']' ? -1 : 0;
    if (depth == 0) return at + 1;
  }
  return std::nullopt;
}

std::optional<size_t> behind_value(std::string_view text, size_t at) {
  while (at < text.size() && (text[at] == '-' || text[at] == '+' || text[at] == '#')) ++at;
  if (at >= text.size()) return std::nullopt;
  if (text[at] == '[') return behind_bracket(text, at);
  if (text[at] == '<') {
    const size_t close = text.find('>', at);
    return close == std::string_view::npos ? std::nullopt : std::optional(close + 1);
  }
  if (const std::string_view function = function_at(text.substr(at), '['); !function.empty()) {
    const std::optional<size_t> behind = behind_bracket(text, at + function.size() - 1);
    if (function != "atan[" || !behind || !text.substr(*behind).starts_with("/[")) return behind;
    return behind_bracket(text, *behind + 1);
  }
  const size_t from = at;
  while (at < text.size() && (is_digit(text[at]) || text[at] == '.')) ++at;
  return at == from ? std::nullopt : std::optional(at);
}

/// `N1 G0 X1 *45`.
bool has_checksum(const RefusedLine& line, Finding& f) {
  const std::string_view rest = line.rest();
  constexpr size_t kMost = 4;
  const bool number = rest.size() > 1 && rest.size() <= kMost && rest[0] == '*' &&
      rest.find_first_not_of("0123456789", 1) == std::string_view::npos;
  if (line.kind() != StopKind::kBadCharacter || !number || line.text[line.statement.block_delete ? 1 : 0] != 'n')
    return false;
  const std::string written = without_edges(line.written(line.at, line.end));
  f.message = "`" + written + "` looks like a checksum of a 3D printer, which LinuxCNC does not read";
  f.help = "remove it; a calculation is written in brackets, such as `X[2 * 3]`";
  const uint64_t star = line.text.offset(line.at);
  const std::string_view before = line.program.source->slice({line.statement.offset, star});
  const std::string_view tight = before.substr(0, before.find_last_not_of(" \t") + 1);
  const std::string digits(rest.substr(1));
  if (digits != std::to_string(checksum_of(before)) && digits != std::to_string(checksum_of(tight))) return true;
  f.help = "remove it";
  const uint64_t from = line.statement.offset + tight.size();
  line.propose(f, "remove `" + written + "`", {{{from, line.text.span(line.at, line.end).end}, ""}}, false);
  return true;
}

/// `M00 /Drill by hand`, `G0 X0 /X1`.
bool has_slash_inside(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kBadCharacter || !line.rest().starts_with("/") || line.at == 0) return false;
  if (line.statement.block_delete && line.at == 1) return false;
  if (line.rest().starts_with("//") || line.rest().starts_with("/*")) return false;
  const size_t start = value_start(line);
  const char letter = start > 0 ? line.text[start - 1] : ' ';
  const bool of_code = letter == 'g' || letter == 'm' || letter == 'n';
  const std::optional<size_t> end = calculation_end(line);
  if (end && !of_code) return false;
  f.message = "`/` in the middle of a line: block delete works only at its beginning";
  const std::string behind = without_edges(line.written(line.at + 1, line.end));
  if (behind.find_first_not_of("0123456789") == std::string::npos) {
    f.help = "write `/` first on the line, or remove it";
  } else if (are_words(line, line.at + 1)) {
    f.help = "write `/" + behind + "` on a line of its own";
  } else {
    f.help = "write text in a comment: `(" + behind + ")`";
  }
  return true;
}

/// `#1 = 1 (one) + 2`: the value ends at the comment.
bool computes_across_comment(const RefusedLine& line, Finding& f) {
  const bool kind = line.kind() == StopKind::kBadCharacter || line.kind() == StopKind::kWordUnreadable;
  if (!kind || !line.before().ends_with(')') || operator_length(line.rest()) == 0) return false;
  const size_t open = line.before().rfind('(');
  const std::string_view value = line.before().substr(0, open);
  const size_t start = value.find_last_of("=") == std::string_view::npos ? 0 : value.find_last_of("=") + 1;
  if (start == 0 || start >= open) return false;
  const std::string all =
      without_edges(line.written(start, open)) + " " + without_edges(line.written(line.at, line.end));
  if (!surely_runs("#1=[" + all + "]")) return false;
  f.message = "a calculation must be in brackets, without a comment in it";
  f.help = "write `[" + all + "]`, and the comment behind it";
  const std::string comment = line.written(open, line.at);
  line.propose(f, "write brackets around the calculation",
               {line.put(start, line.end, "[" + all + "] " + without_edges(comment))}, false);
  return true;
}

/// `#1 = #1 + 1`, `X#1+5`, `X1 1/2`.
bool computes_without_brackets(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kBadCharacter && line.kind() != StopKind::kWordUnreadable &&
      line.kind() != StopKind::kWordBefore && line.kind() != StopKind::kExpression)
    return false;
  if (line.at == 0 || (line.statement.kind == LineKind::kOWord && !line.statement.refused)) return false;
  const char before = line.text[line.at - 1];
  const bool value_before = is_digit(before) || before == '.' || before == '>' || before == ']';
  if (!value_before || line.rest().size() < 2 || operator_length(line.rest()) == 0) return false;
  const size_t start = value_start(line);
  if (start >= line.at) return false;
  const bool assigns = start > 0 && line.text[start - 1] == '=';
  const std::optional<size_t> end = calculation_end(line);
  // Up to the next word, and not with what is no calculation.
  const bool ends = end && (*end >= line.end || is_small_letter(line.text[*end]) || line.text[*end] == '#');
  if (!ends) {
    if (is_small_letter(line.rest()[0])) return false;
    f.message = "`" + line.written(line.at, line.at + 1) + "` has no meaning here";
    f.help = "write a calculation in brackets, such as `[1 + 2]`, and text in a comment";
    return true;
  }
  if (start > 0 && line.text[start - 1] == 'n' && start == 1) {
    f.message = "a line number has digits only";
    f.help = "write the number, and a word's letter before each other value";
    return true;
  }
  const std::string all = without_edges(line.written(start, *end));
  // `X40.1 -0.01`: a blank before the sign and none behind it, as where a letter was lost.
  const bool sign = line.text[line.at] == '-' || line.text[line.at] == '+';
  if (sign && !assigns && line.apart(line.at) && line.at + 1 < line.end && !line.apart(line.at + 1)) {
    f.message = "`" + line.written(line.at, *end) + "` has no letter";
    f.help = "write the letter of the word before it; a calculation is in brackets: `[" + all + "]`";
    return true;
  }
  const std::string sum = as_sum(all);
  const Span span = line.text.span(start, *end);
  f.message = "a calculation must be in brackets";
  if (!sum.empty()) {
    f.message = "`" + all + "` is a calculation, and must be in brackets";
    f.help = "write `[" + sum + "]`";
    line.propose(f, f.help, {{span, "[" + sum + "]"}}, false);
    return true;
  }
  if (const std::string other = mixed_fraction(all); !other.empty()) {
    f.help = "write `[" + other + "]` for a whole number and a fraction, `[" + all + "]` for a calculation";
    return true;
  }
  if (divides_number(line, start, *end) || !surely_runs("#1=[" + all + "]")) {
    f.help = "write all of it in brackets, such as `[1 + 2]`";
    return true;
  }
  f.help = "write `[" + all + "]`";
  line.propose(f, "write brackets around the calculation",
               {{{span.begin, span.begin}, "["}, {{span.end, span.end}, "]"}}, assigns && *end >= line.end);
  return true;
}

/// `XSIN(30)`, `Y ABS #1`: behind the letter of a word.
bool calls_function_behind_letter(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kWordUnreadable && line.kind() != StopKind::kNumberMissing &&
      line.kind() != StopKind::kNumberMalformed)
    return false;
  const std::string_view text = line.text.text();
  const size_t from = line.at + 1;
  if (from >= text.size()) return false;
  const auto* const name = std::ranges::find_if(
      kFunctionNames, [&](std::string_view function) { return text.substr(from).starts_with(function); });
  if (name == std::end(kFunctionNames)) return false;
  const size_t to = from + name->size();
  const char next = to < text.size() ? text[to] : '\0';
  if (next != '(' && next != '#' && next != '-' && next != '.' && !is_digit(next)) return false;
  const std::string function = line.written(from, to);
  f.message = "the argument of `" + function + "` is not in square brackets";
  f.help = "write `" + function + "[...]`, such as `" + line.written(line.at, line.at + 1) + function + "[30]`";
  return true;
}

/// `ABS(-5)`, `SQRT #1`.
bool calls_function_in_round(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kExpression || !line.error.message.starts_with("Left bracket missing after unary"))
    return false;
  const std::string_view text = line.text.text();
  const std::string_view name = text.substr(line.at, line.first_word().size());
  const std::string_view function = function_at(text.substr(line.at), '(');
  const size_t open = line.at + function.size() - 1;
  const size_t close = function.empty() ? std::string_view::npos : text.find(')', open);
  if (close != std::string_view::npos) {
    const std::string inside = line.written(open + 1, close);
    const std::string shown = line.written(line.at, open);
    f.message = "the round brackets behind `" + shown + "` are a comment";
    f.help = "write square brackets: `" + shown + "[" + inside + "]`";
    if (!surely_runs("#1=[" + inside + "]")) return true;
    line.propose(f, "write square brackets", {line.put(open, open + 1, "["), line.put(close, close + 1, "]")}, false);
    return true;
  }
  if (std::ranges::find(kFunctionNames, name) == std::end(kFunctionNames)) return false;
  const std::string shown = line.written(line.at, line.at + name.size());
  f.message = "`" + shown + "` is not followed by `[`";
  const std::string_view all = text.substr(0, line.end);
  const std::optional<size_t> behind = behind_value(all, line.at + name.size());
  f.help = "put its argument in brackets: `" + shown + "[" +
      (behind ? line.written(line.at + name.size(), *behind) : "30") + "]`";
  return true;
}

}  // namespace owlint::rules
