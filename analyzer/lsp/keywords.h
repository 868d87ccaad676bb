// What each O-word does, in a sentence, for hover and completion.
#pragma once

#include <string_view>

#include "analyzer/syntax/keyword.h"

namespace owlint::lsp {

inline std::string_view meaning(Keyword keyword) {
  switch (keyword) {
    case Keyword::kSub: return "begins the definition of a sub; the program passes over it to its `endsub`";
    case Keyword::kEndsub: return "ends the definition of a sub, and returns from it where it is called";
    case Keyword::kCall: return "calls a sub: of this program, or the file of that name; arguments in brackets become #1, #2 …";
    case Keyword::kDo: return "begins a loop that is run at least once; `while` with the same label ends it";
    case Keyword::kWhile: return "runs its lines as long as the condition is true; behind a `do` it ends that loop";
    case Keyword::kRepeat: return "runs its lines as often as its number says";
    case Keyword::kIf: return "runs its lines if the condition is true, that is not 0";
    case Keyword::kElseif: return "runs its lines if no branch before was taken and its condition is true";
    case Keyword::kElse: return "runs its lines if no branch before was taken";
    case Keyword::kEndif: return "ends the `if` with this label";
    case Keyword::kBreak: return "leaves the loop with this label";
    case Keyword::kContinue: return "goes on with the next pass of the loop with this label";
    case Keyword::kEndwhile: return "ends the `while` with this label: back to its condition";
    case Keyword::kEndrepeat: return "ends the `repeat` with this label: its next pass";
    case Keyword::kReturn: return "returns from the running sub; a value in brackets is then in `#<_value>`";
    case Keyword::kBare: return "a program number: the Fanuc-style beginning of a sub that M98 calls";
    case Keyword::kUnknown: break;
  }
  return "not a word that LinuxCNC knows: it stops here";
}

}  // namespace owlint::lsp
