// What LinuxCNC 2.10 refuses in an INI: it reads the whole file at once, and one bad line refuses all of it. From the reader of
// its development branch, which was compiled and run on 4,000 random files and 1,800 real ones.
#pragma once

#include <string>
#include <vector>

#include "analyzer/machine/ini_text.h"

namespace owlint {

struct StrictRefusal {
  enum class Kind : uint8_t {
    kNoEquals,       ///< a line without `=`
    kBadKey,         ///< a key with other characters than letters, digits and `_`, or with a digit first
    kBadSection,     ///< the same of a section; or no name at all
    kOpenSection,    ///< `[NAME` without `]`
    kBeforeSection,  ///< a key before any section
    kNotUtf8,
    kBadEscape,  ///< `\x`, `\u` or `\U` without its digits
    kOpenEnd,    ///< `\` at the end of the file
    kNoInclude,  ///< a file that `#INCLUDE` names and that is not there
  };
  Kind kind = Kind::kNoEquals;
  const IniLine* line = nullptr;
  Span span;            ///< what is wrong
  std::string message;  ///< what LinuxCNC prints, where that was seen; or empty
};

std::vector<StrictRefusal> strict_refusals(const IniText& text);

}  // namespace owlint
