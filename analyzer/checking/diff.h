// What has changed between two texts of a file, as people read it.
#pragma once

#include <string>
#include <string_view>

namespace owlint::checking {

/// `diff -u` between two texts of a file.
std::string unified_diff(const std::string& path, std::string_view before, std::string_view after);

}  // namespace owlint::checking
