// What the REMAP lines of an INI say: their options, and the local names that a sub finds when a remap calls it: `#<p>` for a P
// word, and what Python sets before.
#pragma once

#include <string_view>

#include "analyzer/machine/profile.h"

namespace owlint {

/// The value of an option (`ngc=`) in a REMAP line; empty where it is not there.
std::string_view remap_option(std::string_view remap, std::string_view option);

/// Whether a remap that calls `sub` may give it the name. With an INI: what its REMAP lines say. Without one: a letter, or a name
/// that LinuxCNC's own Python for remaps sets, as also for a sub that the INI does not remap.
bool remap_gives(std::string_view name, std::string_view sub, const Profile& profile);

}  // namespace owlint
