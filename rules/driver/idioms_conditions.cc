// Idioms of conditions: one that ends too early, a comparison without its first value, a word of another language behind it.
#include <algorithm>

#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

/// What an operator of another language is in LinuxCNC, if a condition can go on with it.
std::string_view joint_of(std::string_view text) {
  return text.starts_with('&') ? "AND" : text.starts_with('|') ? "OR" : "";
}

/// A comparison or joint of another language, and LinuxCNC's. Longer ones come first.
struct Sign {
  std::string_view text;
  std::string_view instead;
};
constexpr Sign kSigns[] = {{"==", "EQ"}, {"!=", "NE"}, {"<>", "NE"},  {"<=", "LE"}, {">=", "GE"}, {"=", "EQ"},
                           {"<", "LT"},  {">", "GT"},  {"&&", "AND"}, {"||", "OR"}, {"&", "AND"}, {"|", "OR"}};

/// A condition as LinuxCNC reads it, and where it ends in the line.
struct Condition {
  std::string text;
  size_t end = 0;
  bool changed = false;  ///< it is written otherwise in the line
};

/// The value at a place, or what `NOT` turns round.
bool read_value(const RefusedLine& line, Condition* condition) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const size_t from = condition->end;
  const std::string_view rest = text.substr(from);
  const size_t turned = rest.starts_with("not[") || rest.starts_with("not#") ? 3
      : rest.starts_with("![") || rest.starts_with("!#")                     ? 1
                                                                             : 0;
  const std::optional<size_t> behind = behind_value(text, from + turned);
  if (!behind) return false;
  const std::string value = line.written(from + turned, *behind);
  condition->text += turned == 0 ? value : "[" + value + " EQ 0]";
  condition->changed = condition->changed || turned != 0;
  condition->end = *behind;
  return true;
}

/// The condition that goes on at the error, with the bracket before it; nothing if a value is missing in it.
std::optional<Condition> whole_condition(const RefusedLine& line, size_t open) {
  const std::string_view text = line.text.text().substr(0, line.end);
  Condition condition{line.written(open, line.at), line.at, false};
  while (condition.end < text.size()) {
    const std::string_view rest = text.substr(condition.end);
    const auto begins = [&](std::string_view word) { return rest.starts_with(word); };
    const auto* const word = std::ranges::find_if(kWordOperators, begins);
    const auto* const sign = std::ranges::find_if(kSigns, begins, &Sign::text);
    std::string_view instead;
    size_t length = 0;
    if (word != std::end(kWordOperators)) {
      length = word->size();
    } else if (sign != std::end(kSigns)) {
      length = sign->text.size();
      instead = sign->instead;
    } else if (begins("**")) {
      length = 2;
    } else if (std::string_view("+-*/").find(rest[0]) != std::string_view::npos) {
      length = 1;
    } else {
      break;
    }
    const std::string written = line.written(condition.end, condition.end + length);
    condition.text += " " + (instead.empty() ? written : std::string(instead)) + " ";
    condition.changed = condition.changed || !instead.empty();
    condition.end += length;
    if (!read_value(line, &condition)) return std::nullopt;
  }
  return condition;
}

/// `if [#1] OR #2=3`, `if [#1] AND NOT [#2]`, `if [#1] OR [#2] THEN`: the condition needs more than brackets.
bool rewrites_condition(const RefusedLine& line, size_t open, Finding& f) {
  const std::optional<Condition> condition = whole_condition(line, open);
  if (!condition) return false;
  const std::string_view behind = line.text.text().substr(condition->end, line.end - condition->end);
  const bool loop = line.has_keyword(Keyword::kWhile) && behind.starts_with("do") &&
      (behind.size() == 2 || (behind.size() == 3 && is_digit(behind[2])));
  const bool word = behind == "then" || loop;
  if ((!condition->changed && !word) || (!word && !behind.empty())) return false;
  const std::string all = "[" + condition->text + "]";
  f.help = "write `" + line.keyword_text() + " " + all + "`";
  if (word) f.help += ", without `" + line.written(condition->end, line.end) + "`";
  line.propose(f, "write `" + line.keyword_text() + " " + all + "`", {line.put(open, line.end, all)}, false);
  return true;
}

}  // namespace

