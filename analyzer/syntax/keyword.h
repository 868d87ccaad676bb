// The words that may follow an O-label, in the order in which LinuxCNC tries them.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace owlint {

enum class Keyword : uint8_t {
  kSub,
  kEndsub,
  kCall,
  kDo,
  kWhile,
  kRepeat,
  kIf,
  kElseif,
  kElse,
  kEndif,
  kBreak,
  kContinue,
  kEndwhile,
  kEndrepeat,
  kReturn,
  kBare,     // `O100` alone: a Fanuc-style program number
  kUnknown,  // anything else: the interpreter stops
};

/// Spellings in the interpreter's order; a keyword is recognised as a prefix, so the order decides
/// (`elseif` before `else`; `dogs` is `do` followed by text).
inline constexpr std::array<std::string_view, 15> kKeywordSpellings = {
    "sub",  "endsub", "call",  "do",       "while",    "repeat",    "if",    "elseif",
    "else", "endif",  "break", "continue", "endwhile", "endrepeat", "return"};

inline std::string_view spelling(Keyword keyword) {
  const auto index = static_cast<size_t>(keyword);
  return index < kKeywordSpellings.size() ? kKeywordSpellings[index] : std::string_view{};
}

/// The keyword that `text`, in small letters, begins with; kUnknown if none.
inline Keyword keyword_of(std::string_view text) {
  const auto first_of = [text](std::initializer_list<Keyword> keywords) {
    for (const Keyword k : keywords) {
      if (text.starts_with(spelling(k))) return k;
    }
    return Keyword::kUnknown;
  };
  switch (text.empty() ? '\0' : text[0]) {
    case 'b': return first_of({Keyword::kBreak});
    case 'c': return first_of({Keyword::kCall, Keyword::kContinue});
    case 'd': return first_of({Keyword::kDo});
    case 'e':
      return first_of({Keyword::kEndsub, Keyword::kElseif, Keyword::kElse, Keyword::kEndif, Keyword::kEndwhile,
                       Keyword::kEndrepeat});
    case 'i': return first_of({Keyword::kIf});
    case 'r': return first_of({Keyword::kRepeat, Keyword::kReturn});
    case 's': return first_of({Keyword::kSub});
    case 'w': return first_of({Keyword::kWhile});
    default: return Keyword::kUnknown;
  }
}

/// `if`, `while`, `do`, `repeat`: opens a block. (`while` may also close a `do`.)
inline bool opens_block(Keyword k) {
  return k == Keyword::kIf || k == Keyword::kWhile || k == Keyword::kDo || k == Keyword::kRepeat;
}

/// `endif`, `endwhile`, `endrepeat`.
inline bool ends_block(Keyword k) {
  return k == Keyword::kEndif || k == Keyword::kEndwhile || k == Keyword::kEndrepeat;
}

/// Labels of `sub`, `endsub`, `call`, `return` and bare `O` share one name space; all others are local to a sub.
inline bool global_label(Keyword k) {
  return k == Keyword::kSub || k == Keyword::kEndsub || k == Keyword::kCall || k == Keyword::kReturn ||
      k == Keyword::kBare;
}

/// The keyword that closes a block opened by `k`.
inline Keyword end_of(Keyword k) {
  switch (k) {
    case Keyword::kIf: return Keyword::kEndif;
    case Keyword::kWhile: return Keyword::kEndwhile;
    case Keyword::kDo: return Keyword::kWhile;
    case Keyword::kRepeat: return Keyword::kEndrepeat;
    case Keyword::kSub: return Keyword::kEndsub;
    default: return Keyword::kUnknown;
  }
}

/// The keyword that opens a block closed by `k`.
inline Keyword opener_of(Keyword k) {
  switch (k) {
    case Keyword::kEndif:
    case Keyword::kElse:
    case Keyword::kElseif: return Keyword::kIf;
    case Keyword::kEndwhile: return Keyword::kWhile;
    case Keyword::kEndrepeat: return Keyword::kRepeat;
    case Keyword::kEndsub: return Keyword::kSub;
    default: return Keyword::kUnknown;
  }
}

}  // namespace owlint
