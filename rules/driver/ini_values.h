// Values of an INI as LinuxCNC 2.8 and 2.9 convert them: the whole value is one number, or there is none (measured).
#pragma once

#include <optional>
#include <string_view>

#include "rules/driver/machine_rules.h"

namespace owlint::rules {

std::optional<double> ini_real(std::string_view value);
std::optional<int> ini_integer(std::string_view value);
/// `1` and `0` with signs and further zeros.
std::optional<bool> ini_switch(std::string_view value);
/// true, yes, on, 1 and their opposites, in any case.
std::optional<bool> ini_truth(std::string_view value);
bool is_linear_unit(std::string_view value);
bool is_angular_unit(std::string_view value);

/// Whether LinuxCNC reads a section: of joints, those below `[KINS]JOINTS`; of axes, those of `[TRAJ]COORDINATES`.
bool reads_section(const IniText& text, std::string_view section);

/// The message with which task ends where a value is none of its kind.
std::string conversion_error(const IniText& text, const IniLine& line);

}  // namespace owlint::rules
