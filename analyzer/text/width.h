// How wide text is in a terminal, and where its lines break.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace owlint {

/// What is shown as one character, at the beginning of some text: a letter with its accents, an emoji of several code points.
struct Character {
  size_t bytes = 0;
  size_t columns = 0;  ///< 0, 1 or 2
};

/// The first character of UTF-8 text that is not empty.
Character first_character(std::string_view text);

/// The columns of UTF-8 text without tabs. Sequences that switch colours take none.
size_t columns(std::string_view text);

/// Breaks a text at blanks, so that no line is wider than `width` where a word is not. Each further line begins with `indent`;
/// `used` columns of the first one are taken. Width 0 is a line without end.
std::string wrapped(std::string_view text, size_t width, std::string_view indent, size_t used = 0);

}  // namespace owlint
