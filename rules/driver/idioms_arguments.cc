// Idioms in the arguments of a call: brackets that are missing or too many, and values that only a blank divides.
#include <algorithm>

#include "analyzer/syntax/known_line.h"
#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"
#include "rules/driver/words.h"

namespace owlint::rules {
namespace {

constexpr std::string_view kBlanks = " \t";

size_t skip_blanks(std::string_view text, size_t at) {
  return std::min(text.find_first_not_of(kBlanks, at), text.size());
}

/// Behind a number, a parameter, a function or a bracket, as it is written; `at` itself if there is none.
size_t operand_end(std::string_view text, size_t at) {
  const size_t from = at;
  while (at < text.size() && (text[at] == '-' || text[at] == '+' || text[at] == '#')) ++at;
  if (at < text.size() && (text[at] == '[' || text[at] == '<')) {
    if (text[at] == '[') return behind_bracket(text, at).value_or(from);
    const size_t close = text.find('>', at);
    return close == std::string_view::npos ? from : close + 1;
  }
  const size_t letters = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz", at);
  if (letters != std::string_view::npos && letters > at) {
    if (std::ranges::find(kFunctionNames, text.substr(at, letters - at)) == std::end(kFunctionNames)) return from;
    const std::optional<size_t> behind = text[letters] == '[' ? behind_bracket(text, letters) : std::nullopt;
    if (!behind) return from;
    return text.substr(*behind).starts_with("/[") ? behind_bracket(text, *behind + 1).value_or(from) : *behind;
  }
  const size_t digits = at;
  while (at < text.size() && (is_digit(text[at]) || text[at] == '.')) ++at;
  return at == digits ? from : at;
}

/// Behind the operator that goes on with a value at `at`, blanks included; `at` itself if a new value begins there.
size_t operator_end(std::string_view text, size_t at) {
  const size_t from = skip_blanks(text, at);
  const std::string_view rest = text.substr(from);
  const auto word = std::ranges::find_if(kWordOperators, [&](std::string_view w) { return rest.starts_with(w); });
  if (word != std::end(kWordOperators)) return skip_blanks(text, from + word->size());
  if (rest.starts_with("**")) return skip_blanks(text, from + 2);
  if (rest.empty() || std::string_view("+-*/").find(rest[0]) == std::string_view::npos) return at;
  const size_t behind = skip_blanks(text, from + 1);
  // `1 -2` are two values, `1 - 2` and `1-2` one.
  const bool sign = (rest[0] == '-' || rest[0] == '+') && from > at && behind == from + 1;
  return sign ? at : behind;
}

/// Behind the calculation that begins at `at`, as it is written.
size_t calculation_end(std::string_view text, size_t at) {
  size_t end = operand_end(text, at);
  while (end > at) {
    const size_t behind = operator_end(text, end);
    const size_t next = behind == end ? end : operand_end(text, behind);
    if (next == behind || next == end) return behind == end ? end : at;
    end = next;
  }
  return end;
}

/// Adds the values of a text, each in brackets. False where it is not clear which they are.
// Depth is bounded by the length of a line.
bool add_values(std::string_view text, std::string* values) {
  for (size_t at = 0; at < text.size();) {
    if (kBlanks.find(text[at]) != std::string_view::npos || text[at] == ',' || text[at] == ']') {
      ++at;
      continue;
    }
    const std::optional<size_t> behind = text[at] == '[' ? behind_bracket(text, at) : std::nullopt;
    if (text[at] == '[' && (!behind || operator_end(text, *behind) == *behind)) {
      if (behind && !add_values(text.substr(at + 1, *behind - at - 2), values)) return false;
      at = behind ? *behind : at + 1;
      continue;
    }
    const size_t end = calculation_end(text, at);
    if (end == at) return false;
    *values += (values->empty() ? "[" : " [") + std::string(text.substr(at, end - at)) + "]";
    at = end;
  }
  return true;
}

/// How many brackets of a text are not within others.
int outer_brackets(std::string_view text) {
  int found = 0;
  int depth = 0;
  for (const char c : text) {
    if (c == '[' && depth++ == 0) ++found;
    if (c == ']' && depth > 0) --depth;
  }
  return found;
}

}  // namespace

std::string arguments_in_brackets(std::string_view written) {
  // Places are the same in small letters.
  std::string small(written);
  std::ranges::transform(small, small.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
  std::string values;
  if (!add_values(small, &values)) return {};
  // In the letters of the program.
  size_t at = 0;
  for (char& c : values) {
    if (c == '[' || c == ']' || kBlanks.find(c) != std::string_view::npos) continue;
    while (at < small.size() && small[at] != c) ++at;
    if (at < written.size()) c = written[at++];
  }
  return surely_runs("o1 call " + values) ? values : std::string();
}

/// `call 1 2`, `call [1], [2]`, `call [5] 6]`, `return #1`.
bool passes_without_brackets(const RefusedLine& line, Finding& f) {
  const bool call = line.statement.is(Keyword::kCall);
  if (line.kind() != StopKind::kTrailingText ||
      (!call && !line.statement.is(Keyword::kReturn) && !line.statement.is(Keyword::kEndsub)))
    return false;
  const std::string_view rest = line.rest();
  if (std::string_view("0123456789#-+.,").find(rest[0]) == std::string_view::npos) return false;
  if (rest[0] == ',') {
    f.message = "there is a comma between the arguments";
    f.help = "remove it: write the arguments one after the other, `[1] [2]`";
    line.propose(f, "remove the comma", {line.put(line.at, line.at + 1, "")}, false);
    return true;
  }
  const std::string written = line.written(line.at, line.end);
  const std::string values = arguments_in_brackets(written);
  const bool one = values.find("] [") == std::string::npos;
  f.message = (!call     ? "the returned value `"
                   : one ? "the argument `"
                         : "the arguments `") +
      written + (call && !one ? "` are not in brackets" : "` is not in brackets");
  f.help = call ? "write each argument in its own brackets: `[1] [2]`" : "write it in brackets";
  if (values.empty() || (!call && !one)) return true;
  // With the arguments before it where one of their brackets may be meant otherwise.
  const std::string_view before =
      line.before().substr(line.before().find(line.keyword_text()) + line.keyword_text().size());
  const bool whole = line.statement.value_count == 0 || rest.find(']') != std::string_view::npos;
  const std::string above =
      line.statement.value_count == 0 ? std::string() : line.written(line.at - before.size(), line.at) + " ";
  f.help = "write `" + (whole ? line.keyword_text() + " " + above : std::string()) + values + "`";
  line.propose(f, f.help, {line.put(line.at, line.end, values)}, false);
  return true;
}

/// `call X1 Y2`: words, as `G65` of other controllers passes them.
bool passes_words(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kTrailingText || !line.has_keyword(Keyword::kCall)) return false;
  const Source& source = *line.program.source;
  const Span rest = line.text.span(line.at, line.end);
  std::string values;
  uint64_t behind = rest.begin;
  for (const WrittenWord& word : words_of(source, rest)) {
    // These begin a line of its own.
    if (std::string_view("gmno").find(word.letter) != std::string_view::npos) return false;
    const std::string value(source.slice({word.span.begin + 1, word.span.end}));
    const bool bracketed = value.find('[') != std::string::npos && value.find_first_not_of(kBlanks) == value.find('[');
    values += (values.empty() ? "" : " ") + (bracketed ? value : "[" + value + "]");
    behind = word.span.end;
  }
  if (values.empty() || source.slice({behind, rest.end}).find_first_not_of(kBlanks) != std::string_view::npos)
    return false;
  f.message = "the arguments of `call` are values in brackets, not words";
  f.help = "write `call " + values + "`: the sub reads them in this order, as `#1`, `#2` and so on";
  line.propose(f, "write the values in brackets", {line.put(line.at, line.end, values)}, false);
  return true;
}

/// `o<f> sub #<x> #<y>`, `o<f> sub x, y`.
bool names_sub_arguments(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kTrailingText || !line.has_keyword(Keyword::kSub)) return false;
  const std::string_view text = line.text.text();
  std::vector<std::string> names;
  for (size_t at = line.at; at < line.end;) {
    if (text[at] == ',') {
      ++at;
      continue;
    }
    const bool sign = text[at] == '#';
    const bool closed = text.substr(at + (sign ? 1 : 0)).starts_with('<');
    const size_t from = at + (sign ? 1 : 0) + (closed ? 1 : 0);
    size_t to = from;
    while (to < line.end && (is_small_letter(text[to]) || is_digit(text[to]) || text[to] == '_') &&
           (to == from || closed || !line.apart(to)))
      ++to;
    // `sub why` is more likely a comment, and `#1` of the call is set already.
    if (to == from || (closed && text[to] != '>') || is_digit(text[from])) return false;
    if (!sign && !line.is_parameter(text.substr(from, to - from))) return false;
    names.push_back(line.written(from, to));
    at = to + (closed ? 1 : 0);
  }
  if (names.empty()) return false;
  std::string all;
  for (size_t i = 0; i < names.size(); ++i) all += (i == 0 ? "#<" : " #<") + names[i] + "> = #" + std::to_string(i + 1);
  f.message = "`sub` takes no names: the arguments of the call are `#1`, `#2` and so on in the sub";
  f.help = "write `" + all + "` on the next line";
  const Span rest{line.text.span(line.at - 1, line.at).end, line.text.span(line.at, line.end).end};
  line.propose(
      f, f.help,
      {{rest,
        line_end(*line.program.source, line.statement) + indent_of(*line.program.source, line.statement) + "  " + all}},
      false);
  return true;
}

/// `call [#5 #6]`, `call [1.5 2.5]`, `call [5 [6]]`: one pair of brackets around several values.
bool divides_arguments(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kExpression || !line.has_keyword(Keyword::kCall)) return false;
  const size_t keyword = line.text.text().find(line.keyword_text(), line.text.text().find_first_of("0123456789>"));
  if (keyword == std::string_view::npos) return false;
  const size_t from = keyword + line.keyword_text().size();
  if (from > line.at || line.end <= from) return false;
  const std::string written = line.written(from, line.end);
  if (written.find(',') != std::string::npos) return false;
  const std::string values = arguments_in_brackets(written);
  if (values.empty() || outer_brackets(values) <= outer_brackets(written)) return false;
  f.message = "each argument of a call needs its own brackets";
  f.help = "write `" + line.keyword_text() + " " + values + "`";
  line.propose(f, f.help, {line.put(from, line.end, values)}, false);
  return true;
}

}  // namespace owlint::rules
