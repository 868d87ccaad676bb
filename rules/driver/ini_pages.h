// Files that the INI names for displays: the pages of ngcgui, and where the folders of a key have a file.
#pragma once

#include <string>
#include <string_view>

#include "rules/driver/machine_rules.h"

namespace owlint::rules {

/// Whether all folders of a key, such as `SUBROUTINE_PATH`, are here.
bool has_all_folders(const SetupInput& in, std::string_view key);
/// The path of a file that lies in a folder of this key; empty if there is none.
std::string file_in(const SetupInput& in, std::string_view key, const std::string& name);

/// Files of which ngcgui makes pages.
void check_ngcgui_pages(const SetupInput& in, Reporter& out);

}  // namespace owlint::rules
