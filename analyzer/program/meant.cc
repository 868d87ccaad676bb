#include "analyzer/program/meant.h"

#include <algorithm>
#include <string>
#include <vector>

#include "analyzer/text/characters.h"

namespace owlint {
namespace {

/// What stands between blanks and comments, up to the first `[`, in small letters and without the blanks in a name.
struct Token {
  std::string text;
  size_t from = 0;
  size_t to = 0;
};

/// Behind the bracket at `at`, if it holds the name or number of a label and stands where a label does: first on the line,
/// or after the letter. `at` itself if not.
size_t behind_label_bracket(std::string_view line, size_t at, std::string_view before) {
  const bool after_letter = before == "o" || before == "O";
  if (!after_letter && (!before.empty() || line[at] != '[')) return at;
  const size_t close = line.find(line[at] == '(' ? ')' : ']', at);
  if (close == std::string_view::npos || close == at + 1) return at;
  const bool label = std::ranges::all_of(line.substr(at + 1, close - at - 1), [](char c) {
    return is_digit(c) || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  });
  return label ? close + 1 : at;
}

std::vector<Token> tokens_of(std::string_view line) {
  std::vector<Token> out;
  size_t at = 0;
  const auto label_bracket = [&](std::string_view before) {
    return out.empty() && (line[at] == '[' || line[at] == '(') ? behind_label_bracket(line, at, before) : at;
  };
  while (at < line.size() && line[at] != ';' && (line[at] != '[' || label_bracket("") > at)) {
    if (line[at] == '(') at = std::min(line.find(')', at), line.size());
    if (at < line.size() && (is_blank(line[at]) || line[at] == ')')) ++at;
    if (at == line.size() || is_blank(line[at]) || line[at] == '(' || line[at] == ';') continue;
    Token token;
    token.from = at;
    size_t name = std::string_view::npos;  // where the name that is open ends
    for (; at < line.size(); ++at) {
      const char c = line[at];
      const bool in_name = name != std::string_view::npos && at <= name;
      if (const size_t behind = in_name ? at : label_bracket(token.text); behind > at) {
        token.text += line.substr(at, behind - at);
        at = behind - 1;
        continue;
      }
      if (!in_name && (is_blank(c) || c == '(' || c == ';' || c == '[')) break;
      if (c == '<' && !in_name) name = line.find('>', at);
      if (!is_blank(c)) token.text += c;
    }
    if (token.text.empty()) break;
    token.to = at;
    token.text = small_letters(token.text);
    out.push_back(std::move(token));
  }
  return out;
}

Keyword exact_keyword(std::string_view text) {
  const Keyword keyword = keyword_of(text);
  return spelling(keyword) == text ? keyword : Keyword::kUnknown;
}

/// Whether two words differ in one letter, or in the order of two.
bool one_slip(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty() && a.front() == b.front()) {
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  while (!a.empty() && !b.empty() && a.back() == b.back()) {
    a.remove_suffix(1);
    b.remove_suffix(1);
  }
  if (a.size() == 2 && b.size() == 2) return a[0] == b[1] && a[1] == b[0];
  return a.size() <= 1 && b.size() <= 1;
}

Keyword near_keyword(const std::string& word) {
  const auto* const found =
      std::ranges::find_if(kKeywordSpellings, [&](std::string_view known) { return one_slip(word, known); });
  return found == kKeywordSpellings.end() ? Keyword::kUnknown : static_cast<Keyword>(found - kKeywordSpellings.begin());
}

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// A label without its `o`, and without what is around it in place of `< >`.
std::string bare_label(std::string_view text) {
  constexpr std::string_view kOpen = "<{([\"'";
  const size_t letters = std::min(text.find_first_not_of('o'), text.size());
  if (is_number(text.substr(letters))) {
    text.remove_prefix(letters);
  } else if (text.size() > 1 && text[0] == 'o' && kOpen.find(text[1]) != std::string_view::npos) {
    text.remove_prefix(1);
  }
  if (!text.empty() && kOpen.find(text[0]) != std::string_view::npos) text.remove_prefix(1);
  while (!text.empty() && std::string_view(">})]\"':,").find(text.back()) != std::string_view::npos)
    text.remove_suffix(1);
  return std::string(text);
}

/// Whether `text` stands where a label does and is one, if its letter is another one: `o100`, `100`, `<hole>`, `q100`, `#100`.
bool is_labelled(std::string_view text) {
  if (text.starts_with('o') || text.starts_with('#') || text.starts_with('q')) text.remove_prefix(1);
  const std::string label = bare_label(text);
  return is_number(label) || (label.size() > 1 && is_number(std::string_view(label).substr(1))) ||
      (text.starts_with('<') && text.ends_with('>'));
}

/// Whether a value in brackets follows the keyword; one that may have none does not say.
bool takes_value(Keyword keyword) {
  return keyword == Keyword::kIf || keyword == Keyword::kElseif || keyword == Keyword::kWhile ||
      keyword == Keyword::kRepeat;
}

class Reading {
 public:
  Reading(const Program& program, const Statement& s)
      : program_(program), s_(s), line_(text_of(program, s)), tokens_(tokens_of(line_)) {
    if (s.block_delete && !tokens_.empty() && tokens_[0].text == "/") tokens_.erase(tokens_.begin());
    const bool numbered = !tokens_.empty() && tokens_[0].text.size() > 1 && tokens_[0].text[0] == 'n' &&
        tokens_[0].text.find_first_not_of("0123456789.", 1) == std::string::npos;
    if (numbered) tokens_.erase(tokens_.begin());
  }

