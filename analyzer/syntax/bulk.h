// The fast path of the scanner: recognises lines of plain motion, which are nearly all lines of a large program, checks them,
// and keeps nothing of them but how many there are and what they do to the modes. It stops at the first line that is anything
// else; scanner.cc then reads that line. So it may stop too often, but never pass a line that stops the interpreter.
//
// Bytes are sorted into kinds, a bit for each byte (byte_classes.h), and a few operations on these bits say for 64 bytes at once
// whether words follow each other as they should. What that leaves open, such as a comment, read_plain_line() decides.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "analyzer/syntax/byte_classes.h"
#include "analyzer/syntax/plain_line.h"

namespace owlint {

/// By axis letter the offset of the line that has the last word of it.
class LastLines {
 public:
  static constexpr size_t kNowhere = SIZE_MAX;

  LastLines() { at_.fill(kNowhere); }
  /// `letter`: its index, of A to C or X to Z.
  size_t operator[](size_t letter) const { return at_[place_of(letter)]; }
  void add(uint32_t axes, size_t line);
  bool operator==(const LastLines&) const = default;

 private:
  static constexpr size_t place_of(size_t letter) { return letter < 3 ? letter : letter - 20; }

  std::array<size_t, 6> at_;
};

/// The lines that were passed, and where that ended.
struct Passed {
  size_t next = 0;          ///< offset of the first line that is not plain, or where to end
  uint32_t lines = 0;       ///< lines before it
  uint32_t first_code = 0;  ///< the first of them that is neither blank nor a comment, from 1; 0: none
  uint32_t last_code = 0;   ///< the last of them
  bool text = false;        ///< not all of them are blank
  PlainEffect effect;
  LastLines last;
  Proven proven;  ///< behind them

  bool operator==(const Passed&) const = default;
};

class PlainLines {
 public:
  /// `bytes` end in a line feed. `refused`: letters that a plain line has not, because the machine remaps or restricts them.
  /// Without a classifier each line is read by itself: that tests compare with.
  explicit PlainLines(std::string_view bytes, const ByteClassifier* by = &byte_classifiers().front(),
                      uint32_t refused = 0)
      : bytes_(bytes), by_(by), refused_(refused) {}

  /// Passes plain lines from the line start `from` on, up to the line start `to`. A plain line is blank or a comment, or has at
  /// most as many bytes as LinuxCNC reads, a line number perhaps, at most one of G0 to G3, and words X, Y, Z, A, B, C, F, S, with
  /// an arc I, J, K, R, as far as the motion in effect takes them. Each is there once, with digits, a sign, and a point; F and S
  /// are not 0. Comments tell nothing to LinuxCNC or owlint.
  Passed pass(size_t from, size_t to, const Proven& proven);

 private:
  struct Like {
    uint32_t key = 0;
    size_t last = 0;
  };

  void look(size_t from);
  size_t feed_behind(size_t from) const;
  template <typename Do>
  void for_letters(size_t from, size_t to, const Do& apply) const;
  bool never_zero(size_t from, size_t feed) const;
  bool read_codes(size_t from, size_t feed, uint32_t words, uint8_t* code) const;
  bool read_by_bits(size_t from, size_t feed, PlainLine* line) const;
  void pass_alike(size_t to, Passed* out);
  bool accept(const PlainLine& line, size_t at, Passed* out);
  void forget(Like& like, Passed* out);

  std::string_view bytes_;
  const ByteClassifier* by_;
  uint32_t refused_;
  // What is known of the bytes in [begin_, end_).
  size_t begin_ = 0;
  size_t end_ = 0;
  ByteClasses classes_;
  ByteClasses::Bits bad_{};  // where no word can go on or begin
  // Lines that were accepted, by their words and the motion in effect: another such line does nothing more.
  std::array<Like, 16> likes_{};
  uint32_t used_ = 0;  // of these
};

/// For tests alone: the scanner passes no line, and the parser reads each.
inline bool no_line_is_plain = false;

/// What is proven behind a line that was not passed, if the run goes on there; `always`: what is proven behind any line, also
/// one with a letter of `refused`.
Proven proven_after(std::string_view line, const Proven& before, const Proven& always = {}, uint32_t refused = 0);

}  // namespace owlint
