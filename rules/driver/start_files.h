// What LinuxCNC runs and loads when it starts: HAL files, the display, the task, the module of the kinematics.
#pragma once

#include "rules/driver/machine_rules.h"

namespace owlint::rules {

/// HAL files and programs that are not there.
void check_start_files(const SetupInput& in, Reporter& out);
/// The line of `[KINS]KINEMATICS`: a module and its options.
void check_kinematics(const SetupInput& in, Reporter& out, const IniLine& line);
/// The line of a `TOOL_TABLE` or `PARAMETER_FILE`.
void check_machine_file(const SetupInput& in, Reporter& out, const IniLine& line);

/// Whether a HAL file beside the INI has a text, not in a comment.
bool hal_files_have(const SetupInput& in, std::string_view text);

}  // namespace owlint::rules
