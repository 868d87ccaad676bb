// The words of plain lines (see bulk.h) as numbers, for those that need them: where lines move to, and whether arcs fit. A word
// is only made a number where it counts.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include "analyzer/syntax/bulk.h"
#include "analyzer/syntax/codes.h"

namespace owlint {

/// The number that begins there, a sign before it perhaps: the double next to what is written. `end`: of the bytes.
double plain_number(const char* at, const char* end);

struct PlainWords {
  uint32_t letters = 0;                       ///< but for G and N
  int8_t code = -1;                           ///< of G; -1 without one
  std::array<const char*, kLetters> texts{};  ///< where the number begins, by letter, where `letters` has it
  std::array<double, kLetters> values{};      ///< after convert()
  const char* end = nullptr;                  ///< of the bytes

  void convert(uint32_t which);
  bool has(char letter) const { return (letters & letter_set({&letter, 1})) != 0; }
  double operator[](char letter) const { return values[letter_index(letter)]; }
};

/// Finds the words of the plain line at `from`. Returns the offset of the next line.
size_t read_plain_words(std::string_view bytes, size_t from, PlainWords* words);

/// The same for lines that follow each other: vectors find the letters of many lines at once.
class PlainWordReader {
 public:
  explicit PlainWordReader(const ByteClassifier* by = &byte_classifiers().front()) : by_(by) {}
  /// `bytes`: the same each time.
  size_t read(std::string_view bytes, size_t from, PlainWords* words);

 private:
  void look(std::string_view bytes, size_t from);
  void seek(std::string_view bytes, size_t from);

  static constexpr size_t kBlocks = 16;

  const ByteClassifier* by_;
  size_t begin_ = 0;  // what is known begins there
  size_t block_ = 0;
  size_t blocks_ = 0;       // that are known
  size_t next_ = SIZE_MAX;  // the line behind the last one
  uint64_t left_ = 0;       // of the block, from there on
  std::array<uint64_t, kBlocks> looks_{};
};

/// Of an axis, by Axis, from its letter's index.
constexpr size_t axis_of_letter(size_t letter) {
  constexpr size_t kU = 'u' - 'a', kX = 'x' - 'a';
  constexpr size_t kFirstRotary = 3, kFirstFurther = 6;
  return letter >= kX ? letter - kX : letter >= kU ? letter - kU + kFirstFurther : letter + kFirstRotary;
}

/// How far plain lines go along each axis: the words of X, Y, Z, A, B and C.
struct PlainMoves {
  uint32_t letters = 0;                 ///< axes that move
  std::array<double, kLetters> last{};  ///< the last word: where the axis is in G90
  std::array<double, kLetters> sum{};   ///< of all words, in their order: how far it has gone in G91

  void add(size_t letter, double value) {
    letters |= 1U << letter;
    last[letter] = value;
    sum[letter] += value;
  }
};

/// The least and the greatest of some numbers, with their lines.
struct Extremes {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
  uint32_t least_line = 0, greatest_line = 0;

  void add(double number, uint32_t line) {
    if (number < least) {
      least = number;
      least_line = line;
    }
    if (number > greatest) {
      greatest = number;
      greatest_line = line;
    }
  }
  /// Those of other numbers, to which `by` is added.
  void add(const Extremes& other, double by = 0) {
    if (!(other.least <= other.greatest)) return;
    add(other.least + by, other.least_line);
    add(other.greatest + by, other.greatest_line);
  }
};

/// Where plain lines move to along each axis, by Axis.
struct PlainReach {
  static constexpr size_t kAxes = 9;

  uint32_t letters = 0;
  std::array<Extremes, kAxes> words;  ///< in G90
  std::array<Extremes, kAxes> sums;   ///< in G91, from where the lines begin

  /// `moves`: those up to the line, with it.
  void add(const PlainWords& line, const PlainMoves& moves, uint32_t number);
  /// Moves behind others, which go so far.
  void add(const PlainReach& other, const std::array<double, kAxes>& before);
};
/// The same by the rate.
struct PlainReaches {
  PlainReach rapid, feed;
  bool curves = false;  ///< some are arcs, which go further between their ends
};

/// Of the plain lines in [from, to).
PlainMoves plain_moves(std::string_view bytes, size_t from, size_t to, PlainWordReader* reader);
/// The last words of these axes alone; `last`: the lines that have them.
PlainMoves last_plain_moves(std::string_view bytes, uint32_t axes, const LastLines& last);

}  // namespace owlint
