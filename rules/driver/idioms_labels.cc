// Idioms in labels: a zero and the letter O in each other's place, and a sign behind the label.
#include <algorithm>

#include "analyzer/text/characters.h"
#include "rules/driver/idioms.h"

namespace owlint::rules {
namespace {

/// The keyword that a text is, with nothing but brackets or a comment behind it.
Keyword whole_keyword(std::string_view text) {
  const Keyword keyword = keyword_of(text);
  if (keyword == Keyword::kUnknown) return keyword;
  const std::string_view behind = text.substr(spelling(keyword).size());
  return behind.empty() || !is_small_letter(behind[0]) ? keyword : Keyword::kUnknown;
}

/// A number with the letter O in place of a zero, and the keyword behind it.
struct MixedLabel {
  size_t from = 0, to = 0;  ///< without the letter of the O-word
  Keyword keyword = Keyword::kUnknown;
  std::string number;
};

std::optional<MixedLabel> mixed_label(std::string_view text) {
  const size_t letter = text.find('o');
  if (letter == std::string_view::npos) return std::nullopt;
  MixedLabel label;
  label.from = label.to = letter + 1;
  while (label.to < text.size() && (is_digit(text[label.to]) || text[label.to] == 'o')) ++label.to;
  label.number = text.substr(label.from, label.to - label.from);
  label.keyword = whole_keyword(text.substr(label.to));
  if (label.keyword == Keyword::kUnknown || label.number.find('o') == std::string::npos ||
      std::ranges::none_of(label.number, is_digit))
    return std::nullopt;
  std::ranges::replace(label.number, 'o', '0');
  return label;
}

/// `100` of `00100`.
std::string without_zeros(std::string label) {
  label.erase(0, std::min(label.find_first_not_of('0'), label.size() - 1));
  return label;
}

/// Whether an O-word with this label is elsewhere in the program.
bool has_label(const RefusedLine& line, const std::string& label) {
  const NameId id = line.program.syntax.names.find(without_zeros(label));
  return id != kNoName && std::ranges::any_of(line.program.by_label[id], [&](StatementId other) {
           return other != line.id && !line.program.at(other).is(Keyword::kBare);
         });
}

}  // namespace

NameId mistyped_label(const Program& program, StatementId id) {
  const Statement& s = program.at(id);
  const LineError* const error = program.syntax.error(s);
  if (error == nullptr || s.kind != LineKind::kOWord || s.length > kLineLimit || s.nul) return kNoName;
  const bool forgotten = error->kind == StopKind::kLabelForgotten;
  if (error->kind != StopKind::kKeywordUnknown && !forgotten) return kNoName;
  LineText line;
  line.assign(program.source->slice(s.whole()), s.offset);
  const std::string_view text = line.text().substr(0, std::min(line.text().find_first_of("(;"), line.size()));
  if (!forgotten) {
    const std::optional<MixedLabel> label = mixed_label(text);
    return label ? program.syntax.names.find(without_zeros(label->number)) : kNoName;
  }
  // `N100 100 if`: behind the blank.
  size_t to = text.find('n') + 1;
  size_t from = to;
  for (; to < text.size() && is_digit(text[to]); ++to) {
    if (line.offset(to) > line.offset(to - 1) + 1) from = to;
  }
  return from == text.find('n') + 1
      ? kNoName
      : program.syntax.names.find(without_zeros(std::string(text.substr(from, to - from))));
}

/// `o1o0 endif`, `o1OO if [1]`: the letter O typed for a zero.
bool has_letter_in_label(const RefusedLine& line, Finding& f) {
  if (line.kind() != StopKind::kKeywordUnknown && line.kind() != StopKind::kLabelWord) return false;
  const std::optional<MixedLabel> label = mixed_label(line.text.text().substr(0, line.end));
  if (!label || label->from > line.at + 1) return false;
  const bool known = has_label(line, label->number);
  if (!known && line.kind() == StopKind::kLabelWord) return false;  // perhaps a name without `< >`
  f.message = "the label has the letter `O` in place of a zero";
  f.help = "write `o" + label->number + " " + std::string(spelling(label->keyword)) + "`";
  line.propose(f, f.help, {line.put(label->from, label->to, label->number)},
               known && label->keyword != Keyword::kSub && label->keyword != Keyword::kEndsub);
  return true;
}

/// `o100: if [1]`, `o100, if [1]`.
bool has_sign_behind_label(const RefusedLine& line, Finding& f) {
  const std::string_view rest = line.rest();
  if (line.kind() != StopKind::kKeywordUnknown || (!rest.starts_with(":") && !rest.starts_with(","))) return false;
  const Keyword keyword = whole_keyword(rest.substr(1));
  if (keyword == Keyword::kUnknown) return false;
  const std::string sign(rest.substr(0, 1));
  f.message = "a `" + sign + "` between the label and its keyword";
  f.help = "remove the `" + sign + "`";
  line.propose(f, f.help, {line.put(line.at, line.at + 1, line.apart(line.at + 1) ? "" : " ")},
               keyword != Keyword::kSub && keyword != Keyword::kEndsub);
  return true;
}

/// `0100 endfi`: a zero in place of the letter, and a keyword with a slip.
bool begins_with_zero(const RefusedLine& line, Finding& f) {
  const size_t first = line.statement.block_delete ? 1 : 0;
  if (line.kind() != StopKind::kBadCharacter || line.at != first || !line.rest().starts_with("0")) return false;
  const std::string_view rest = line.rest();
  const size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
  const std::string_view behind = rest.substr(digits);
  const std::string word(
      behind.substr(0, std::min(behind.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), behind.size())));
  if (digits < 2 || word.size() < 2) return false;
  const std::string near = nearest(word, {kKeywordSpellings.begin(), kKeywordSpellings.end()});
  if (near.empty()) return false;
  const std::string right = "o" + line.written(line.at + 1, line.at + digits) + " " + near;
  f.message = "this O-word begins with the digit zero instead of the letter O";
  f.help = "write `" + right + "`";
  line.propose(f, f.help, {line.put(line.at, line.at + digits + word.size(), right)}, false);
  return true;
}

}  // namespace owlint::rules
