// What OW422 says of single joints: sections that are missing, and homing that cannot work.
#pragma once

#include <string>
#include <string_view>

#include "rules/driver/machine_rules.h"

namespace owlint::rules {

/// The letters of `trivkins coordinates=`; empty for other kinematics, and without the option.
std::string trivial_axes(std::string_view kinematics);

/// Joints without a section, and those that LinuxCNC cannot home as written.
void check_ini_joints(const SetupInput& in, Reporter& out);
/// `[EMCIO]TOOL_CHANGE_POSITION` beyond the limits of an axis.
void check_change_position_limits(const SetupInput& in, Reporter& out);

}  // namespace owlint::rules
