// Lines and positions as editors count them: lines end at \n, \r\n or a lone \r, from 0; characters count in the units
// that client and server have agreed on. Edits update it, so that a keystroke in a million lines is cheap.
// LSP 3.17, "Position" and "positionEncoding".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/text/source.h"

namespace owlint::lsp {

enum class Encoding : uint8_t { kUtf8, kUtf16, kUtf32 };

/// From 0, both.
struct EditorPosition {
  uint32_t line = 0;
  uint32_t character = 0;
};

class Lines {
 public:
  explicit Lines(std::string_view text);

  /// `text` is the text after bytes [from, to) were replaced by `inserted` bytes.
  void replaced(std::string_view text, size_t from, size_t to, size_t inserted);

  size_t count() const { return starts_.size(); }
  size_t start(size_t line) const { return starts_[line]; }
  /// Without its line end.
  Span line(std::string_view text, size_t line) const;
  size_t line_of(uint64_t offset) const;

  EditorPosition position(std::string_view text, uint64_t offset, Encoding encoding) const;
  /// A position past the end of a line or of the text becomes that end, as the protocol requires; a position inside a
  /// character becomes its beginning.
  uint64_t offset(std::string_view text, EditorPosition position, Encoding encoding) const;

 private:
  std::vector<size_t> starts_;
};

/// Length of `bytes` in the units of an encoding.
uint32_t units(std::string_view bytes, Encoding encoding);

}  // namespace owlint::lsp
