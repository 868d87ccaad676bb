// One REMAP line of an INI, as the interpreter reads it when it starts: its options, and why it refuses the line. Measured with
// `rs274 -i`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/text/source.h"

namespace owlint {

struct RemapLine {
  enum class Problem : uint8_t {
    kNone,
    kOnlyComment,  ///< the interpreter crashes
    kNoEquals,     ///< an option without `=`
    kNoValue,
    kGroup,  ///< a modal group that the code cannot be in
    kArgspec,
    kTwoTargets,  ///< ngc= and python=
    kNoTarget,
    kNoNumber,    ///< `M` or `G` alone
    kLetterOnly,  ///< T, S and F take no number
    kFixedGroup,  ///< and no modal group
  };

  std::string_view code;
  std::string_view argspec, ngc, python, prolog, epilog;
  std::optional<int> group;               ///< as given, whatever it is
  std::vector<std::string_view> unknown;  ///< options that LinuxCNC does not have; it says so and goes on
  size_t dropped = 0;                     ///< options beyond the 18 that are read

  Problem problem = Problem::kNone;
  std::string_view at;  ///< what the problem is about, in the line
  std::string message;  ///< what the interpreter prints

  /// The letter of the code in upper case.
  char letter() const;
  /// Of an M code; -1 if it has none.
  int m_number() const;
  /// Of a G code, ten times: 881 for G88.1; -1 if it has none.
  int g_number() const;
};

/// `value`: the text behind `REMAP =`; the result points into it. `line`: its number in the INI.
RemapLine read_remap(std::string_view value, uint32_t line);

}  // namespace owlint
