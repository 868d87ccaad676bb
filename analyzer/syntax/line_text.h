// One line as the interpreter sees it: without blanks, in lower case, with comments. Every character remembers its
// position in the file, so that a finding can point at the original text.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <string_view>

#include "analyzer/syntax/stop.h"
#include "analyzer/text/source.h"

namespace owlint {

/// The interpreter reads at most 252 characters and a line feed (measured; see OW309).
inline constexpr size_t kLineLimit = 252;

/// Whether a byte is part of a character that is not ASCII.
inline bool is_foreign(char c) { return static_cast<unsigned char>(c) >= 0x80 || c == '\v' || c == '\f'; }
/// How many of them stand at `at`.
inline size_t foreign_run(std::string_view text, size_t at) {
  size_t end = at;
  while (end < text.size() && is_foreign(text[end])) ++end;
  return end - at;
}

class LineText {
 public:
  /// Normalises one line. `raw` is the line without its line feed, `offset` where it begins in the file.
  /// Returns kNone, kCommentNested or kCommentUnclosed (then error() is the position).
  /// `raw` must not be longer than kLineLimit + 1.
  StopKind assign(std::string_view raw, uint64_t offset);

  std::string_view text() const { return {text_.data(), length_}; }
  size_t size() const { return length_; }
  /// The character `i`; at the size, after the last one, a NUL.
  char operator[](size_t i) const {
    assert(i <= length_);
    return text_[i];
  }

  /// File offset of the line's first byte.
  uint64_t begin() const { return offset_; }

  /// File offset of the normalised character `i`; if `i` is the size, of the end of the last character.
  uint64_t offset(size_t i) const { return offset_ + (i < length_ ? at_[i] : end_); }

  /// The file's bytes of the normalised characters [from, to). It never leaves the line: what is missing at the line's
  /// end is an empty span there.
  Span span(size_t from, size_t to) const {
    const size_t last = std::min(to, length_);
    return {offset(from), last > from ? offset(last - 1) + 1 : offset(from)};
  }

  Span error() const { return error_; }
  bool has_nul() const { return nul_; }
  bool has_comment() const { return comment_; }
  /// A carriage return with something after it.
  bool has_inner_cr() const { return inner_cr_; }

 private:
  StopKind comment(std::string_view raw, size_t* at);
  StopKind assign_slowly(std::string_view raw);
  StopKind assign_before_nul(std::string_view raw);
  void keep(char c, size_t at) {
    text_[length_] = c;
    at_[length_++] = static_cast<uint8_t>(at);
  }

  std::array<char, 256> text_;
  std::array<uint8_t, 256> at_;
  size_t length_ = 0;
  uint8_t end_ = 0;
  uint64_t offset_ = 0;
  Span error_;
  bool nul_ = false;
  bool comment_ = false;
  bool inner_cr_ = false;
};

}  // namespace owlint
