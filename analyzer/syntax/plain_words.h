// The words of plain lines (see bulk.h) as numbers, for those that need them: where lines move to, and whether arcs fit.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "analyzer/syntax/codes.h"

namespace owlint {

struct PlainWords {
  uint32_t letters = 0;                   ///< but for G
  int8_t code = -1;                       ///< of G; -1 without one
  std::array<double, kLetters> values{};  ///< by letter, where `letters` has it

  bool has(char letter) const { return (letters & letter_set({&letter, 1})) != 0; }
  double operator[](char letter) const { return values[letter_index(letter)]; }
};

/// Reads the plain line at `from`. Returns the offset of the next line.
size_t read_plain_words(std::string_view bytes, size_t from, PlainWords* words);

/// How far plain lines go along each axis: the words of X, Y, Z, A, B and C.
struct PlainMoves {
  uint32_t letters = 0;                 ///< axes that move
  std::array<double, kLetters> last{};  ///< the last word: where the axis is in G90
  std::array<double, kLetters> sum{};   ///< of all words, in their order: how far it has gone in G91

  void add(const PlainWords& words);
};
/// Of the plain lines in [from, to), which move these axes. Without `sums` only the last words are looked for, from the end on.
PlainMoves plain_moves(std::string_view bytes, size_t from, size_t to, uint32_t axes, bool sums);

}  // namespace owlint
