// Programs of other controllers, told by what only they have.
#pragma once

#include <span>
#include <string_view>

#include "analyzer/syntax/nature.h"

namespace owlint {

/// How much a mark says.
enum class Proof : uint8_t {
  kAlone,    ///< enough
  kTwo,      ///< a slip of the pen may look like it: it takes a mark of another family, too
  kHint,     ///< such another one; LinuxCNC, or a machine that defines a code, may have it
  kIfNamed,  ///< a machine may define such a code: a comment has to name the controller, too
};

/// A line that LinuxCNC refuses, or would not have, and another controller knows.
struct Mark {
  std::string_view controller;
  std::string_view family;  ///< marks of one family are one mark: who writes `IF … GOTO` writes `GOTO`
  Proof proof;
  /// `@` is a number, `&` a letter, `*` anything but comments, `+` words without brackets and parameters, all else itself in any
  /// case; blanks do not count.
  std::string_view pattern;
  std::string_view example;  ///< such a line; tests ask LinuxCNC whether it refuses it
};

/// The table.
std::span<const Mark> marks();

/// Whether a line, without its line number, is as a pattern says.
bool fits(std::string_view line, std::string_view pattern);

/// Sets kind, controller and marks if the beginning of a file is another controller's.
void find_controller(std::string_view head, Nature* nature);

}  // namespace owlint
