// Idioms in characters: those that only look like the right ones, and letters in place of digits.
#include <algorithm>

#include "analyzer/syntax/known_line.h"
#include "analyzer/syntax/look_alike.h"
#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

/// Whether the letter O that the character at `at` looks like stands for a zero: behind a word's letter or a digit, `GO X1`,
/// and not in a text.
bool stands_for_zero(const RefusedLine& line, size_t at) {
  size_t behind = at;
  while (is_foreign(line.text[behind])) ++behind;
  if (at == 0 || line.apart(at) || line.text[at - 1] == 'o') return false;
  if (!is_small_letter(line.text[at - 1]) && !is_digit(line.text[at - 1]) && line.text[at - 1] != '.') return false;
  if (is_small_letter(line.text[at - 1]) && at > 1 && is_small_letter(line.text[at - 2]) && !line.apart(at - 1))
    return false;
  const char next = line.text[behind];
  return behind >= line.end || line.apart(behind) || is_digit(next) || next == '.';
}

/// What to write for the character at `at` that looks like `plain`. LinuxCNC reads neither commas nor quotation marks.
std::string readable(const RefusedLine& line, size_t at, const std::string& plain) {
  if (plain == "\"" || plain == "'") return at == 0 ? ";" : "";  // there it begins a comment of other languages
  if ((plain == "O" || plain == "o") && stands_for_zero(line, at)) return "0";
  if (plain != ",") return plain;
  size_t behind = at;
  while (is_foreign(line.text[behind])) ++behind;
  const bool digits = at > 0 && is_digit(line.text[at - 1]) && is_digit(line.text[behind]);
  return !digits ? "" : line.statement.is(Keyword::kCall) ? "] [" : ".";
}

/// `o100 if [1] — why`: whether a dash behind a whole O-word stands before text.
bool begins_dash_comment(const RefusedLine& line, size_t at, std::string_view plain) {
  if (line.kind() != StopKind::kTrailingText || plain != "-" || at != line.at) return false;
  const size_t behind = at + foreign_run(line.text.text(), at);
  const std::string_view text = line.text.text().substr(behind);
  const auto calls = [&](std::string_view name) { return text.starts_with(std::string(name) + "["); };
  return !text.empty() && is_small_letter(text[0]) && std::ranges::none_of(kFunctionNames, calls);
}

/// A text to put between two places, without the blanks at its ends that are there already.
std::string without_second_blanks(const Source& source, std::string text, uint64_t from, uint64_t to) {
  if (text.size() < 2) return text;
  if (text.ends_with(' ') && source.slice({to, to + 1}) == " ") text.pop_back();
  if (text.starts_with(' ') && from > 0 && source.slice({from - 1, from}) == " ") text.erase(0, 1);
  return text;
}

/// The digit that a letter of a number looks like; 0 if it looks like none.
char digit_of(char c) { return c == 'l' || c == 'I' ? '1' : c == 'o' || c == 'O' ? '0' : '\0'; }

}  // namespace

