// Idioms in values: names half written, operators and functions of other languages.
#include <algorithm>
#include <array>
#include <cctype>

#include "analyzer/syntax/known_line.h"
#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

bool has_name(const RefusedLine& line, std::string_view name) {
  return line.program.syntax.names.find(name) != kNoName;
}

struct Other {
  std::string_view text;
  std::string_view instead;
};

// Longer ones first.
constexpr std::array<Other, 17> kOperators = {{
    {"==", "EQ"},
    {"=<", "LE"},
    {"=>", "GE"},
    {"=", "EQ"},
    {"!=", "NE"},
    {"<>", "NE"},
    {"><", "NE"},
    {"<=", "LE"},
    {"<", "LT"},
    {">=", "GE"},
    {">", "GT"},
    {"&&", "AND"},
    {"&", "AND"},
    {"||", "OR"},
    {"|", "OR"},
    {"%", "MOD"},
    {"^", "**"},
}};

constexpr std::array<Other, 21> kFunctions = {{
    {"not", "use the opposite comparison: `LE` for not `GT`, `[[...] EQ 0]` for not true"},
    {"sqr", "write `SQRT[...]`"},
    {"pow", "write `[a ** b]`"},
    {"int", "write `FIX[...]`, which rounds down, or `ROUND[...]`"},
    {"trunc", "write `FIX[...]`, which rounds down"},
    {"floor", "write `FIX[...]`"},
    {"ceil", "write `FUP[...]`"},
    {"log", "write `LN[...]`, the natural logarithm"},
    {"min", "compare with an `if`"},
    {"max", "compare with an `if`"},
    {"mod", "write `[a MOD b]`"},
    {"pi", "write `3.14159265`"},
    {"true", "write `1`"},
    {"false", "write `0`"},
    {"arctan", "write `ATAN[y]/[x]`"},
    {"arcsin", "write `ASIN[...]`"},
    {"arccos", "write `ACOS[...]`"},
    {"atn", "write `ATAN[y]/[x]`"},
    {"rnd", "LinuxCNC has no random numbers"},
    {"rand", "LinuxCNC has no random numbers"},
    {"random", "LinuxCNC has no random numbers"},
}};

}  // namespace

/// `#1 =`.
bool lacks_value(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kExpression || line.statement.kind == LineKind::kOWord) return false;
  const std::string_view text = line.text.text();
  const size_t equal = text.find('=', line.at == 0 ? 0 : line.at - 1);
  const size_t behind = equal == std::string_view::npos ? equal : equal + 1;
  const bool nothing =
      behind != std::string_view::npos && (behind >= text.size() || text[behind] == '(' || text[behind] == ';');
  if (!nothing || behind < line.at || text.find('[', line.at) < equal) return false;
  f.message = "there is no value after `=`";
  f.help = "write the value: `" + line.written(text.rfind('#', equal), behind) + " 0`";
  return true;
}

/// `G38.3 [Z#<depth>]`.
bool brackets_whole_word(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const size_t letter = line.at + 1;
  if (line.kind() != StopKind::kBadCharacter || letter + 1 >= text.size() || text[line.at] != '[') return false;
  constexpr std::string_view kLetters = "xyzabcuvwdefhijklpqrst", kValue = "#[0123456789.+-";
  if (kLetters.find(text[letter]) == std::string_view::npos || kValue.find(text[letter + 1]) == std::string_view::npos)
    return false;
  const size_t close = text.find(']', letter);
  if (close == std::string_view::npos) return false;
  f.message = "the bracket belongs behind the letter of the word";
  f.help = "write `" + line.written(letter, letter + 1) + "[" + line.written(letter + 1, close + 1) + "`";
  line.propose(f, f.help, {line.put(line.at, letter + 1, line.written(letter, letter + 1) + "[")}, false);
  return true;
}

