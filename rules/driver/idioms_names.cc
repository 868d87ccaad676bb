// Idioms in the names of parameters: without their signs, or with only some of them, and text that only looks like a name.
#include <algorithm>

#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

/// Whether the word `X5` begins at a character, and not a part of a name such as `rot x`.
bool begins_word(const RefusedLine& line, size_t at) {
  constexpr std::string_view kLetters = "abcdefghijklmpqrstuvwxyz", kValue = "#[0123456789.+-";
  return at + 1 < line.end && kLetters.find(line.text[at]) != std::string_view::npos &&
      kValue.find(line.text[at + 1]) != std::string_view::npos;
}

/// Where a name without its `>` ends: at the latest before an operator between blanks.
size_t open_name_end(const RefusedLine& line, size_t from) {
  const auto apart = [&](size_t at) { return line.text.offset(at) > line.text.offset(at - 1) + 1; };
  const size_t to = name_end(line, from);
  for (size_t i = from + 1; i < to; ++i) {
    const auto begins = [&](std::string_view word) {
      const size_t behind = i + word.size();
      return line.text.text().substr(i).starts_with(word) && (behind >= to || apart(behind));
    };
    if (apart(i) && std::ranges::any_of(kWordOperators, begins)) return i;
    // `X#<rot Y5`: words behind a name of the program.
    if (apart(i) && line.is_parameter(line.text.text().substr(from, i - from))) return i;
    // `X#rot Y5`: a name with a blank and a number behind it is rarer than a word.
    if (apart(i) && line.text[to] != '=' && line.text[to] != '>' && begins_word(line, i)) return i;
  }
  return to;
}

/// The name that begins at `from`, in the program's own letters.
std::string name_at(const RefusedLine& line, size_t from) { return line.written(from, name_end(line, from)); }

/// Where a name with hyphens or points in it ends, `z-depth`: one that is assigned to, or that stands where no calculation can.
/// 0 for other names.
size_t hyphened_end(const RefusedLine& line, size_t from) {
  constexpr std::string_view kSigns = "-.";
  size_t to = from;
  bool sign = false;
  while (to < line.end && (to == from || !line.apart(to))) {
    const char c = line.text[to];
    const bool of_name = is_small_letter(c) || is_digit(c) || c == '_';
    const bool inside = kSigns.find(c) != std::string_view::npos && to + 1 < line.end && !line.apart(to + 1) &&
        is_small_letter(line.text[to + 1]);
    if (!of_name && !inside) break;
    sign = sign || inside;
    ++to;
  }
  const std::string_view before = line.before();
  const bool brackets = std::ranges::count(before, '[') > std::ranges::count(before, ']');
  const bool ends = to == line.end || line.apart(to) || line.text[to] == '=';
  return sign && ends && !brackets ? to : 0;
}

/// Whether the `#` before `from` stands behind a whole value, where a word may follow.
bool expects_word(const RefusedLine& line, size_t from) {
  const char before = from < 2 ? ' ' : line.text[from - 2];
  return is_digit(before) || before == '.' || before == ']' || before == '>' || before == ')';
}

/// Whether the `#` before `from` begins text and no value: `G1 X10 #roughing`.
bool begins_comment(const RefusedLine& line, size_t from, size_t to) {
  if (line.statement.kind != LineKind::kWords) return false;
  if (from == 1 || (from == 2 && line.text[0] == '/')) return true;
  if (!surely_refused(line.written(from, line.end))) return false;  // `G0# X60`, `X5 #G1`: words, not text
  const bool text = line.apart(from) || (line.apart(from - 1) && expects_word(line, from));  // `# text`, `X1 #text`
  return text && !line.is_parameter(line.text.text().substr(from, to - from));
}

}  // namespace

size_t name_end(const RefusedLine& line, size_t from) {
  const auto of_name = [](char c) { return is_small_letter(c) || is_digit(c) || c == '_' || is_foreign(c); };
  while (from < line.end && of_name(line.text[from])) ++from;
  return from;
}

