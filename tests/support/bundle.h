// Programs of several files in one text: the text before the first line `; file: NAME` is `program.ngc`, what follows
// such a line is the file of that name. Fixtures and the examples of rules about files are written so.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "support/files.h"

namespace owlint::test {

bool is_bundle(const std::string& text);

/// Writes the files of a bundle into a folder.
void unpack(const std::string& text, const Scratch& folder);

/// The findings of all files of a bundle; those that are not in `program.ngc` have their file as `file`.
nlohmann::json findings_of_bundle(const std::string& text, const std::string& options);

}  // namespace owlint::test