/// `X−5` with the minus sign of a web page.
bool has_look_alike(const RefusedLine& line, Finding& f) {
  const Source& source = *line.program.source;
  // The error begins with it, or it is within the word that is not known.
  const std::string_view text = source.slice({line.error.span.begin, line.statement.end()});
  const uint64_t length = line.error.span.end - line.error.span.begin;
  const auto foreign = std::ranges::find_if(text, is_foreign);
  if (foreign == text.end() || static_cast<uint64_t>(foreign - text.begin()) > length) return false;
  const std::string_view from(foreign, text.end());
  const auto same = look_alike(character_at(from).code);
  if (!same) return false;
  size_t first = line.at;
  while (first + 1 < line.text.size() &&
         line.text.offset(first) < line.error.span.begin + static_cast<uint64_t>(foreign - text.begin()))
    ++first;
  const std::string instead = readable(line, first, same->plain);
  f.message = look_alike_text(from);
  const std::string typed = instead.substr(std::min(instead.find_first_not_of(' '), instead.size()));
  f.help = instead.empty() ? "remove it"
      : typed.empty()      ? "type an ordinary space"
                           : "type `" + typed.substr(0, typed.find_last_not_of(' ') + 1) + "`";
  if (instead == "0") f.help += ", a zero";
  if (begins_dash_comment(line, first, same->plain)) {
    f.message = "`" + std::string(from.substr(0, character_at(from).length)) + "` does not begin a comment";
    f.help = "begin a comment with `;`, or write it in `( )`";
    const uint64_t dash = line.text.offset(first);
    const size_t behind = first + foreign_run(line.text.text(), first);
    line.propose(f, "write `;`", {{{dash, dash + character_at(from).length}, ";"}},
                 surely_refused(line.written(behind, line.end)));
    return true;
  }
  std::string thousands;
  const auto may_be_of_thousands = [&](size_t comma) {
    return may_be_thousands(line, comma, comma + foreign_run(line.text.text(), comma), &thousands);
  };
  if (same->plain == "," && may_be_of_thousands(first)) f.help = thousands;
  // All of them on the line at once, but for its comments and names.
  bool surely_meant = true;
  std::vector<Edit> edits;
  for (size_t i = 0; i < line.text.size();) {
    const char c = line.text[i];
    if (c == ';') break;
    if (c == '(' || c == '<') {
      const size_t close = line.text.text().find(c == '(' ? ')' : '>', i);
      i = close == std::string_view::npos ? line.text.size() : close;
      continue;
    }
    const uint64_t at = line.text.offset(i);
    const Character character = character_at(source.slice({at, line.statement.end()}));
    const auto plain = is_foreign(c) ? look_alike(character.code) : std::nullopt;
    if (plain) {
      if (plain->plain == "," && may_be_of_thousands(i)) return true;
      const std::string right = readable(line, i, plain->plain);
      surely_meant = surely_meant && (right == plain->plain || right == "0");
      edits.push_back({{at, at + character.length}, without_second_blanks(source, right, at, at + character.length)});
    }
    i += character.length;
  }
  if (edits.empty()) return true;
  const std::string what = edits.size() == 1 ? f.help : "type ordinary characters";
  line.propose(f, what, std::move(edits), surely_meant);
  return true;
}

/// `Xl0`, `FlOO`: letters in place of digits.
bool has_letters_in_number(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kNumberMissing && line.kind() != StopKind::kWordUnreadable) return false;
  const auto joined = [&](size_t i) { return i < line.end && !line.apart(i); };
  size_t from = line.at;
  const auto of_number = [](char c) { return is_digit(c) || c == '.'; };
  // `X1l` is refused behind its digits.
  while (from > 0 && !line.apart(from) && of_number(line.text[from - 1])) --from;
  if (from < line.at && from > 0 && !line.apart(from)) --from;
  if (!is_small_letter(line.text[from]) || line.text[from] == 'n' || line.text[from] == 'o') return false;
  size_t to = from + 1;
  if (joined(to) && (line.text[to] == '-' || line.text[to] == '+')) ++to;
  const size_t first = to;
  std::string digits;
  bool digit = false;
  bool capital_o = false;
  bool letters = false;
  for (; joined(to); ++to) {
    const char c = line.written(to, to + 1)[0];
    if (!of_number(c) && digit_of(c) == 0) break;
    digit = digit || is_digit(c);
    capital_o = capital_o || c == 'O';
    letters = letters || !of_number(c);
    digits += of_number(c) ? c : digit_of(c);
  }
  // Not a part of a text, such as `Coil`.
  const bool sure = digit || (line.written(first, first + 1) == "l" && (capital_o || to == first + 1));
  if (!letters || joined(to) || !sure || std::ranges::count(digits, '.') > 1 || digits == ".") return false;
  const std::string right = line.written(from, first) + digits;
  f.message = "`" + line.written(from, to) + "` has letters in place of digits";
  f.help = "write `" + right + "`";
  line.propose(f, f.help, {line.put(from, to, right)}, false);
  return true;
}

}  // namespace owlint::rules
