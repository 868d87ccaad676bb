// The check that LinuxCNC 2.8 and 2.9 make of an INI before they start anything, with a reader of its own: a file can be sound
// for it and not for the rest of LinuxCNC, and the other way round. Measured with LinuxCNC without a screen.
#pragma once

#include <string>
#include <vector>

#include "analyzer/machine/ini_text.h"

namespace owlint {

/// Why the check refuses an INI.
struct StartRefusal {
  enum class Kind : uint8_t {
    kBeforeSection,  ///< a line with `=` before the first section
    kNoKinematics,
    kNoJoints,
    kEndlessJoints,  ///< `JOINTS` is no number, as `3 # three`: the check never ends
    kMinLimit,       ///< of a joint, inside that of its axis
    kMaxLimit,
    kNoUnits,  ///< task ends where `[TRAJ]` lacks one of its units; check_config() does not say so
  };
  Kind kind = Kind::kBeforeSection;
  const IniLine* line = nullptr;  ///< the one to change; null where a section or key is not there at all
  const IniLine* axis = nullptr;  ///< of a limit: where the axis has it; null if it has none
  std::string joint_name;         ///< of a limit: `JOINT_0`
  std::string axis_name;          ///< `AXIS_X`
  std::string message;            ///< what LinuxCNC prints
};

/// In the order in which LinuxCNC finds them; behind the first kind nothing is read any more.
std::vector<StartRefusal> check_config(const IniText& text);

/// Whether the check takes a line for the beginning of a section: `]` must be its last character.
bool is_checked_section(const IniText& text, const IniLine& line);

}  // namespace owlint
