// Idioms of assignments: operators of other languages, names without their signs, and equal signs that are missing.
#include <algorithm>
#include <array>
#include <cctype>

#include "analyzer/syntax/known_line.h"
#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

bool lacks_equal_sign(const RefusedLine& line) {
  return line.kind() == StopKind::kExpression && line.error.message.starts_with("Equal sign missing");
}

/// Where the parameter that begins at `from` ends, `#1` or `#<name>`; 0 if there is none.
size_t parameter_end(const RefusedLine& line, size_t from) {
  const std::string_view text = line.text.text().substr(0, line.end);
  if (!text.substr(from).starts_with('#')) return 0;
  if (text.substr(from + 1).starts_with('<')) {
    const size_t close = text.find('>', from);
    return close == std::string_view::npos ? 0 : close + 1;
  }
  size_t to = from + 1;
  while (to < text.size() && is_digit(text[to])) ++to;
  return to > from + 1 ? to : 0;
}

/// The first place in a range that has a blank before it; `to` if there is none.
size_t apart_at(const RefusedLine& line, size_t from, size_t to) {
  for (size_t i = from + 1; i < to; ++i) {
    if (line.text.offset(i) > line.text.offset(i - 1) + 1) return i;
  }
  return to;
}

bool is_name(std::string_view text) {
  return text.size() > 1 && is_small_letter(text[0]) && !is_digit(text[1]) &&
      std::ranges::all_of(text, [](char c) { return is_small_letter(c) || is_digit(c) || c == '_'; });
}

/// The parameters of Siemens in a value, `R1*2`, as LinuxCNC writes them, in brackets if they are a calculation.
std::string with_parameters(std::string_view written) {
  std::string out;
  bool computes = false;
  for (size_t i = 0; i < written.size(); ++i) {
    const bool letter = std::string_view("rRqQ").find(written[i]) != std::string_view::npos;
    const bool begins = i == 0 || std::isalnum(static_cast<unsigned char>(written[i - 1])) == 0;
    out += letter && begins && i + 1 < written.size() && is_digit(written[i + 1]) ? '#' : written[i];
    computes = computes || (i > 0 && std::string_view("+-*/").find(written[i]) != std::string_view::npos);
  }
  const bool bare = computes && !out.starts_with('[') && surely_runs("#1=[" + out + "]");
  return bare ? "[" + out + "]" : out;
}

/// A word of another controller or of English that is assigned, and the word of LinuxCNC that has its value.
struct AssignedWord {
  std::string_view word;
  std::string_view what;    ///< of Siemens; empty: plain English
  std::string_view before;  ///< of the value in LinuxCNC
  std::string_view help;    ///< in place of a line of its own
};
constexpr std::array kAssignedWords = std::to_array<AssignedWord>({
    {"spos", "turns the spindle to an angle on Siemens", "M19 R", {}},
    {"lims", "limits the speed of the spindle on Siemens", "D", "on the line of `G96`"},
    {"feed", {}, "F", {}},
    {"feedrate", {}, "F", {}},
    {"speed", {}, "S", {}},
    {"rpm", {}, "S", {}},
    {"spindle", {}, "S", {}},
});

/// `SPOS=90`, `FEED = 100`, where the program has no parameter of that name.
bool assigns_known_word(const RefusedLine& line, size_t from, size_t equal, const std::string& value, Finding& f) {
  const std::string_view word = line.text.text().substr(from, equal - from);
  const auto* known = std::ranges::find(kAssignedWords, word, &AssignedWord::word);
  if (known == kAssignedWords.end() || line.is_parameter(word)) return false;
  const std::string written = line.written(from, equal);
  // A calculation needs brackets; `ACP(90)` is no value.
  const bool whole = surely_runs("#1=" + value) && value.find('(') == std::string::npos;
  const bool computes = !whole && surely_runs("#1=[" + value + "]") && value.find('(') == std::string::npos;
  const std::string right = std::string(known->before) + (whole ? value : computes ? "[" + value + "]" : "...");
  const std::string instead = "write `" + right + "`" + (known->help.empty() ? "" : " ") + std::string(known->help);
  f.message = known->what.empty() ? "LinuxCNC has no word `" + written + "`"
                                  : "`" + written + "` " + std::string(known->what) + "; LinuxCNC does not have it";
  f.help = instead;
  if (known->what.empty()) f.help += ", or `#<" + written + "> = " + value + "` if it is a parameter";
  if (known->help.empty() && (whole || computes)) line.propose(f, instead, {line.put(from, line.end, right)}, false);
  return true;
}

constexpr std::array<std::string_view, 11> kDeclarations = {"var",  "let",    "dim",   "set",   "def",  "int",
                                                            "real", "double", "float", "local", "const"};

}  // namespace

/// `#1 += 1`, `#<n>++`.
bool changes_in_place(const RefusedLine& line, Finding& f) {
  const size_t to = lacks_equal_sign(line) ? parameter_end(line, line.at) : 0;
  if (to == 0 || to + 1 >= line.end) return false;
  const std::string sign = line.written(to, to + 1);
  const std::string_view rest = line.text.text().substr(to, line.end - to);
  const bool by_one = rest == "++" || rest == "--";
  if (!by_one && (std::string_view("+-*/").find(sign[0]) == std::string_view::npos || rest[1] != '=')) return false;
  const std::string target = line.written(line.at, to);
  std::string value = by_one ? "1" : line.written(to + 2, line.end);
  if (value.empty()) return false;
  if (value.find_first_of("+-*/") != std::string::npos) value = "[" + value + "]";
  const std::string right = target + " = [" + target + " " + sign + " " + value + "]";
  f.message = "LinuxCNC has no `" + std::string(rest.substr(0, 2)) + "`";
  f.help = "write `" + right + "`";
  line.propose(f, f.help, {line.put(line.at, line.end, right)}, true);
  return true;
}

