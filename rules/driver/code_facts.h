// What is said of a code or word, taken from the table that lines are read by: docs/codes.md, and hover and completion in
// editors say it in the same words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analyzer/machine/profile.h"
#include "analyzer/syntax/codes.h"

namespace owlint::rules {

/// `2.10`; empty for what all releases have.
std::string_view since_text(Release since);
/// `motion`, `this line only`.
std::string_view group_text(GGroup group);
std::string_view group_text(MGroup group);
/// `whole, decimals are cut off`.
std::string_view number_text(NumberKind kind);
/// What a second word with the letter does on a line.
std::string_view twice_text(const WordRow& word);

/// `axes`, `I`, `D (2.10)`: the words that a code takes, those of later releases last. Without F, S and T, which stand with
/// any code.
std::vector<std::string> words_taken(const GCode& code);
std::vector<std::string> words_taken(const MCode& code);
/// `an axis`, `K`.
std::vector<std::string> words_needed(const GCode& code);
/// Words that may not stand with the code: `F`.
std::vector<std::string> words_refused(const GCode& code);

/// The codes that take a word in a release; for an axis, those that are no motion. `letter`: a small one.
CodeSet codes_taking(char letter, Release release);
/// The codes that need one of just this letter.
CodeSet codes_needing(char letter, Release release);

/// M100 to M199: `M110 runs a program of the machine named M110, and this machine has none`.
std::string user_code_text(int number, const MachineSetup* setup);

}  // namespace owlint::rules
