// A line of plain motion: which words it has, and whether it surely runs. Used by bulk.cc, which reads most of them by the
// bits of their bytes and only the others by read_plain_line().
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "analyzer/syntax/codes.h"

namespace owlint {

/// Which plain lines surely run. What a line needs of the modes is known from lines before it: where a line has run and nothing
/// has changed a mode since, another one with the same words runs too.
struct Proven {
  static constexpr int8_t kNoCode = -1;

  int8_t code = kNoCode;  ///< G0 to G3, if one of these is in effect
  // Each without F on the line, then with it.
  uint8_t straight[2] = {0, 0};  ///< G0 is bit 0, G1 bit 1
  uint8_t arcs[2] = {0, 0};      ///< by the set of I, J and K
  uint32_t rotary = 0;           ///< letters of A, B and C that have been there
  uint8_t alone[2] = {0, 0};     ///< by the set of X, Y and Z, where the motion in effect is not known

  /// While kUsualModes are as an interpreter starts: G0, and G1 with a feed.
  static Proven usual() {
    Proven proven;
    proven.straight[0] = 1;
    proven.straight[1] = 3;
    return proven;
  }

  bool operator==(const Proven&) const = default;
};

/// What plain lines set, and need of the modes.
struct PlainEffect {
  Motion motion = Motion::kNone;  ///< that of the last G0, G1, G2 or G3
  uint32_t axes = 0;              ///< letters of axis words
  bool feed = false;              ///< a feed that is not 0
  bool speed = false;
  bool moves = false;
  bool alone = false;       ///< one of them moves by a motion that is not known
  bool feeds = false;       ///< one of them is no G0
  bool straight = false;    ///< one of them is a G0 or G1
  uint32_t first_move = 0;  ///< the first line with an axis word, from 1; 0: none
  uint32_t first_arc = 0;   ///< and the first G2 or G3

  bool operator==(const PlainEffect&) const = default;
};

/// The words of a plain line.
class PlainLine {
 public:
  /// Letters that a plain line may have, but for N.
  static constexpr uint32_t kAxes = letter_set("xyzabc");
  static constexpr uint32_t kMoveLetters = kAxes | letter_set("ijkrg");
  static constexpr uint32_t kLetters = kMoveLetters | letter_set("fs");

  /// What is on it besides blanks.
  enum Text : uint8_t { kNothing, kComment, kCode };

  PlainLine() = default;
  /// `words`: its letters but for N; `code`: of G, if it is there.
  PlainLine(uint32_t words, uint8_t code, Text text) : words_(words), code_(code), text_(text) {}

  /// Whether the line surely runs. Then what it does is added to `proven` and `effect`; `number`: of the line.
  bool runs(uint32_t number, Proven* proven, PlainEffect* effect) const;
  /// The line has run, for all that is known: so will others like it.
  void learn(Proven* proven) const;

  uint32_t words() const { return words_; }
  uint8_t code() const { return code_; }
  bool has_g() const { return (words_ & letter_set("g")) != 0; }
  Text text() const { return text_; }

 private:
  uint32_t runs_with(const Proven& proven, const uint8_t* table) const;
  bool has_feed() const { return (words_ & letter_set("f")) != 0; }
  int motion(const Proven& proven) const { return has_g() ? code_ : proven.code; }
  uint8_t* table_of(Proven& proven) const;
  uint32_t key(const Proven& proven) const;
  void take(uint32_t number, Proven* proven, PlainEffect* effect) const;

  uint32_t words_ = 0;
  uint8_t code_ = 0;
  Text text_ = kNothing;
};

/// Reads the line at `at`, which ends in a line feed. Returns where that is; null for a line that is not plain.
const char* read_plain_line(const char* at, PlainLine* line);

/// The letter's bit, in capitals or not; 0 for a byte that is none of PlainLine::kLetters.
uint32_t plain_letter(char c);

}  // namespace owlint
