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

std::vector<Token> tokens_of(std::string_view line) {
  std::vector<Token> out;
  size_t at = 0;
  while (at < line.size() && line[at] != ';' && line[at] != '[') {
    if (line[at] == '(') at = std::min(line.find(')', at), line.size() - 1);
    if (is_blank(line[at]) || line[at] == ')') {
      ++at;
      continue;
    }
    Token token;
    token.from = at;
    size_t name = std::string_view::npos;  // where the name that is open ends
    for (; at < line.size(); ++at) {
      const char c = line[at];
      const bool in_name = name != std::string_view::npos && at <= name;
      if (!in_name && (is_blank(c) || c == '(' || c == ';' || c == '[')) break;
      if (c == '<' && !in_name) name = line.find('>', at);
      if (!is_blank(c)) token.text += c;
    }
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

/// A label without its `o` and its `< >`.
std::string bare_label(std::string_view text) {
  if (text.size() > 1 && text[0] == 'o' && (text[1] == '<' || (text[1] >= '0' && text[1] <= '9')))
    text.remove_prefix(1);
  if (text.starts_with('<')) text.remove_prefix(1);
  if (text.ends_with('>')) text.remove_suffix(1);
  return std::string(text);
}

class Reading {
 public:
  Reading(const Program& program, const Statement& s)
      : program_(program), s_(s), tokens_(tokens_of(program.source->slice(s.whole()))) {
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

  /// `ohole sub`, `o sub`.
  Meant name_behind_o() {
    if (tokens_.size() < 2 || tokens_[0].text.empty()) return {};
    return found(exact_keyword(tokens_[1].text), tokens_[0].text.substr(1), 0, 1);
  }

  /// `hole sub`, `sub <hole>`. Of subs only: other text may well have an `if` in it.
  Meant words() {
    if (tokens_.size() != 2) return {};
    const Keyword first = exact_keyword(tokens_[0].text);
    const Keyword second = exact_keyword(tokens_[1].text);
    if (first != Keyword::kUnknown && global_label(first)) return found(first, bare_label(tokens_[1].text), 0, 1);
    if (second != Keyword::kUnknown && global_label(second)) return found(second, bare_label(tokens_[0].text), 0, 1);
    return {};
  }

  /// `o1 (why) endif`.
  Meant behind_comment() {
    if (tokens_.size() != 2) return {};
    Meant meant = found(exact_keyword(tokens_[1].text), "", 0, 1);
    meant.has_label = true;
    meant.label = s_.label;
    meant.name = program_.name(s_.label);
    return meant;
  }

 private:
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
  if (s.kind == LineKind::kWords)
    return error->kind == StopKind::kWordUnreadable ? Reading(program, s).words() : Meant{};
  if (s.kind != LineKind::kOWord) return {};
  const std::string label = s.label == kNoName ? std::string() : program.name(s.label);
  if (s.refused) return {s.keyword, true, s.label, label, s.head_span(), 0};
  if (error->kind == StopKind::kLabelWord) return Reading(program, s).name_behind_o();
  if (error->kind == StopKind::kTrailingText && s.is(Keyword::kBare) && s.comment)
    return Reading(program, s).behind_comment();
  if (error->kind != StopKind::kKeywordUnknown) return {};
  std::string word(program.source->slice(s.keyword_span()));
  std::erase_if(word, is_blank);
  return {near_keyword(small_letters(word)), true, s.label, label, s.head_span(), 0};
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
    if (!meant.has_label)
      without_label = id;
    else if (meant.label != kNoName)
      out.emplace(meant.label, id);
  }
  return out;
}

}  // namespace owlint