  /// `o<loop while [1]`: the last keyword before the brackets, and the name before it.
  Meant open_name() {
    for (size_t i = tokens_.size(); i-- > 1;) {
      const Keyword keyword = exact_keyword(tokens_[i].text);
      if (keyword == Keyword::kUnknown) continue;
      std::string name = tokens_[0].text.substr(std::min(tokens_[0].text.find('<') + 1, tokens_[0].text.size()));
      for (size_t k = 1; k < i; ++k) name += tokens_[k].text;
      Meant meant = found(keyword, name, 0, i);
      meant.name_end = s_.offset + tokens_[i - 1].to;
      return meant;
    }
    return {};
  }

  /// `ohole sub`, `o hole sub`, `o"hole" sub`, `o(100) sub`, `o sub`.
  Meant behind_letter() {
    if (tokens_.empty() || !tokens_[0].text.starts_with('o')) return {};
    const size_t last = tokens_.size() - 1;
    if (last == 0) return found(exact_keyword(std::string_view(tokens_[0].text).substr(1)), "", 0, 0);
    if (last > 1 && tokens_[0].text != "o") return {};
    std::string name = last == 1 ? tokens_[0].text.substr(1) : "";
    for (size_t i = 1; i < last; ++i) name += tokens_[i].text;
    return found(exact_keyword(tokens_[last].text), bare_label(name), 0, last);
  }

  /// `hole sub`, `sub <hole>`, `Q100 if`, `endif 100`, and `o1 endif (open`.
  Meant words() {
    if (tokens_.size() != 2) return {};
    for (const size_t at : {0U, 1U}) {
      const Keyword keyword = exact_keyword(tokens_[at].text);
      const std::string& label = tokens_[1 - at].text;
      if (keyword == Keyword::kUnknown) continue;
      // Other text may well have an `if` in it.
      if (global_label(keyword) || (is_labelled(label) && takes_value(keyword) == value_follows()))
        return found(keyword, label_of(label), 0, 1);
    }
    return {};
  }

  /// `o1 (why) endif`; not of a computed label.
  Meant behind_comment() {
    if (tokens_.size() != 2 || s_.label == kNoName) return {};
    Meant meant = found(exact_keyword(tokens_[1].text), "", 0, 1);
    meant.has_label = true;
    meant.label = s_.label;
    meant.name = program_.name(s_.label);
    return meant;
  }

  /// `o100: sub`, `o100-endif`, `o1O0 sub`, `o<f> sbu`, `o<f> end` of a sub.
  Meant behind_label() {
    std::string_view rest = program_.source->slice({s_.keyword_span().begin, s_.end()});
    rest = rest.substr(0, rest.find_first_of("(;["));
    rest = rest.substr(0, rest.find_last_not_of(" \t\r") + 1);
    std::string word = small_letters(rest);
    std::erase_if(word, is_blank);
    Meant meant;
    meant.has_label = true;
    meant.label = s_.label;
    meant.name = s_.label == kNoName ? "" : program_.name(s_.label);
    meant.words = {s_.label_span().begin, s_.keyword_span().begin + rest.size()};
    const size_t digits = word.find_first_not_of("o0123456789");
    if (word.starts_with('o') && digits != std::string::npos &&
        is_number(meant.name)) {  // the letter O typed for a zero
      meant.keyword = exact_keyword(word.substr(digits));
      if (meant.keyword != Keyword::kUnknown) {
        std::replace(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(digits), 'o', '0');
        meant.name += word.substr(0, digits);
        meant.label = program_.syntax.names.find(meant.name);
        return meant;
      }
    }
    std::string letters = word;
    std::erase_if(letters, [](char c) { return std::string_view(":,-_./").find(c) != std::string_view::npos; });
    meant.keyword = exact_keyword(letters);
    if (meant.keyword != Keyword::kUnknown) return meant;
    meant.words = s_.head_span();
    std::string written = small_letters(program_.source->slice(s_.keyword_span()));
    std::erase_if(written, is_blank);
    meant.keyword = near_keyword(written);
    // Whatever ends it in another language.
    const bool of_sub = meant.keyword == Keyword::kUnknown && written.starts_with("end") && s_.label != kNoName &&
        std::ranges::any_of(program_.by_label[s_.label],
                            [&](StatementId id) { return program_.at(id).is(Keyword::kSub); });
    if (of_sub) meant.keyword = Keyword::kEndsub;
    return meant;
  }