/// `[#1 EQ (one) 0]`, `[#1 * (2 + 3)]`, `X(#1 + 2)`.
bool has_comment_in_value(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text();
  const bool of_word = (line.kind() == StopKind::kNumberMalformed || line.kind() == StopKind::kNumberMissing) &&
      line.at + 1 < text.size();
  const size_t open = of_word ? line.at + 1 : line.at;
  if ((line.kind() != StopKind::kExpression && !of_word) || line.text[open] != '(') return false;
  const size_t close = text.find(')', open);
  const std::string inside = line.written(open + 1, close);
  // A number alone may say what the word is for.
  if (of_word && inside.find_first_of("#[+*/") == std::string::npos) return false;
  if (surely_runs("#1=[" + inside + "]") && !line.error.message.starts_with("Unknown operation")) {
    f.message = "round brackets are a comment: LinuxCNC does not read what is in them";
    f.help = "write `[" + inside + "]`";
    line.propose(f, f.help, {line.put(open, open + 1, "["), line.put(close, close + 1, "]")}, false);
    return true;
  }
  const std::string_view before = line.before();
  if (of_word || std::ranges::count(before, '[') <= std::ranges::count(before, ']')) return false;
  f.message = "a comment inside brackets";
  f.help = "write it after the closing bracket";
  return true;
}

/// `#1 := 5`, `#1 == 5`.
bool assigns_otherwise(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kExpression || line.statement.kind == LineKind::kOWord) return false;
  const std::string_view text = line.text.text().substr(0, line.end);
  const size_t colon =
      line.error.message.starts_with("Equal sign missing") ? text.find(":=", line.at) : std::string_view::npos;
  const bool twice = line.rest().starts_with("=") && line.before().ends_with("=");
  if (colon == std::string_view::npos && !twice) return false;
  f.message = colon == std::string_view::npos ? "`==` assigns nothing" : "`:=` assigns nothing";
  f.help = "write `=`";
  line.propose(f, f.help,
               {colon == std::string_view::npos ? line.put(line.at, line.at + 1, "") : line.put(colon, colon + 1, "")},
               true);
  return true;
}

/// `==`, `>`, `&&` and the like.
bool has_other_operator(const RefusedLine& line, Finding& f) {
  const bool bracket = line.kind() == StopKind::kBracketMissing;
  const bool expected = line.kind() == StopKind::kExpression && line.error.message.starts_with("Unknown operation");
  if (!expected || bracket) return false;
  const std::string_view rest = line.rest();
  const auto* other = std::ranges::find_if(kOperators, [&](const Other& o) { return rest.starts_with(o.text); });
  if (other == kOperators.end()) return false;
  const std::string instead(other->instead);
  f.message = "`" + std::string(other->text) + "` is not a LinuxCNC operator";
  f.help = "write `" + instead + "`";
  if (other->text == "=" && line.statement.is(Keyword::kCall)) {
    f.message = "a call cannot assign: it passes values";
    f.help = "write only the value in the brackets; in the sub, the first one is `#1`";
    return true;
  }
  // A letter beside it would become part of it.
  const Span sign = line.text.span(line.at, line.at + other->text.size());
  const auto blank_at = [&](uint64_t offset) { return line.program.source->slice({offset, offset + 1}) == " "; };
  line.propose(f, f.help, {{sign, (blank_at(sign.begin - 1) ? "" : " ") + instead + (blank_at(sign.end) ? "" : " ")}},
               false);
  return true;
}

/// `if NOT [#1 EQ 1]`, `[NOT [#1 EQ 1]]`, `if ![#1 EQ 1]`.
bool has_not_before_bracket(const RefusedLine& line, Finding& f) {
  const std::string_view text = line.text.text().substr(0, line.end);
  const std::string_view rest = line.rest();
  const bool value = rest.starts_with("not[") || rest.starts_with("not#");
  const size_t length = value ? 3 : rest.starts_with("![") || rest.starts_with("!#") ? 1 : 0;
  const bool of_keyword = line.kind() == StopKind::kBracketMissing && !line.has_keyword(Keyword::kRepeat);
  if (length == 0 || (!of_keyword && line.kind() != StopKind::kExpression)) return false;
  const std::optional<size_t> behind = behind_value(text, line.at + length);
  if (!behind || (of_keyword && *behind != line.end)) return false;
  const std::string inside = line.written(line.at + length, *behind) + " EQ 0";
  // With other parts of a condition around it, it needs brackets of its own.
  const bool alone = !of_keyword && line.before().ends_with('[') && text.substr(*behind).starts_with(']');
  const std::string right = alone ? inside : "[" + inside + "]";
  f.message = "LinuxCNC has no `" + line.written(line.at, line.at + length) + "`";
  f.help =
      "write `" + (of_keyword ? line.keyword_text() + " " : std::string()) + (alone ? "[" + right + "]" : right) + "`";
  line.propose(f, f.help, {line.put(line.at, *behind, right)}, false);
  return true;
}

