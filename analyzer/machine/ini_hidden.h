// An INI of which LinuxCNC reads nothing at all, because of how an editor has saved it. People see a sound file there, so that it
// has to be known for a machine's INI all the same.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace owlint {

enum class IniHidden : uint8_t {
  kNone,
  kUtf16,    ///< "Unicode" of Windows: a NUL in each character
  kReturns,  ///< lines that end with a carriage return alone, or with two of them
};

/// Measured with `inivar`: of such a file it finds nothing. Only files with a line `[SECTION]` are INIs.
IniHidden how_hidden(std::string_view bytes);

/// The text of such a file as people see it, with Unix line ends; any other text as it is.
std::string text_as_seen(std::string_view bytes);

}  // namespace owlint
