// Kinds of bytes, in ASCII whatever the locale.
#pragma once

namespace owlint {

constexpr bool is_digit(char c) { return static_cast<unsigned char>(c - '0') <= 9; }
constexpr bool is_small_letter(char c) { return c >= 'a' && c <= 'z'; }
constexpr bool is_letter(char c) { return is_small_letter(c) || (c >= 'A' && c <= 'Z'); }
/// Between the words of a line.
constexpr bool is_space_or_tab(char c) { return c == ' ' || c == '\t'; }
/// The same, and the carriage return before a line feed.
constexpr bool is_blank(char c) { return is_space_or_tab(c) || c == '\r'; }

}  // namespace owlint