namespace {

/// `[#1 GTE 1]`, `[#1 EQUALS 1]`: LinuxCNC reads the operator that such a word begins with, and then the rest.
bool compares_in_other_word(const RefusedLine& line, Finding& f) {
  constexpr std::array<Other, 11> kWords = {{{"gteq", "GE"},
                                             {"gte", "GE"},
                                             {"geq", "GE"},
                                             {"lteq", "LE"},
                                             {"lte", "LE"},
                                             {"leq", "LE"},
                                             {"neq", "NE"},
                                             {"equals", "EQ"},
                                             {"equal", "EQ"},
                                             {"eqv", "EQ"},
                                             {"less", "LT"}}};
  if (line.at < 2 || line.apart(line.at)) return false;
  const size_t from = line.at - 2;
  const std::string_view text = line.text.text().substr(from, line.end - from);
  const auto* other = std::ranges::find_if(kWords, [&](const Other& o) { return text.starts_with(o.text); });
  const bool whole = other != kWords.end() &&
      (!is_small_letter(text[std::min(other->text.size(), text.size() - 1)]) || line.apart(from + other->text.size()));
  if (!whole) return false;
  const std::string word = line.written(from, from + other->text.size());
  const std::string instead(other->instead);
  f.message = "`" + word + "` is not a LinuxCNC operator";
  f.help = "write `" + instead + "`";
  line.propose(f, f.help, {{{line.text.offset(from), line.text.span(0, from + word.size()).end}, instead}}, false);
  return true;
}

}  // namespace

/// `NOT`, `SQR[2]`, `[depth + 1]`.
bool has_other_function(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kExpression || line.at >= line.text.size()) return false;
  if (line.text[line.at] == '!') {
    f.message = "LinuxCNC has no `!`";
    f.help = kFunctions[0].instead;
    return true;
  }
  if (!line.error.message.starts_with("Unknown word") || !is_small_letter(line.text[line.at])) return false;
  if (compares_in_other_word(line, f)) return true;
  std::string_view lowered = line.text.text().substr(line.at, name_end(line, line.at) - line.at);
  const auto* other = std::ranges::find_if(
      kFunctions, [&](const Other& o) { return lowered == o.text || (o.text == "not" && lowered.starts_with("not")); });
  if (other != kFunctions.end()) {
    f.message = "LinuxCNC has no `" + line.written(line.at, line.at + other->text.size()) + "`";
    f.help = other->instead;
    return true;
  }
  if (line.text[line.at + lowered.size()] == '[') return false;
  // An operator may follow without a blank, as blanks are gone: `depthgt3`.
  while (!lowered.empty() && !has_name(line, lowered)) lowered.remove_suffix(1);
  if (lowered.empty()) {
    const std::string_view text = line.program.source->slice(line.text.span(line.at, line.end));
    const std::string word(
        text.substr(0,
                    static_cast<size_t>(
                        std::ranges::find_if(
                            text, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_'; }) -
                        text.begin())));
    f.message = "`" + word + "` is not a function";
    f.help = "write `#<" + word +
        ">`, if it is a parameter; functions are ABS ACOS ASIN ATAN COS EXISTS EXP FIX FUP LN ROUND SIN SQRT TAN";
    return true;
  }
  const std::string name = line.written(line.at, line.at + lowered.size());
  f.message = "the name of a parameter is written `#<" + name + ">`";
  f.help = "write `#<" + name + ">`";
  line.propose(f, f.help, {line.put(line.at, line.at + lowered.size(), "#<" + name + ">")}, false);
  return true;
}

}  // namespace owlint::rules
