// The sub of a lathe contour: its lines as words, and what G70 to G72 read of them. Nothing of such a line is executed, but that
// it may set the motion mode. Source: measured with rs274, see docs/interpreter.md.
#pragma once

#include <span>
#include <vector>

#include "analyzer/geometry/contour.h"
#include "analyzer/syntax/codes.h"

namespace owlint {

struct ContourWord {
  char letter;  ///< small
  double value;
};

/// The words of the lines, one line after the other.
struct ContourSub {
  std::vector<ContourWord> words;
  std::vector<size_t> ends;  ///< by line: where its words end

  bool begins_blank = false;  ///< the line before the sub would be read again: it has steps in G91

  /// A line without anything: the interpreter reads the one before it again (measured). One with a comment does nothing.
  void add_blank_line();
  /// The motion mode behind it, if nothing is cut: the last code of its lines, else that of the rapid move to the start.
  Motion motion() const;
};

/// Modes of the line that cuts the contour.
struct ContourModes {
  bool incremental;       ///< G91
  bool absolute_centers;  ///< G90.1
  bool diameter;          ///< G7
};

class ContourReader {
 public:
  /// `start`: where the contour begins, Z and X.
  ContourReader(const ContourModes& modes, PlanePoint start) : modes_(modes), at_(start) {}

  /// Reads the lines. The message if the interpreter stops at one of them, else null.
  const char* read(const ContourSub& sub);
  const std::vector<ContourElement>& elements() const { return elements_; }
  /// Where the last line ends: there the interpreter takes the machine to be if nothing is cut.
  PlanePoint at() const { return at_; }

 private:
  const char* line(std::span<const ContourWord> words);
  const char* element(std::span<const ContourWord> words, PlanePoint end);

  ContourModes modes_;
  PlanePoint at_;
  int motion_ = code::kG0;  // in tenths
  std::vector<ContourElement> elements_;
};

}  // namespace owlint
