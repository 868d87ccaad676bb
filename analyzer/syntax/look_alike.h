// Characters that look like those of a program and are others: a minus sign from a web page, a no-break space, a Cyrillic
// letter. (Of a library such as ICU this little would be used, and loading it takes longer than checking a program.)
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace owlint {

struct Character {
  char32_t code = 0;
  size_t length = 0;  ///< in bytes
};

/// The character that `text`, which is not empty, begins with: UTF-8, or else a byte as Windows and Latin-1 have it.
Character character_at(std::string_view text);

struct LookAlike {
  std::string name;   ///< its Unicode name, `MINUS SIGN`
  std::string plain;  ///< what it looks like: `-`; a blank; empty where nothing is seen
};

/// What a character looks like; nothing where it looks like no other.
std::optional<LookAlike> look_alike(char32_t code);

/// The text with the characters in place of those that only look like them.
std::string plain_text(std::string_view text);

}  // namespace owlint
