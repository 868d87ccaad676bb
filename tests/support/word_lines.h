// Lines of words for tests, written as in a program with blanks between the words.
#pragma once

#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>

#include "analyzer/syntax/word_line.h"

namespace owlint::test {

inline const MachineWords kAlone;
inline const MachineWords kNewest{.release = Release::k2_10, .axes = letter_set("xyzabc"), .remapped = {}};
inline constexpr Modes kStart{Motion::kG80, Modes::kAbsolute, Modes::kG17};

constexpr Modes in(Motion motion) { return {motion, Modes::kAbsolute, Modes::kG17}; }

/// Reads words separated by blanks; `P?` has a value that is not known. The first certain fault, or the first one.
inline std::optional<Fault> read(WordLine& line, const std::string& text) {
  std::optional<Fault> possible;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const char letter = word[0] >= 'A' && word[0] <= 'Z' ? static_cast<char>(word[0] + 32) : word[0];
    auto fault = line.letter(letter);
    if (!fault || !fault->certain) {
      if (fault && !possible) possible = fault;
      fault = line.add({letter, word[1] != '?', std::strtod(word.c_str() + 1, nullptr), 0, 0});
    }
    if (fault) return fault;
  }
  return possible;
}

inline std::optional<Fault> fault_of(const std::string& text, const Modes& before = kStart,
                                     const MachineWords& machine = kAlone) {
  WordLine line(machine);
  auto fault = read(line, text);
  return fault && fault->certain ? fault : line.check(before);
}

/// The message the line certainly stops with; empty if it runs.
inline std::string stops(const std::string& text, const Modes& before = kStart, const MachineWords& machine = kAlone) {
  const auto fault = fault_of(text, before, machine);
  if (!fault) return "";
  return (fault->certain ? "" : "perhaps: ") + fault->message;
}

}  // namespace owlint::test
