#include "analyzer/text/printable.h"

#include <algorithm>

#include <fmt/format.h>

#include "analyzer/text/source.h"

namespace owlint {

namespace {

std::string converted(std::string_view bytes, bool controls) {
  std::string out;
  for (size_t at = 0; at < bytes.size();) {
    const auto byte = static_cast<unsigned char>(bytes[at]);
    size_t length = 1;
    if (byte >= 0xC2) {
      // A valid sequence is one code point for count_code_points; anything else is single bytes.
      while (length < 4 && at + length < bytes.size() &&
             (static_cast<unsigned char>(bytes[at + length]) & 0xC0) == 0x80)
        ++length;
      const size_t wanted = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
      length = length >= wanted && byte < 0xF5 ? wanted : 1;
      const auto second = at + 1 < bytes.size() ? static_cast<unsigned char>(bytes[at + 1]) : 0;
      // Overlong forms, surrogates and code points beyond the last one are not UTF-8.
      if ((byte == 0xE0 && second < 0xA0) || (byte == 0xED && second > 0x9F) || (byte == 0xF0 && second < 0x90) ||
          (byte == 0xF4 && second > 0x8F)) {
        length = 1;
      }
    }
    if (length > 1) {
      out += bytes.substr(at, length);
    } else if (byte >= 0x80) {
      out += static_cast<char>(0xC0 | byte >> 6);
      out += static_cast<char>(0x80 | (byte & 0x3F));
    } else if (!controls && ((byte < 0x20 && byte != '\t') || byte == 0x7F)) {
      out += "\xEF\xBF\xBD";
    } else {
      out += static_cast<char>(byte);
    }
    at += length;
  }
  return out;
}

}  // namespace

std::string printable(std::string_view bytes) { return converted(bytes, false); }

std::string as_utf8(std::string_view bytes) { return converted(bytes, true); }

std::string printable_text(std::string_view bytes) {
  std::string out;
  for (size_t at = 0; at < bytes.size();) {
    const size_t kept = std::min(bytes.find_first_of("\r\n\t", at), bytes.size());
    out += printable(bytes.substr(at, kept - at));
    if (kept < bytes.size()) out += bytes[kept];
    at = kept + 1;
  }
  return out;
}

std::string percent_encoded(std::string_view path) {
  constexpr std::string_view kPlain = "/-._~";
  std::string out;
  for (const char c : path) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (letter || kPlain.find(c) != std::string_view::npos) {
      out.push_back(c);
    } else {
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return out;
}

}  // namespace owlint
