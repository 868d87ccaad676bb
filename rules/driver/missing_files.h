// One cause, one finding: files that an INI names and that are not here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rules/driver/rule.h"

namespace owlint::rules {

/// Where a file of the INI's folder is that a value names; arguments may follow its name.
std::string path_beside(const SetupInput& in, std::string_view value);

/// Folds findings with `missing`, all in one file of an INI and in the order of their places. If the INI's HAL files, tool table
/// and Python are not here either, the folder has only a part of the configuration: the first finding says so and speaks for
/// all; one of OW208, which is about calls, becomes one of OW407 if `names_folders`: that rule is selected. Otherwise those of
/// one rule become one finding, which names all the files. The caller decides severities again, and what comments suppress.
void fold_missing_files(const SetupInput& in, std::vector<Finding>& findings, bool names_folders);

}  // namespace owlint::rules
