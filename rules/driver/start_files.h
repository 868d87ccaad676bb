// What LinuxCNC runs and loads when it starts: HAL files, the display, the task, the module of the kinematics.
#pragma once

#include "rules/driver/machine_rules.h"

namespace owlint::rules {

/// HAL files and programs that are not there.
void check_start_files(const SetupInput& in, Reporter& out);
/// The line of `[KINS]KINEMATICS`: a module and its options.
void check_kinematics(const SetupInput& in, Reporter& out, const IniLine& line);

}  // namespace owlint::rules
