// The keys of an INI that LinuxCNC itself reads, with what their values must be: the table behind findings about lost keys and
// malformed values. Displays and vendors have many more, which owlint does not judge. Sources: LinuxCNC run with each key, its
// documentation, and its sample configurations.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace owlint {

struct IniKey {
  enum class Type : uint8_t {
    kText,
    kSwitch,  ///< `0` or `1`; anything else leaves the default, without a message
    kTruth,   ///< true, yes, false, no in any case, or an integer
    kInteger,
    kNumber,
    kJointType,  ///< linear or angular, in any case
    kUnits,      ///< mm, inch, … or a number
    kPath,
    kPaths,  ///< separated by `:`
    kGcode,  ///< `;` begins a comment there
    kRemap,  ///< `#` begins a comment there
  };
  std::string_view section;  ///< `JOINT_` stands for `[JOINT_0]` and its like, `AXIS_` for `[AXIS_X]`
  std::string_view name;
  std::string_view meaning;  ///< in a few words, with code in backticks
  Type type = Type::kText;
  bool refuses = false;  ///< LinuxCNC ends where the value is no such thing; otherwise the default stays
  bool several = false;  ///< may be there more than once
  bool on = false;       ///< of a switch: the default
};

/// Null if LinuxCNC itself reads no such key there. `section` as in the INI.
const IniKey* find_ini_key(std::string_view section, std::string_view name);
std::span<const IniKey> ini_keys();

/// Whether a section is one of LinuxCNC's own, with keys that LinuxCNC or its displays read.
bool is_known_section(std::string_view section);
struct IniSection {
  std::string_view name;  ///< `JOINT_` as above
  std::string_view meaning;
};
/// Those sections that LinuxCNC itself reads.
std::span<const IniSection> machine_sections();
const IniSection* find_ini_section(std::string_view section);
/// Whether some display, or a driver of the sample configurations, has this key in that section, so that it is not misspelt.
bool is_display_key(std::string_view section, std::string_view name);

}  // namespace owlint
