// What each O-word does, in one sentence, for hover and completion.
#pragma once

#include <string_view>

#include "analyzer/syntax/keyword.h"

namespace owlint::lsp {

inline std::string_view meaning(Keyword keyword) {
  switch (keyword) {
    case Keyword::kSub: return "begins a sub; the program skips it up to its `endsub`";
    case Keyword::kEndsub: return "ends a sub; a call returns here";
    case Keyword::kCall:
      return "calls a sub of this program, or the file of that name; arguments in brackets become #1, #2 …";
    case Keyword::kDo: return "begins a loop that runs at least once; `while` with the same label ends it";
    case Keyword::kWhile:
      return "runs its lines while the condition is true; after a `do` with the same label it ends that loop";
    case Keyword::kRepeat: return "runs its lines as many times as its number says";
    case Keyword::kIf: return "runs its lines if the condition is true (not 0)";
    case Keyword::kElseif: return "runs its lines if no branch before it has run and its condition is true";
    case Keyword::kElse: return "runs its lines if no branch before it has run";
    case Keyword::kEndif: return "ends the `if` with this label";
    case Keyword::kBreak: return "leaves the loop with this label";
    case Keyword::kContinue: return "begins the next pass of the loop with this label";
    case Keyword::kEndwhile: return "ends the `while` with this label, and goes back to its condition";
    case Keyword::kEndrepeat: return "ends the `repeat` with this label, and begins its next pass";
    case Keyword::kReturn: return "returns from the running sub; a value in brackets is then in `#<_value>`";
    case Keyword::kBare: return "a program number: begins a Fanuc-style sub, which M98 calls";
    case Keyword::kUnknown: break;
  }
  return "not a word that LinuxCNC knows; it stops here";
}

}  // namespace owlint::lsp
