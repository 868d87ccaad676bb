// Idioms of commas and semicolons: decimals, and values with one between them.
#include <algorithm>

#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

/// `ATAN[1, 2]`, `ROUND[2.5, 1]`: values with a comma between them in the brackets of a function.
bool has_two_values(const RefusedLine& line, bool together, Finding& f) {
  const std::string_view text = line.text.text();
  size_t open = line.at;
  for (int depth = 1; open > 0 && depth > 0;) {
    --open;
    depth += text[open] == ']' ? 1 : text[open] == '[' ? -1 : 0;
  }
  size_t name = open;
  while (name > 0 && is_small_letter(text[name - 1])) --name;
  const std::string function = line.written(name, open);
  const size_t close = text.find(']', line.at);
  const bool known = std::ranges::find(kFunctionNames, text.substr(name, open - name)) != std::end(kFunctionNames);
  if (!known || close == std::string_view::npos) return false;
  if (text.substr(name, open - name) == "atan" && !text.substr(close).starts_with("]/[")) {
    f.message = "`" + function + "` takes its two values in two brackets";
    f.help =
        "write `" + function + "[" + line.written(open + 1, line.at) + "]/[" + line.written(line.at + 1, close) + "]`";
    line.propose(f, f.help, {line.put(line.at, line.at + 1, "]/[")}, false);
    return true;
  }
  if (together) return false;
  f.message = "`" + function + "` takes one value";
  f.help = "write `" + function + "[" + line.written(open + 1, line.at) + "]`";
  return true;
}

/// The digits behind `at`.
size_t digits_end(const RefusedLine& line, size_t at) {
  while (is_digit(line.text[at])) ++at;
  return at;
}

}  // namespace

bool may_be_thousands(const RefusedLine& line, size_t comma, size_t behind, std::string* text) {
  constexpr size_t kGroup = 3;
  size_t from = comma;
  while (from > 0 && is_digit(line.text[from - 1])) --from;
  size_t to = digits_end(line, behind);
  const bool fits = comma - from >= 1 && comma - from <= kGroup && to - behind == kGroup && line.text[from] != '0' &&
      (from == 0 || line.text[from - 1] != '.');
  if (!fits) return false;
  std::string whole = line.written(from, comma) + line.written(behind, to);
  bool surely = false;  // a second comma, or a point behind it
  while (line.text[to] == ',' && digits_end(line, to + 1) == to + 1 + kGroup) {
    whole += line.written(to + 1, to + 1 + kGroup);
    to += 1 + kGroup;
    surely = true;
  }
  if (line.text[to] == '.') {
    const size_t end = digits_end(line, to + 1);
    whole += line.written(to, end);
    surely = true;
  }
  *text = "write `" + whole + "`";
  if (!surely)
    *text += " if the comma is for thousands, `" + line.written(from, comma) + "." + line.written(behind, to) +
        "` if it is a decimal point";
  return true;
}

/// `1,5`, `call [1, 2]` and `call [1; 2]`.
bool has_comma(const RefusedLine& line, Finding& f) {
  if (line.kind() == StopKind::kExpression && line.statement.is(Keyword::kCall) && line.text[line.at] == ';') {
    f.message = "`;` begins a comment: it does not separate arguments";
    f.help = "write each argument in its own brackets: `[1] [2]`";
    return true;
  }
  if ((line.kind() != StopKind::kBadCharacter && line.kind() != StopKind::kExpression) || !line.rest().starts_with(","))
    return false;
  const bool digits = line.at > 0 && is_digit(line.text[line.at - 1]) && is_digit(line.text[line.at + 1]);
  const bool together = digits && line.text.offset(line.at + 1) == line.text.offset(line.at) + 1;
  if (line.statement.is(Keyword::kCall) && line.kind() == StopKind::kExpression) {
    f.message = "there is a comma between the arguments";
    f.help = "write each argument in its own brackets: `[1] [2]`";
    if (together) f.help += "; write a decimal point as `.`";
    std::string thousands;
    const bool before_end = line.text[line.at + 1] == ']' || line.text[line.at - 1] == '[';
    if (before_end) {
      f.message = "there is a comma, but no value";
      f.help = "remove the comma";
      line.propose(f, f.help, {line.put(line.at, line.at + 1, "")}, false);
      return true;
    }
    if (together && may_be_thousands(line, line.at, line.at + 1, &thousands)) return true;
    line.propose(f, "write each argument in its own brackets", {line.put(line.at, line.at + 1, "] [")}, false);
    return true;
  }
  if (line.kind() == StopKind::kExpression && has_two_values(line, together, f)) return true;
  if (!digits) return false;
  size_t from = line.at;
  while (from > 0 && (is_digit(line.text[from - 1]) || line.text[from - 1] == '.')) --from;
  const size_t to = digits_end(line, line.at + 1);
  if (may_be_thousands(line, line.at, line.at + 1, &f.help)) {
    f.message = "`" + line.written(from, to) + "` has a comma, which LinuxCNC does not read";
    return true;
  }
  std::string whole = line.written(from, line.at);
  std::erase(whole, '.');  // of thousands
  const std::string number = whole + "." + line.written(line.at + 1, to);
  f.message = "`" + line.written(from, to) + "` has a comma instead of a decimal point";
  f.help = "write `" + number + "`";
  line.propose(f, f.help, {line.put(from, to, number)}, false);
  return true;
}

}  // namespace owlint::rules
