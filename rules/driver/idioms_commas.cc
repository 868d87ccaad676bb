// Idioms of commas and semicolons: decimals, and values with one between them.
#include <algorithm>

#include "analyzer/syntax/look_alike.h"
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

/// `1'000`, and with the apostrophe of a typographer.
bool has_thousands_mark(const RefusedLine& line, Finding& f) {
  if ((line.kind() != StopKind::kBadCharacter && line.kind() != StopKind::kExpression) || line.at == 0) return false;
  const uint64_t begin = line.text.offset(line.at);
  const std::string_view written = line.program.source->slice({begin, line.statement.end()});
  const Character mark = character_at(written);
  constexpr char32_t kApostrophe = U'\u2019';
  if (mark.code != U'\'' && mark.code != kApostrophe && mark.code != U'_') return false;
  constexpr size_t kGroup = 3;
  const size_t behind = line.at + mark.length;
  const size_t to = digits_end(line, behind);
  size_t from = line.at;
  while (from > 0 && is_digit(line.text[from - 1])) --from;
  if (from == line.at || to - behind != kGroup || line.apart(line.at)) return false;
  // `1'000'000`
  const std::string sign = line.written(line.at, behind);
  std::string number = line.written(from, line.at) + line.written(behind, to);
  size_t end = to;
  while (line.text.text().substr(end).starts_with(sign) &&
         digits_end(line, end + sign.size()) == end + sign.size() + kGroup) {
    number += line.written(end + sign.size(), end + sign.size() + kGroup);
    end += sign.size() + kGroup;
  }
  f.message = "`" + line.written(from, end) + "` has a mark between its digits, which LinuxCNC does not read";
  f.help = "write `" + number + "`";
  line.propose(f, f.help, {line.put(from, end, number)}, false);
  return true;
}

namespace {

/// The last argument that the sub of a call reads, `#2` of two; 0 if it is not known.
size_t last_read(const RefusedLine& line) {
  constexpr StatementId kLargest = 2000;
  const Program& p = line.program;
  const RegionId sub = line.statement.label == kNoName ? kNoRegion : p.find_sub(p.name(line.statement.label));
  if (sub == kNoRegion || p.regions[sub].last - p.regions[sub].opener > kLargest) return 0;
  size_t last = 0;
  for (StatementId id = p.regions[sub].opener; id < p.regions[sub].last; ++id) {
    const std::string_view text = p.source->slice(p.at(id).whole());
    for (size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1)) {
      constexpr size_t kMost = 30;
      size_t number = 0;
      for (size_t i = at + 1; i < text.size() && is_digit(text[i]) && number <= kMost; ++i)
        number = number * 10 + static_cast<size_t>(text[i] - '0');
      if (number <= kMost) last = std::max(last, number);
    }
  }
  return last;
}

/// `call [1,5] [2]`: a decimal point, or two arguments. Whether it is the first, as the sub reads so many.
void decimal_or_two(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const auto brackets = static_cast<size_t>(std::ranges::count(text, '['));
  const auto commas = static_cast<size_t>(std::ranges::count(text, ','));
  size_t from = line.at;
  while (from > 0 && (is_digit(line.text[from - 1]) || line.text[from - 1] == '.')) --from;
  const size_t to = digits_end(line, line.at + 1);
  const std::string before = line.written(from, line.at);
  const std::string behind = line.written(line.at + 1, to);
  const size_t reads = last_read(line);
  if (reads == brackets && before.find('.') == std::string::npos) {
    f.message = "`" + line.written(from, to) + "` has a comma instead of a decimal point";
    f.help = "write `" + before + "." + behind + "`: the sub reads " + std::to_string(reads) +
        (reads == 1 ? " argument" : " arguments");
    line.propose(f, "write `" + before + "." + behind + "`", {line.put(line.at, line.at + 1, ".")}, false);
    return;
  }
  if (reads != brackets + commas) {
    f.message = "there is a comma between two numbers";
    f.help = "write `[" + before + "." + behind + "]` if it is a decimal point, `[" + before + "] [" + behind +
        "]` if these are two arguments";
    return;
  }
  line.propose(f, "write each argument in its own brackets", {line.put(line.at, line.at + 1, "] [")}, false);
}

}  // namespace

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
    std::string thousands;
    const bool before_end = line.text[line.at + 1] == ']' || line.text[line.at - 1] == '[';
    if (before_end) {
      f.message = "there is a comma, but no value";
      f.help = "remove the comma";
      line.propose(f, f.help, {line.put(line.at, line.at + 1, "")}, false);
      return true;
    }
    if (together && may_be_thousands(line, line.at, line.at + 1, &thousands)) {
      f.help += "; write a decimal point as `.`";
      return true;
    }
    if (together) {
      decimal_or_two(line, f);
      return true;
    }
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