/// `#<depth> 5`, `#1 5`, `#<depth>> = 5`, `#1` alone.
bool lacks_equal(const RefusedLine& line, Finding& f) {
  const size_t to = lacks_equal_sign(line) ? parameter_end(line, line.at) : 0;
  if (to == 0) return false;
  const std::string target = line.written(line.at, to);
  if (line.text[to] == '>' && line.text[to - 1] == '>' && line.text[to + 1] == '=') {
    f.message = "there is a second `>` after the name";
    f.help = "write `" + target + "`";
    line.propose(f, "remove the second `>`", {line.put(to, to + 1, "")}, true);
    return true;
  }
  if (const size_t gap = apart_at(line, line.at + 1, to); gap < to && is_digit(line.text[to - 1]) && to == line.end) {
    const std::string name = line.written(line.at, gap);
    const std::string value = line.written(gap, to);
    f.message = "the `=` after `" + name + "` is missing: LinuxCNC reads `" + target + "` as `" + name + value + "`";
    f.help = "write `" + name + " = " + value + "`";
    line.propose(f, f.help, {line.put(line.at, to, name + " = " + value)}, false);
    return true;
  }
  if (to >= line.end) {
    f.message = "`" + target + "` has no `=` and no value";
    f.help =
        "write `" + target + " = 5` to set it; to use its value, write a letter before it, such as `X" + target + "`";
    return true;
  }
  if (std::string_view("0123456789.-+[#").find(line.text[to]) == std::string_view::npos) return false;
  const std::string value = line.written(to, line.end);
  f.message = "the `=` after `" + target + "` is missing";
  if (value.find('=') != std::string::npos) {
    f.help = "write a value for each, such as `" + target + " = 0 " + value + "`";
    return true;
  }
  f.help = "write `" + target + " = " + value + "`";
  line.propose(f, f.help, {line.put(line.at, line.end, target + " = " + value)}, false);
  return true;
}

/// `depth = 5`, `$depth = 5`, `VAR depth = 5`, `R1 = 5`.
bool assigns_to_word(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const size_t equal = text.find('=');
  if (equal == std::string_view::npos || equal + 1 >= text.size() || line.statement.kind == LineKind::kOWord ||
      line.at > equal)
    return false;
  size_t from = line.statement.block_delete ? 1 : 0;
  const size_t first = from;
  const std::string value = line.written(equal + 1, line.end);
  if (const bool number = equal > from + 1 && (text[from] == 'r' || text[from] == 'q') &&
          std::ranges::all_of(text.substr(from + 1, equal - from - 1), is_digit);
      number) {
    const std::string digits = line.written(from + 1, equal);
    const std::string right = "#" + digits + " = " + with_parameters(value);
    f.message =
        "`" + line.written(from, equal) + "` cannot be assigned: LinuxCNC's parameters are `#1`, `#2` and so on";
    f.help = "write `" + right + "`";
    line.propose(f, f.help, {line.put(from, line.end, right)}, false);
    return true;
  }
  if (text.substr(from).starts_with('$')) ++from;
  if (const size_t gap = apart_at(line, from, equal); gap < equal) {
    if (std::ranges::find(kDeclarations, text.substr(from, gap - from)) == kDeclarations.end()) return false;
    from = gap;
    if (apart_at(line, from, equal) < equal) return false;
  }
  if (!is_name(text.substr(from, equal - from))) return false;
  if (first == from && assigns_known_word(line, from, equal, value, f)) return true;
  const std::string name = "#<" + line.written(from, equal) + ">";
  f.message = "`" + line.written(first, equal) + "` is not the name of a parameter: a name is written `" + name + "`";
  f.help = "write `" + name + " = " + value + "`";
  line.propose(f, f.help, {line.put(first, equal, name)}, line.is_parameter(text.substr(from, equal - from)));
  return true;
}

/// `#[1 = 5`.
bool lacks_bracket_of_number(const RefusedLine& line, Finding& f) {
  const std::string_view before = line.before();
  const size_t open = before.starts_with("#[") ? 0 : before.starts_with("/#[") ? 1 : std::string_view::npos;
  if (line.kind() != StopKind::kExpression || !line.rest().starts_with("=") || open == std::string_view::npos ||
      std::ranges::count(before, '[') != std::ranges::count(before, ']') + 1)
    return false;
  const std::string target = line.written(open, line.at);
  const std::string right = target + "]";
  f.message = "the `]` is missing after `" + target + "`";
  f.help = "write `" + right + " = " + line.written(line.at + 1, line.end) + "`";
  const uint64_t behind = line.text.offset(line.at - 1) + 1;
  line.propose(f, "write `]`", {{{behind, behind}, "]"}}, false);
  return true;
}

/// `#(depth) = 5`, `#{depth}`.
bool names_in_other_brackets(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kExpression || line.at == 0 || line.text[line.at - 1] != '#') return false;
  const char open = line.text[line.at];
  if (open != '(' && open != '{') return false;
  const std::string_view text = line.text.text();
  const size_t close = text.find(open == '(' ? ')' : '}', line.at);
  if (close == std::string_view::npos || !is_name(text.substr(line.at + 1, close - line.at - 1))) return false;
  const std::string name = "<" + line.written(line.at + 1, close) + ">";
  f.message = std::string("the name of a parameter is in `< >`, not in `") + (open == '(' ? "( )`" : "{ }`");
  f.help = "write `#" + name + "`";
  line.propose(f, f.help, {line.put(line.at, close + 1, name)}, text.substr(close + 1).starts_with('='));
  return true;
}

}  // namespace owlint::rules
