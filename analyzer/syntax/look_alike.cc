#include "analyzer/syntax/look_alike.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace owlint {
namespace {

struct KnownCharacter {
  char32_t code;
  std::string_view name;
  std::string_view plain;
};

// By code. Of full-width characters only the names are put together.
constexpr KnownCharacter kCharacters[] = {
    {0x000B, "VERTICAL TAB", " "},
    {0x000C, "FORM FEED", " "},
    {0x00A0, "NO-BREAK SPACE", " "},
    {0x00AB, "LEFT-POINTING DOUBLE ANGLE QUOTATION MARK", "\""},
    {0x00AD, "SOFT HYPHEN", ""},
    {0x00B7, "MIDDLE DOT", "."},
    {0x00BB, "RIGHT-POINTING DOUBLE ANGLE QUOTATION MARK", "\""},
    {0x00D7, "MULTIPLICATION SIGN", "*"},
    {0x00F7, "DIVISION SIGN", "/"},
    {0x0391, "GREEK CAPITAL LETTER ALPHA", "A"},
    {0x0392, "GREEK CAPITAL LETTER BETA", "B"},
    {0x0395, "GREEK CAPITAL LETTER EPSILON", "E"},
    {0x0396, "GREEK CAPITAL LETTER ZETA", "Z"},
    {0x0397, "GREEK CAPITAL LETTER ETA", "H"},
    {0x0399, "GREEK CAPITAL LETTER IOTA", "I"},
    {0x039A, "GREEK CAPITAL LETTER KAPPA", "K"},
    {0x039C, "GREEK CAPITAL LETTER MU", "M"},
    {0x039D, "GREEK CAPITAL LETTER NU", "N"},
    {0x039F, "GREEK CAPITAL LETTER OMICRON", "O"},
    {0x03A1, "GREEK CAPITAL LETTER RHO", "P"},
    {0x03A4, "GREEK CAPITAL LETTER TAU", "T"},
    {0x03A5, "GREEK CAPITAL LETTER UPSILON", "Y"},
    {0x03A7, "GREEK CAPITAL LETTER CHI", "X"},
    {0x03B1, "GREEK SMALL LETTER ALPHA", "a"},
    {0x03B9, "GREEK SMALL LETTER IOTA", "i"},
    {0x03BA, "GREEK SMALL LETTER KAPPA", "k"},
    {0x03BD, "GREEK SMALL LETTER NU", "v"},
    {0x03BF, "GREEK SMALL LETTER OMICRON", "o"},
    {0x03C1, "GREEK SMALL LETTER RHO", "p"},
    {0x03C5, "GREEK SMALL LETTER UPSILON", "u"},
    {0x0405, "CYRILLIC CAPITAL LETTER DZE", "S"},
    {0x0406, "CYRILLIC CAPITAL LETTER BYELORUSSIAN-UKRAINIAN I", "I"},
    {0x0408, "CYRILLIC CAPITAL LETTER JE", "J"},
    {0x0410, "CYRILLIC CAPITAL LETTER A", "A"},
    {0x0412, "CYRILLIC CAPITAL LETTER VE", "B"},
    {0x0415, "CYRILLIC CAPITAL LETTER IE", "E"},
    {0x0417, "CYRILLIC CAPITAL LETTER ZE", "3"},
    {0x041A, "CYRILLIC CAPITAL LETTER KA", "K"},
    {0x041C, "CYRILLIC CAPITAL LETTER EM", "M"},
    {0x041D, "CYRILLIC CAPITAL LETTER EN", "H"},
    {0x041E, "CYRILLIC CAPITAL LETTER O", "O"},
    {0x0420, "CYRILLIC CAPITAL LETTER ER", "P"},
    {0x0421, "CYRILLIC CAPITAL LETTER ES", "C"},
    {0x0422, "CYRILLIC CAPITAL LETTER TE", "T"},
    {0x0423, "CYRILLIC CAPITAL LETTER U", "Y"},
    {0x0425, "CYRILLIC CAPITAL LETTER HA", "X"},
    {0x0430, "CYRILLIC SMALL LETTER A", "a"},
    {0x0431, "CYRILLIC SMALL LETTER BE", "6"},
    {0x0435, "CYRILLIC SMALL LETTER IE", "e"},
    {0x043E, "CYRILLIC SMALL LETTER O", "o"},
    {0x0440, "CYRILLIC SMALL LETTER ER", "p"},
    {0x0441, "CYRILLIC SMALL LETTER ES", "c"},
    {0x0443, "CYRILLIC SMALL LETTER U", "y"},
    {0x0445, "CYRILLIC SMALL LETTER HA", "x"},
    {0x0455, "CYRILLIC SMALL LETTER DZE", "s"},
    {0x0456, "CYRILLIC SMALL LETTER BYELORUSSIAN-UKRAINIAN I", "i"},
    {0x0458, "CYRILLIC SMALL LETTER JE", "j"},
    {0x0474, "CYRILLIC CAPITAL LETTER IZHITSA", "V"},
    {0x04BB, "CYRILLIC SMALL LETTER SHHA", "h"},
    {0x04C0, "CYRILLIC LETTER PALOCHKA", "I"},
    {0x04CF, "CYRILLIC SMALL LETTER PALOCHKA", "l"},
    {0x050C, "CYRILLIC CAPITAL LETTER KOMI SJE", "G"},
    {0x051B, "CYRILLIC SMALL LETTER QA", "q"},
    {0x051D, "CYRILLIC SMALL LETTER WE", "w"},
    {0x066B, "ARABIC DECIMAL SEPARATOR", "."},
    {0x1680, "OGHAM SPACE MARK", " "},
    {0x2000, "EN QUAD", " "},
    {0x2001, "EM QUAD", " "},
    {0x2002, "EN SPACE", " "},
    {0x2003, "EM SPACE", " "},
    {0x2004, "THREE-PER-EM SPACE", " "},
    {0x2005, "FOUR-PER-EM SPACE", " "},
    {0x2006, "SIX-PER-EM SPACE", " "},
    {0x2007, "FIGURE SPACE", " "},
    {0x2008, "PUNCTUATION SPACE", " "},
    {0x2009, "THIN SPACE", " "},
    {0x200A, "HAIR SPACE", " "},
    {0x200B, "ZERO WIDTH SPACE", ""},
    {0x200C, "ZERO WIDTH NON-JOINER", ""},
    {0x200D, "ZERO WIDTH JOINER", ""},
    {0x200E, "LEFT-TO-RIGHT MARK", ""},
    {0x200F, "RIGHT-TO-LEFT MARK", ""},
    {0x2010, "HYPHEN", "-"},
    {0x2011, "NON-BREAKING HYPHEN", "-"},
    {0x2012, "FIGURE DASH", "-"},
    {0x2013, "EN DASH", "-"},
    {0x2014, "EM DASH", "-"},
    {0x2015, "HORIZONTAL BAR", "-"},
    {0x2018, "LEFT SINGLE QUOTATION MARK", "'"},
    {0x2019, "RIGHT SINGLE QUOTATION MARK", "'"},
    {0x201A, "SINGLE LOW-9 QUOTATION MARK", ","},
    {0x201B, "SINGLE HIGH-REVERSED-9 QUOTATION MARK", "'"},
    {0x201C, "LEFT DOUBLE QUOTATION MARK", "\""},
    {0x201D, "RIGHT DOUBLE QUOTATION MARK", "\""},
    {0x201E, "DOUBLE LOW-9 QUOTATION MARK", "\""},
    {0x201F, "DOUBLE HIGH-REVERSED-9 QUOTATION MARK", "\""},
    {0x2024, "ONE DOT LEADER", "."},
    {0x202A, "LEFT-TO-RIGHT EMBEDDING", ""},
    {0x202B, "RIGHT-TO-LEFT EMBEDDING", ""},
    {0x202C, "POP DIRECTIONAL FORMATTING", ""},
    {0x202D, "LEFT-TO-RIGHT OVERRIDE", ""},
    {0x202E, "RIGHT-TO-LEFT OVERRIDE", ""},
    {0x202F, "NARROW NO-BREAK SPACE", " "},
    {0x2032, "PRIME", "'"},
    {0x2033, "DOUBLE PRIME", "\""},
    {0x2039, "SINGLE LEFT-POINTING ANGLE QUOTATION MARK", "<"},
    {0x203A, "SINGLE RIGHT-POINTING ANGLE QUOTATION MARK", ">"},
    {0x2044, "FRACTION SLASH", "/"},
    {0x205F, "MEDIUM MATHEMATICAL SPACE", " "},
    {0x2060, "WORD JOINER", ""},
    {0x2066, "LEFT-TO-RIGHT ISOLATE", ""},
    {0x2067, "RIGHT-TO-LEFT ISOLATE", ""},
    {0x2068, "FIRST STRONG ISOLATE", ""},
    {0x2069, "POP DIRECTIONAL ISOLATE", ""},
    {0x2212, "MINUS SIGN", "-"},
    {0x2215, "DIVISION SLASH", "/"},
    {0x2217, "ASTERISK OPERATOR", "*"},
    {0x2260, "NOT EQUAL TO", " NE "},
    {0x2264, "LESS-THAN OR EQUAL TO", " LE "},
    {0x2265, "GREATER-THAN OR EQUAL TO", " GE "},
    {0x22C5, "DOT OPERATOR", "*"},
    {0x2329, "LEFT-POINTING ANGLE BRACKET", "<"},
    {0x232A, "RIGHT-POINTING ANGLE BRACKET", ">"},
    {0x27E8, "MATHEMATICAL LEFT ANGLE BRACKET", "<"},
    {0x27E9, "MATHEMATICAL RIGHT ANGLE BRACKET", ">"},
    {0x3000, "IDEOGRAPHIC SPACE", " "},
    {0x3008, "LEFT ANGLE BRACKET", "<"},
    {0x3009, "RIGHT ANGLE BRACKET", ">"},
    {0x3010, "LEFT BLACK LENTICULAR BRACKET", "["},
    {0x3011, "RIGHT BLACK LENTICULAR BRACKET", "]"},
    {0xFE58, "SMALL EM DASH", "-"},
    {0xFE63, "SMALL HYPHEN-MINUS", "-"},
    {0xFEFF, "ZERO WIDTH NO-BREAK SPACE", ""},
};

// What Windows programs write for typographic characters, where UTF-8 cannot be meant.
constexpr std::array<char32_t, 32> kWindows = {0x20AC, 0x81,   0x201A, 0x192,  0x201E, 0x2026, 0x2020, 0x2021,
                                               0x2C6,  0x2030, 0x160,  0x2039, 0x152,  0x8D,   0x17D,  0x8F,
                                               0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                               0x2DC,  0x2122, 0x161,  0x203A, 0x153,  0x9D,   0x17E,  0x178};

constexpr char32_t kFullWidthFirst = 0xFF01;
constexpr char32_t kFullWidthLast = 0xFF5E;
constexpr char32_t kFullWidthFromAscii = 0xFEE0;

std::string full_width_name(char32_t code) {
  const char c = static_cast<char>(code - kFullWidthFromAscii);
  if (c >= '0' && c <= '9') return fmt::format("FULLWIDTH DIGIT {}", c);
  if (c >= 'A' && c <= 'Z') return fmt::format("FULLWIDTH LATIN CAPITAL LETTER {}", c);
  if (c >= 'a' && c <= 'z') return fmt::format("FULLWIDTH LATIN SMALL LETTER {}", static_cast<char>(c - ('a' - 'A')));
  return fmt::format("FULLWIDTH {}", c);
}

}  // namespace