/// `o100 if [#1 EQ 2] AND [#3 LT 4]`: one bracket must be around it all.
bool has_two_brackets(const RefusedLine& line, Finding& f) {
  constexpr std::string_view kOperators[] = {"and", "or", "xor", "eq", "ne", "gt", "ge",
                                             "lt",  "le", "mod", "+",  "-",  "*",  "/"};
  const std::string_view rest = line.rest();
  const bool takes_one = line.has_keyword(Keyword::kIf) || line.has_keyword(Keyword::kElseif) ||
      line.has_keyword(Keyword::kWhile) || line.has_keyword(Keyword::kRepeat) || line.has_keyword(Keyword::kReturn) ||
      line.has_keyword(Keyword::kEndsub);
  if (line.kind() != StopKind::kTrailingText || !line.statement.has_bracket || !takes_one) return false;
  const bool counts = line.has_keyword(Keyword::kRepeat);
  const bool tests = !counts && !line.has_keyword(Keyword::kReturn) && !line.has_keyword(Keyword::kEndsub);
  if (rest.starts_with("[") || (tests && rest.starts_with(",["))) {
    f.message = "`" + line.keyword_text() + "` takes one pair of brackets, but here is a second one";
    f.help = tests ? "write one pair around everything, and join the parts: `[[...] AND [...]]`"
        : counts   ? "write one count, in one pair of brackets"
                   : "return one value";
    return true;
  }
  const std::string_view joint = joint_of(rest);
  if (joint.empty() && std::ranges::none_of(kOperators, [&](std::string_view word) { return rest.starts_with(word); }))
    return false;
  const bool computes = joint.empty() && (line.first_word().empty() || rest.starts_with("mod"));
  if (counts && !computes) {
    f.message = "`repeat` takes a number of passes, but no condition";
    f.help = "write the loop as a `while` with a counter: it can test a condition, too";
    return true;
  }
  const size_t open = line.text.text().find('[', line.text.text().find(line.keyword_text()));
  if (line.before().ends_with(')')) {
    const size_t comment = line.before().rfind('(');
    const std::string word = joint.empty() ? std::string() : std::string(joint) + " ";
    const size_t from = line.at + (joint.empty() ? 0 : std::min(rest.find_first_not_of("&|"), rest.size()));
    const std::string all = line.written(open, comment) + " " + word + line.written(from, line.end);
    f.message = "the condition ends before the comment: put brackets around the whole condition";
    f.help = "write `" + line.keyword_text() + " [" + all + "]`, and the comment behind it";
    return true;
  }
  const size_t behind_joint = line.at + std::min(rest.find_first_not_of("&|"), rest.size());
  if (!joint.empty()) {
    const std::string all =
        line.written(open, line.at) + " " + std::string(joint) + " " + line.written(behind_joint, line.end);
    f.message = "`" + line.written(line.at, behind_joint) + "` is not a LinuxCNC operator";
    f.help = "write `" + line.keyword_text() + " [" + all + "]`";
    line.propose(f, f.help, {line.put(open, line.end, "[" + all + "]")}, false);
    return true;
  }
  // Up to where the condition goes on.
  const std::string_view whole = line.text.text().substr(0, line.end);
  const auto* const first =
      std::ranges::find_if(kOperators, [&](std::string_view word) { return rest.starts_with(word); });
  std::optional<size_t> behind_all = line.at;
  for (const auto* word = first; behind_all && word != std::end(kOperators);) {
    behind_all = behind_value(whole, *behind_all + word->size());
    word = std::ranges::find_if(
        kOperators, [&](std::string_view w) { return behind_all && whole.substr(*behind_all).starts_with(w); });
  }
  const std::string what = tests ? "condition" : counts ? "count" : "value";
  f.message = "the " + what + " ends before `" + line.written(line.at, line.at + first->size()) +
      "`: put brackets around the whole " + what;
  if (tests && rewrites_condition(line, open, f)) return true;
  const size_t all_end = behind_all.value_or(line.end);
  const std::string all = line.written(open, all_end);
  f.help = "write `" + line.keyword_text() + " [" + all + "]`";
  if (!behind_all) {
    f.help = "write `" + line.keyword_text() + " [" + line.written(open, line.at) + " " +
        line.written(line.at, line.at + first->size()) + " [...]]`";
    return true;
  }
  const std::string behind_text = line.written(all_end, line.end);
  if (whole.substr(all_end) == "]") {  // the outer bracket is only closed
    line.propose(f, "write `[` before the " + what, {line.put(open, open, "[")}, true);
    return true;
  }
  if (!behind_text.empty()) {
    f.help += ", and `" + behind_text + "` on a line of its own";
    return true;
  }
  // What computes is perhaps no part of the condition.
  line.propose(f, "write brackets around everything", {line.put(open, open, "["), line.put(line.end, line.end, "]")},
               !computes);
  // At the end of the text, not of the spaces after it.
  const uint64_t behind = line.text.span(line.at, line.end).end;
  f.fixes[0].edits[1].span = {behind, behind};
  return true;
}

/// `if [#1 GT 3 AND LT 9]`: a comparison without its first value.
bool compares_nothing(const RefusedLine& line, Finding& f) {
  constexpr std::string_view kJoints[] = {"and", "xor", "or"}, kComparisons[] = {"eq", "ne", "gt", "ge", "lt", "le"};
  const std::string_view before = line.before();
  const std::string_view rest = line.rest();
  const auto* const comparison = std::ranges::find_if(kComparisons, [&](std::string_view w) {
    return rest.starts_with(w) && behind_value(rest, w.size()).has_value();
  });
  const auto* const joint = std::ranges::find_if(kJoints, [&](std::string_view w) { return before.ends_with(w); });
  if (line.kind() != StopKind::kExpression || comparison == std::end(kComparisons) || joint == std::end(kJoints))
    return false;
  size_t open = line.at;
  for (int depth = 1; open > 0 && depth > 0;) {
    --open;
    depth += before[open] == ']' ? 1 : before[open] == '[' ? -1 : 0;
  }
  const std::optional<size_t> behind = behind_value(before, open + 1);
  f.message = "`" + line.written(line.at, line.at + comparison->size()) + "` has no value before it";
  f.help = "write the value that it compares again, on both sides of `" +
      line.written(line.at - joint->size(), line.at) + "`";
  if (!behind || *behind > line.at - joint->size()) return true;
  const std::string value = line.written(open + 1, *behind);
  f.help = "write `" + value + " " + line.written(line.at, line.at + *behind_value(rest, comparison->size())) + "`";
  line.propose(f, f.help, {line.put(line.at, line.at, value + " ")}, false);
  return true;
}

}  // namespace owlint::rules
