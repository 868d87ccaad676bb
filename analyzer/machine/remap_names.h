// Local names that a sub finds when a remap calls it: `#<p>` for a P word, and what Python sets before.
#pragma once

#include <string_view>

#include "analyzer/machine/profile.h"

namespace owlint {

/// Whether a remap that calls `sub` may give it the name. Without an INI: a letter, or a name that LinuxCNC's own Python for
/// remaps sets. With one: what its REMAP lines say.
bool remap_gives(std::string_view name, std::string_view sub, const Profile& profile);

}  // namespace owlint
