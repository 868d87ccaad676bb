// The words of one line as they are written, for whoever comes back to a line that has been read: the rules, and the search
// for further mistakes. It goes on behind a word whose number cannot be read.
#pragma once

#include <optional>
#include <string_view>

#include "analyzer/syntax/expression.h"

namespace owlint {

/// A word as it is written.
struct WrittenWord {
  char letter = 0;              ///< small
  std::optional<double> value;  ///< if it is a number, or computed from numbers alone
  Span span;
};

class WordReader {
 public:
  /// `raw`: the line without its line feed, which begins at `offset`.
  WordReader(std::string_view raw, uint64_t offset);

  /// The next word, behind comments and settings; nothing at the line's end, and where it cannot be read on.
  std::optional<WrittenWord> next();
  /// Why the value of the last word could not be read: kNumberMissing, kNumberMalformed, or kExpression for all else. kNone if it
  /// was read.
  StopKind fault() const { return fault_; }
  /// The interpreter's message for that.
  const std::string& message() const { return message_; }
  /// Whether next() has ended before the line's end.
  bool lost() const { return lost_; }
  uint64_t line_begin() const { return text_.begin(); }

 private:
  bool skip_to_word();
  void unread(const ReadError& error, size_t from, WrittenWord& word);

  LineText text_;
  ExprPool pool_;
  Names names_;
  size_t at_ = 0;
  StopKind fault_ = StopKind::kNone;
  std::string message_;
  bool lost_ = false;
};

}  // namespace owlint
