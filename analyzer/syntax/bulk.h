// The fast path of the scanner: recognises lines of plain motion, which are nearly all lines of a large program, checks them,
// and keeps nothing of them but how many there are and which motion they leave. It stops at the first line that is anything
// else; scanner.cc then reads that line. So it may stop too often, but never pass a line that stops the interpreter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "analyzer/syntax/codes.h"

namespace owlint {

/// What is known of the motion in effect, as far as plain lines need it: which words without a code are surely taken.
enum class Taken : uint8_t {
  kNothing,   ///< it is not known whether any motion is in effect
  kXyz,       ///< some motion is; it may be a cycle, where A, B and C are refused
  kAxes,      ///< a motion that is no cycle
  kArcWords,  ///< G2 or G3: also I, J, K and R
};

/// The lines that were passed, and where that ended.
struct Passed {
  size_t next = 0;                ///< offset of the first line that is not plain, or the size of the bytes
  uint32_t lines = 0;             ///< lines before it
  uint32_t first_code = 0;        ///< the first of them that is not blank, from 1; 0: all are blank
  uint32_t last_code = 0;         ///< the last of them
  Motion motion = Motion::kNone;  ///< that of the last G0, G1, G2 or G3
  Taken taken = Taken::kNothing;  ///< behind them

  bool operator==(const Passed&) const = default;
};

/// Passes plain lines from the line start `from` on; `bytes` end in a line feed. A plain line is blank, or has no comment, at
/// most as many bytes as LinuxCNC reads, a line number perhaps, at most one of G0 to G3, and words X, Y, Z, A, B, C, F, S, with
/// an arc I, J, K, R, as far as the motion in effect takes them. Each is there once, with digits, a sign, and a point.
Passed pass_plain_lines(std::string_view bytes, size_t from, Taken taken);

/// What is taken behind a line that is not plain, if the run goes on there.
Taken taken_after(std::string_view line, Taken before);

}  // namespace owlint
