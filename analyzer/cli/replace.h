// Files are changed as a whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace owlint::cli {

/// Puts `text` in the place of a file at once, with the old one's permissions: whoever reads it sees the old text or the new
/// one. Links are followed. False and a message where that fails; then the file is as it was.
bool replace_file(const std::string& path, std::string_view text, std::string* error);

/// The same, unless the file is not `old` any more.
bool replace_unchanged(const std::string& path, std::string_view old, std::string_view text, std::string* error);

/// Writes a file that may be there or not, at once where it is.
bool write_text_file(const std::string& path, std::string_view text, std::string* error);

/// `diff -u` between two texts of a file.
std::string unified_diff(const std::string& path, std::string_view before, std::string_view after);

}  // namespace owlint::cli
