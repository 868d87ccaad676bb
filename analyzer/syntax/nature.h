// What a file is that is no LinuxCNC program. Then that is the one finding, and what LinuxCNC would make of its lines is none.
#pragma once

#include <cstdint>
#include <string_view>

#include "analyzer/text/source.h"

namespace owlint {

struct Nature {
  enum Kind : uint8_t { kProgram, kUtf16, kNoText, kOtherController };

  Kind kind = kProgram;
  std::string_view controller;  ///< which other one, as its users call it
  Span mark;                    ///< what LinuxCNC does not have and that controller has
  Span other_mark;              ///< and another one; empty where one is enough
};

/// Looks at the beginning of a file, whatever its size.
Nature nature_of(std::string_view bytes);

}  // namespace owlint
