// The parameters that are LinuxCNC's own: which there are in a version, and which its INI and its hardware add. Sources:
// each was tried with `rs274` of 2.9.0; for other versions LinuxCNC's documentation, and the changes that added a name
// (../../docs/interpreter.md, "Predefined parameters").
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "analyzer/machine/profile.h"

namespace owlint {

/// What a named parameter is on a machine.
enum class NameKind : uint8_t {
  kLocal,         ///< of the sub that is executed
  kGlobal,        ///< begins with `_`: of all subs
  kSomeReleases,  ///< LinuxCNC's own in some releases of the version, like any other global in the rest
  kOfMachine,     ///< looked up in the machine, which is not known: an entry of its INI, a pin
  kPredefined,    ///< LinuxCNC's own: it can be read at any time, and not be assigned
};

/// `name`: in small letters and without blanks, as LinuxCNC keeps it. `#<_ini[section]entry>` is kPredefined where the INI
/// is known and has a number there, and like any other global where it has none.
NameKind name_kind(std::string_view name, const Profile& profile);

/// The number that `#<_ini[section]entry>` reads, where the INI is known and has it.
std::optional<double> ini_number(std::string_view name, const Profile& profile);

/// The version that LinuxCNC's own name `name` came with, if it is one.
std::optional<Version> predefined_since(std::string_view name);

/// Whether a name is LinuxCNC's own in any version, or looked up in the machine: nothing is known of its value.
bool may_be_predefined(std::string_view name);

/// Whether a numbered parameter cannot be assigned (#5400-#5413 and #5420-#5428, measured; #5021-#5029 from 2.10 on).
bool read_only_number(long number, Version version);

}  // namespace owlint
