#include "analyzer/lsp/lexer.h"

#include <algorithm>
#include <array>

#include "analyzer/text/characters.h"
#include "analyzer/text/source.h"

namespace owlint::lsp {
namespace {

constexpr std::array<std::string_view, 10> kWordOperators = {"mod", "eq", "ne",  "gt", "ge",
                                                             "lt",  "le", "and", "or", "xor"};

class Lexer {
 public:
  explicit Lexer(std::string_view line) : line_(line) {}

  std::vector<Token> run() {
    while (at_ < line_.size()) step();
    return std::move(tokens_);
  }

 private:
  char peek(size_t ahead = 0) const { return at_ + ahead < line_.size() ? line_[at_ + ahead] : '\0'; }
  void add(TokenKind kind, size_t begin) { tokens_.push_back({kind, begin, at_}); }

  template <typename Wanted>
  void skip(const Wanted& wanted) {
    while (at_ < line_.size() && wanted(line_[at_])) ++at_;
  }

  void step() {
    const size_t begin = at_;
    const char c = peek();
    if (is_blank(c)) {
      ++at_;
    } else if (c == '(' || c == ';') {
      const size_t close = c == '(' ? line_.find(')', at_) : std::string_view::npos;
      at_ = close == std::string_view::npos ? line_.size() : close + 1;
      add(TokenKind::kComment, begin);
    } else if (c == '#') {
      parameter();
    } else if (is_digit(c) || c == '.') {
      skip([](char d) { return is_digit(d) || d == '.'; });
      add(TokenKind::kNumber, begin);
      started_ = true;
    } else if (is_letter(c)) {
      letters();
    } else {
      if (c == '[') ++depth_;
      if (c == ']' && depth_ > 0) --depth_;
      at_ += c == '*' && peek(1) == '*' ? 2 : 1;
      if (std::string_view("+-*/=").find(c) != std::string_view::npos && (c != '/' || started_))
        add(TokenKind::kOperator, begin);
    }
  }

  void parameter() {
    const size_t begin = at_;
    while (peek() == '#') ++at_;
    skip(is_blank);
    if (peek() == '<') {
      const size_t close = line_.find('>', at_);
      at_ = close == std::string_view::npos ? line_.size() : close + 1;
    } else {
      skip(is_digit);
    }
    while (at_ > begin + 1 && is_blank(line_[at_ - 1])) --at_;
    add(TokenKind::kParameter, begin);
    started_ = true;
  }

  void letters() {
    const size_t begin = at_;
    const char c = static_cast<char>(peek() | 0x20);
    if (depth_ > 0) {
      skip(is_letter);
      const std::string word = small_letters(line_.substr(begin, at_ - begin));
      add(std::ranges::find(kWordOperators, word) != kWordOperators.end() ? TokenKind::kOperator : TokenKind::kFunction,
          begin);
      return;
    }
    if (c == 'o' && !started_) return o_word();
    ++at_;
    if (c == 'g' || c == 'm' || c == 'n') skip([](char d) { return is_digit(d) || d == '.' || is_blank(d); });
    while (at_ > begin + 1 && is_blank(line_[at_ - 1])) --at_;
    add(TokenKind::kWord, begin);
    if (c != 'n') started_ = true;
  }

  void o_word() {
    const size_t begin = at_++;
    started_ = true;
    skip(is_blank);
    if (peek() == '<') {
      const size_t close = line_.find('>', at_);
      at_ = close == std::string_view::npos ? line_.size() : close + 1;
    } else {
      skip([](char d) { return is_digit(d) || d == '.'; });
    }
    while (at_ > begin + 1 && is_blank(line_[at_ - 1])) --at_;
    add(TokenKind::kLabel, begin);
    if (peek() == '#' || peek() == '[') return;  // a computed label: the rest is an expression
    skip(is_blank);
    const size_t keyword = at_;
    skip([](char d) { return is_letter(d) || is_blank(d); });
    while (at_ > keyword && is_blank(line_[at_ - 1])) --at_;
    if (at_ > keyword) add(TokenKind::kKeyword, keyword);
  }

  std::string_view line_;
  size_t at_ = 0;
  size_t depth_ = 0;
  bool started_ = false;  // something other than a slash and a line number has come
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokenize(std::string_view line) { return Lexer(line).run(); }

}  // namespace owlint::lsp