 private:
  /// Without a comment that LinuxCNC cannot read.
  static std::string_view text_of(const Program& program, const Statement& s) {
    const std::string_view line = program.source->slice(s.whole());
    const LineError* const error = program.syntax.error(s);
    return error == nullptr || error->kind > StopKind::kCommentUnclosed ? line : line.substr(0, line.find('('));
  }

  /// Whether a bracket comes behind the last token.
  bool value_follows() const {
    const size_t next = line_.find_first_not_of(" \t\r", tokens_.back().to);
    return next != std::string_view::npos && line_[next] == '[';
  }

  /// `100` of `Q100`, `#100` and `@100`; of `x100` only if that is a label.
  std::string label_of(std::string_view text) const {
    const bool before_name = text.size() > 1 && text[1] == '<';
    const std::string label = bare_label(text.starts_with('#') || before_name ? text.substr(1) : text);
    if (label.size() < 2 || !is_number(std::string_view(label).substr(1)) || is_digit(label[0])) return label;
    const std::string number = label.substr(1);
    const NameId id = program_.syntax.names.find(number);
    const bool used = id != kNoName && !program_.by_label[id].empty();
    return used || label[0] == 'q' || label[0] < 'a' || label[0] > 'z' ? number : label;
  }

  Meant found(Keyword keyword, const std::string& label, size_t first, size_t last) const {
    Meant meant;
    meant.keyword = keyword;
    meant.has_label = !label.empty();
    meant.name = label;
    if (meant.has_label) meant.label = program_.syntax.names.find(label);
    meant.words = {s_.offset + tokens_[first].from, s_.offset + tokens_[last].to};
    return meant;
  }

  const Program& program_;
  const Statement& s_;
  std::string_view line_;
  std::vector<Token> tokens_;
};

}  // namespace

Meant meant_by(const Program& program, StatementId id) {
  const Statement& s = program.at(id);
  const LineError* error = program.syntax.error(s);
  if ((error == nullptr && !s.name_open) || s.nul || s.inner_cr || s.length > kLineLimit) return {};
  if (s.name_open) return Reading(program, s).open_name();
  if (s.kind == LineKind::kWords && s.keyword != Keyword::kUnknown)
    return {s.keyword, false, kNoName, "", s.keyword_span(), 0};
  if (s.kind == LineKind::kWords) return Reading(program, s).words();
  if (s.kind != LineKind::kOWord) return {};
  if (s.refused) return {s.keyword, true, s.label, s.label == kNoName ? "" : program.name(s.label), s.head_span(), 0};
  if (s.label == kNoName && s.label_expr == kNoExpr) return Reading(program, s).behind_letter();
  if (error->kind == StopKind::kTrailingText && s.is(Keyword::kBare) && s.comment)
    return Reading(program, s).behind_comment();
  return error->kind == StopKind::kKeywordUnknown ? Reading(program, s).behind_label() : Meant{};
}

std::unordered_map<NameId, StatementId> misread_subs(const Program& program) {
  std::unordered_map<NameId, StatementId> out;
  StatementId without_label = kNoStatement;
  for (StatementId id = 0; id < program.size(); ++id) {
    const Statement& s = program.at(id);
    if (without_label != kNoStatement && (s.is(Keyword::kSub) || s.is(Keyword::kEndsub))) {
      if (s.is(Keyword::kEndsub) && s.label != kNoName) out.emplace(s.label, without_label);
      without_label = kNoStatement;
    }
    if (!s.has_error() && !s.name_open) continue;
    const Meant meant = meant_by(program, id);
    if (meant.keyword != Keyword::kSub) continue;
    const bool used = meant.label != kNoName && !program.by_label[meant.label].empty();
    if (!used)
      without_label = id;
    else
      out.emplace(meant.label, id);
  }
  return out;
}

}  // namespace owlint
