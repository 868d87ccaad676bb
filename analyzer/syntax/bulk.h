// The fast path of the scanner: recognises lines of plain motion, which are nearly all lines of a large program, checks them,
// and keeps nothing of them but how many there are and which modes they set. It stops at the first line that is anything
// else; scanner.cc then reads that line. So it may stop too often, but never pass a line that stops the interpreter.
#pragma once

#include <cstddef>
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

/// The lines that were passed, and where that ended.
struct Passed {
  size_t next = 0;          ///< offset of the first line that is not plain, or the size of the bytes
  uint32_t lines = 0;       ///< lines before it
  uint32_t first_code = 0;  ///< the first of them that is not blank, from 1; 0: all are blank
  uint32_t last_code = 0;   ///< the last of them
  PlainEffect effect;
  Proven proven;  ///< behind them

  bool operator==(const Passed&) const = default;
};

/// Passes plain lines from the line start `from` on; `bytes` end in a line feed. A plain line is blank, or has no comment, at
/// most as many bytes as LinuxCNC reads, a line number perhaps, at most one of G0 to G3, and words X, Y, Z, A, B, C, F, S, with
/// an arc I, J, K, R, as far as the motion in effect takes them. Each is there once, with digits, a sign, and a point; F and S
/// are not 0. `refused`: letters that a plain line has not, because the machine remaps or restricts them.
Passed pass_plain_lines(std::string_view bytes, size_t from, const Proven& proven, uint32_t refused = 0);

/// What is proven behind a line that was not passed, if the run goes on there.
Proven proven_after(std::string_view line, const Proven& before);

}  // namespace owlint
