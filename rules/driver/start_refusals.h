// What LinuxCNC does not start for in an INI, with the line that is the cause. Three rules share it: OW412 reports causes in the
// form of lines, OW414 misspelt sections and keys, OW422 the rest.
#pragma once

#include <vector>

#include "analyzer/machine/check_config.h"
#include "rules/driver/rule.h"

namespace owlint::rules {

struct BlamedRefusal {
  StartRefusal refusal;
  const IniLine* cause = nullptr;  ///< a line that was meant for the section or key, and is none; null: as written
  std::string_view key = {};       ///< of kNoUnits: the one that is missing
  bool misspelt = false;           ///< `cause` is another name that was meant for the section's or the key's
};

/// The check before the start, and the units. Empty if LinuxCNC does not make that check with this INI: see is_whole_machine().
std::vector<BlamedRefusal> start_refusals(const SetupInput& in);

/// The section of LinuxCNC that a name was meant for, if the INI has none of that name: `TRAJ` for `traj`, `RS274NGC` for
/// `RS274NCG`. Empty if there is none.
std::string meant_section(const IniText& text, std::string_view name);

/// The key of LinuxCNC that a name in one of its sections was meant for: in another case, with one letter wrong, or two of a long
/// name, or without the name's beginning. Empty if there is none.
std::string meant_key(std::string_view section, std::string_view name);

/// `KINS]`, which opens no section.
bool is_unopened_section(const IniText& text, const IniLine& line);

}  // namespace owlint::rules
