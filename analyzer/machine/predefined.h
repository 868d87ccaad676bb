// The parameters that LinuxCNC predefines: in each version, and from the INI and the hardware. Sources:
// each was tried with `rs274` of 2.9.0; for other versions LinuxCNC's documentation, and the changes that added a name
// (../../docs/interpreter.md, "Predefined parameters").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/machine/profile.h"

namespace owlint {

/// What a named parameter is on a machine.
enum class NameKind : uint8_t {
  kLocal,         ///< of the sub that is running
  kGlobal,        ///< begins with `_`: of all subs
  kSomeReleases,  ///< predefined in some releases of the version, an ordinary global in the others
  kOfMachine,     ///< from the machine, which is not known: an entry of its INI, a pin
  kPredefined,    ///< predefined: it can be read at any time, and cannot be assigned
};

/// `name`: in lower case and without blanks, as LinuxCNC keeps it. `#<_ini[section]entry>` is kPredefined if the INI
/// is known and has a number there, and an ordinary global if it has none.
NameKind name_kind(std::string_view name, const Profile& profile);

/// The number of `#<_ini[section]entry>`, if the INI is known and has it.
std::optional<double> ini_number(std::string_view name, const Profile& profile);

/// Whether `#<_ini[section]entry>` names an entry of the INI that is no number, so that the name does not exist. An entry that is
/// not there may be in the INI of the machine that runs the program.
bool is_ini_text(std::string_view name, const Profile& profile);

/// The version that introduced the predefined name `name`, if it is one.
std::optional<Version> predefined_since(std::string_view name);

/// The names that are predefined in a version, in all of its releases.
std::vector<std::string> predefined_names(Version version);

/// Whether a name is predefined in any version, or comes from the machine: its value is unknown.
bool may_be_predefined(std::string_view name);

/// Whether the machine decides on a name's value once, before a program runs: an entry of the INI, the machine's units, the
/// version, whether the program really runs or is only drawn.
bool fixed_by_machine(std::string_view name);

/// Whether a numbered parameter cannot be assigned (#5400-#5413 and #5420-#5428, measured; #5021-#5029 from 2.10 on).
bool read_only_number(long number, Version version);

}  // namespace owlint
