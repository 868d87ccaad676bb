// A line of a program as reports show it: what fits, and where the marks below it belong.
#pragma once

#include <string>

#include "analyzer/text/source.h"

namespace owlint {

struct Snippet {
  uint32_t line = 0;
  std::string text;   ///< printable, tabs as blanks, with `…` where something is cut off
  size_t pad = 0;     ///< columns before the mark
  size_t marked = 1;  ///< columns that are marked; at least one
};

/// The line of a span, cut around the span to `room` columns. However long the line is, only the bytes near the span are
/// looked at.
Snippet snippet(const Source& source, Span span, size_t room);

}  // namespace owlint
