// What OW412 says of an INI's bytes and of the files that it includes.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "rules/driver/machine_rules.h"

namespace owlint::rules {

/// The beginning of a text, as code in a message.
std::string as_code(std::string_view text);

/// An INI of which LinuxCNC reads nothing: one finding, and true.
bool check_hidden_ini(const SetupInput& in, Reporter& out);
/// Carriage returns and NUL bytes in the INI, or in a file that it includes.
void check_bytes(const SetupInput& in, Reporter& out, const std::shared_ptr<const Source>& source);
/// `#INCLUDE` at the beginning of a line.
void check_include(const SetupInput& in, Reporter& out, const IniLine& line);
/// `#include machine.inc`, `# INCLUDE machine.inc`: a comment.
void check_near_include(const SetupInput& in, Reporter& out, const IniLine& line);

}  // namespace owlint::rules
