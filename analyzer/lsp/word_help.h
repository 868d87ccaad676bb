// Help for lines of words: hover.cc asks for what a word is, completion.cc for codes that can be written. It comes from the
// table of codes, and from the machine's INI.
#pragma once

#include <optional>
#include <string>

#include "analyzer/lsp/document.h"
#include "analyzer/machine/profile.h"

namespace owlint::lsp {

struct WordHelp {
  std::string text;  ///< Markdown
  Span span;         ///< the word
};

/// What the word at an offset is; nothing where no word of such a line is.
std::optional<WordHelp> word_help(const Document& document, const Profile& profile, uint64_t offset);
/// What a code is; empty if there is no such code, also none of the machine. `letter`: `g` or `m`; G codes in tenths.
std::string code_help(char letter, int number, const Profile& profile);

/// The codes that fit where a G or M, perhaps with the first digits of its number, has just been written; else none.
Json code_completion(const Document& document, const Profile& profile, uint64_t offset);

}  // namespace owlint::lsp