Character character_at(std::string_view text) {
  const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto follows = [&](size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  Character c{static_cast<char32_t>(first), 1};
  if (first >= 0xF0 && first < 0xF5 && follows(1) && follows(2) && follows(3)) {
    c = {(first & 7U) << 18 | (byte(1) & 0x3FU) << 12 | (byte(2) & 0x3FU) << 6 | (byte(3) & 0x3FU), 4};
  } else if (first >= 0xE0 && first < 0xF0 && follows(1) && follows(2)) {
    c = {(first & 15U) << 12 | (byte(1) & 0x3FU) << 6 | (byte(2) & 0x3FU), 3};
  } else if (first >= 0xC2 && first < 0xE0 && follows(1)) {
    c = {(first & 31U) << 6 | (byte(1) & 0x3FU), 2};
  } else if (first >= 0x80 && first < 0xA0) {
    c.code = kWindows[first - 0x80];
  }
  return c;
}

std::optional<LookAlike> look_alike(char32_t code) {
  if (code >= kFullWidthFirst && code <= kFullWidthLast)
    return LookAlike{full_width_name(code), std::string(1, static_cast<char>(code - kFullWidthFromAscii))};
  const KnownCharacter* row = std::ranges::lower_bound(kCharacters, code, {}, &KnownCharacter::code);
  if (row == std::end(kCharacters) || row->code != code) return std::nullopt;
  return LookAlike{std::string(row->name), std::string(row->plain)};
}

std::string plain_text(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const Character c = character_at(text);
    const auto same = c.code < 0x80 ? std::nullopt : look_alike(c.code);
    out += same ? same->plain : std::string(text.substr(0, c.length));
    text.remove_prefix(c.length);
  }
  return out;
}

}  // namespace owlint