/// `#depth = 5`, and `#depth> = 5`.
bool names_without_brackets(const RefusedLine& line, Finding& f) {
  // `Z-#depth` is refused at its letter.
  const bool signed_value = line.kind() == StopKind::kNumberMalformed &&
      (line.rest().substr(1).starts_with("-#") || line.rest().substr(1).starts_with("+#"));
  const size_t from = line.at + (signed_value ? 3 : 0);
  if ((line.kind() != StopKind::kExpression && !signed_value) || from == 0 || line.text[from - 1] != '#' ||
      (!is_small_letter(line.text[from]) && line.text[from] != '_'))
    return false;
  const size_t whole = hyphened_end(line, from);
  const size_t to = whole != 0 ? whole : open_name_end(line, from);
  const std::string name = line.written(from, to);
  if (signed_value) {
    f.message = "the parameter name `" + name + "` is not in `< >`";
    f.help = "write `" + line.written(line.at, from - 1) + "#<" + name + ">`";
    line.propose(f, f.help, {line.put(from, to, "<" + name + ">")}, false);
    return true;
  }
  const bool closed = line.text[to] == '>';
  const bool assigns = line.text[closed ? to + 1 : to] == '=';
  if (!assigns && !closed && begins_comment(line, from, to)) {
    f.message = "`#` does not begin a comment";
    f.help = "begin a comment with `;`; a parameter is `#1` or `#<name>`";
    if (line.at > 1) line.propose(f, "write `;`", {line.put(from - 1, from, ";")}, false);
    return true;
  }
  if (!assigns && !closed && line.statement.kind == LineKind::kWords && expects_word(line, from)) {
    if (name.size() > 1 && !surely_refused(name)) {  // `G0# X60`, `X5 #G1`
      f.message = "`#` does not belong before `" + name + "`";
      f.help = "remove the `#`";
      return true;
    }
    f.message = "a letter is missing before `#" + name + "`";
    f.help = "write the letter of the word, such as `X#<" + name + ">`";
    return true;
  }
  f.message = closed ? "the name `" + name + ">` has no `<`" : "the parameter name `" + name + "` is not in `< >`";
  if (whole != 0) f.message += ": without them it has letters and digits only";
  f.help = "write `#<" + name + ">`";
  line.propose(f, f.help, {line.put(line.at, closed ? to + 1 : to, "<" + name + ">")}, assigns || closed);
  return true;
}

/// `#<depth = 5`.
bool names_half_bracketed(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kExpression || !line.error.message.starts_with("Named parameter not terminated"))
    return false;
  const size_t to = open_name_end(line, line.at + 1);
  const std::string name = line.written(line.at + 1, to);
  f.message = "the name `<" + name + "` has no `>`";
  f.help = name.empty() ? "write `#<name>`" : "write `#<" + name + ">`";
  if (name.empty()) return true;
  line.propose(f, f.help, {line.put(line.at, to, "<" + name + ">")}, line.text[to] == '=');
  return true;
}

/// `<depth> = 5`, `[<depth> + 1]`, `X<depth>`.
bool names_without_number_sign(const RefusedLine& line, Finding& f) {
  const bool word = (line.kind() == StopKind::kWordUnreadable || line.kind() == StopKind::kNumberMissing ||
                     line.kind() == StopKind::kNumberMalformed) &&
      line.text[line.at + 1] == '<';
  const size_t open = word ? line.at + 1 : line.at;
  if (line.kind() != StopKind::kBadCharacter && line.kind() != StopKind::kExpression && !word) return false;
  if (open >= line.text.size() || line.text[open] != '<' || (open > 0 && line.text[open - 1] == '#')) return false;
  if (line.kind() == StopKind::kExpression && line.error.message.starts_with("Unknown operation")) return false;
  const std::string name = name_at(line, open + 1);
  if (name.empty() || line.text[name_end(line, open + 1)] != '>') return false;
  f.message = "the `#` is missing before `<" + name + ">`";
  f.help = "write `#<" + name + ">`";
  if (open == 0 && line.end == name_end(line, open + 1) + 1) {  // alone on its line
    f.message = "`<" + name + ">` is neither a call nor a parameter";
    f.help = "write `o<" + name + "> call` to call a sub, or `#<" + name + "> = 5` to set a parameter";
    return true;
  }
  line.propose(f, f.help, {line.put(open, open, "#")}, true);
  return true;
}

}  // namespace owlint::rules
