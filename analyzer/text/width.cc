#include "analyzer/text/width.h"

#include <algorithm>

#include <utf8proc.h>

namespace owlint {
namespace {

constexpr utf8proc_int32_t kEmojiStyle = 0xFE0F;  // behind a character that has a wide form, too
constexpr std::string_view kEscape = "\x1b[";

/// The bytes of a code point, which is put into `point`.
size_t next_point(std::string_view text, utf8proc_int32_t* point) {
  const auto length = utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                                       static_cast<utf8proc_ssize_t>(text.size()), point);
  return length > 0 ? static_cast<size_t>(length) : 1;
}

}  // namespace

Character first_character(std::string_view text) {
  Character character;
  utf8proc_int32_t last = 0;
  utf8proc_int32_t state = 0;
  while (character.bytes < text.size()) {
    utf8proc_int32_t point = -1;
    const size_t length = next_point(text.substr(character.bytes), &point);
    if (point < 0) return character.bytes > 0 ? character : Character{length, 1};
    if (character.bytes > 0 && utf8proc_grapheme_break_stateful(last, point, &state)) break;
    character.bytes += length;
    character.columns = point == kEmojiStyle
        ? 2
        : std::min<size_t>(2, character.columns + static_cast<size_t>(utf8proc_charwidth(point)));
    last = point;
  }
  return character;
}

size_t columns(std::string_view text) {
  size_t sum = 0;
  while (!text.empty()) {
    if (text.starts_with(kEscape)) {
      text.remove_prefix(std::min(text.find('m'), text.size() - 1) + 1);
      continue;
    }
    const auto byte = static_cast<unsigned char>(text[0]);
    const auto next = static_cast<unsigned char>(text.size() > 1 ? text[1] : 0);
    const Character character = byte < 0x80 && next < 0x80 ? Character{1, 1} : first_character(text);
    sum += character.columns;
    text.remove_prefix(character.bytes);
  }
  return sum;
}

std::string wrapped(std::string_view text, size_t width, std::string_view indent, size_t used) {
  if (width == 0) return std::string(text);
  std::string out;
  size_t at = used;
  bool first = true;  // on its line
  while (!text.empty()) {
    const size_t blank = text.find(' ');
    const std::string_view word = text.substr(0, blank);
    const size_t wide = columns(word);
    if (!first && at + 1 + wide > width) {
      (out += '\n') += indent;
      at = columns(indent);
    } else if (!first) {
      out += ' ';
      ++at;
    }
    out += word;
    at += wide;
    first = false;
    text = blank == std::string_view::npos ? std::string_view() : text.substr(blank + 1);
  }
  return out;
}

}  // namespace owlint
