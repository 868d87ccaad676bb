#include "analyzer/syntax/word_reader.h"

#include <algorithm>

#include "analyzer/syntax/codes.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/text/characters.h"

namespace owlint {
namespace {

bool begins_literal(char c) { return is_digit(c) || c == '.' || c == '-' || c == '+'; }
bool begins_word_value(char c) { return begins_literal(c) || c == '[' || c == '#'; }

}  // namespace

WordReader::WordReader(std::string_view raw, uint64_t offset) {
  if (raw.size() > kLineLimit || text_.assign(raw, offset) != StopKind::kNone) {
    lost_ = true;
    return;
  }
  if (text_[0] == '/') ++at_;
  if (text_[at_] != 'n') return;
  do ++at_;
  while (is_digit(text_[at_]) || text_[at_] == '.');
}

/// Passes comments and settings. False at the line's end, and where a setting cannot be read.
bool WordReader::skip_to_word() {
  while (at_ < text_.size() && text_[at_] != ';') {
    if (text_[at_] == '(') {
      at_ = std::min(text_.text().find(')', at_), text_.size() - 1) + 1;
      continue;
    }
    if (text_[at_] != '#') return true;
    ExpressionParser in(text_, pool_, names_);
    in.cursor = at_ + 1;
    lost_ = in.parameter() == kNoExpr || text_[in.cursor++] != '=' || in.value() == kNoExpr;
    if (lost_) return false;
    at_ = in.cursor;
  }
  return false;
}

std::optional<WrittenWord> WordReader::next() {
  if (lost_ || !skip_to_word()) return std::nullopt;
  const size_t from = at_;
  if (word_row(text_[from]) == nullptr) {
    lost_ = true;
    return std::nullopt;
  }
  ExpressionParser in(text_, pool_, names_);
  in.cursor = from + 1;
  fault_ = StopKind::kNone;
  WrittenWord word{text_[from], std::nullopt, text_.span(from, from + 1)};
  const ExprId value = in.value();
  at_ = in.cursor;
  if (value == kNoExpr) {
    unread(in.error(), from, word);
    return word;
  }
  word.span = text_.span(from, at_);
  double number = 0;
  if (literal_value(pool_, value, &number)) word.value = number;
  return word;
}

/// Decides whether there may be words behind the one at `from`, whose value cannot be read. The cursor is behind what was taken
/// of it: in front of the next letter, or behind the digits and points.
void WordReader::unread(const ReadError& error, size_t from, WrittenWord& word) {
  const char first = text_[from + 1];
  message_ = error.message;
  fault_ = StopKind::kExpression;
  if (begins_literal(first)) {
    if (message_.starts_with("bad number")) {
      fault_ = StopKind::kNumberMalformed;
      word.span = text_.span(from, std::max(error.to, from + 1));
    }
  } else if (first != '[' && first != '#' && !is_foreign(first)) {
    // `XY5` are two words, and three letters are text.
    if (!is_small_letter(first) || begins_word_value(text_[from + 2])) fault_ = StopKind::kNumberMissing;
  }
  lost_ = fault_ == StopKind::kExpression;
}

}  // namespace owlint
