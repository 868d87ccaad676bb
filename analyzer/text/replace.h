// Writes files to disk. They are changed as a whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace owlint {

/// Replaces a file by `text` in one step, with the same permissions: a reader sees the old text or the new one. Follows
/// links. On failure returns false and a message, and the file is unchanged.
bool replace_file(const std::string& path, std::string_view text, std::string* error);

/// The same, unless the file has changed and is no longer `old`.
bool replace_unchanged(const std::string& path, std::string_view old, std::string_view text, std::string* error);

/// Makes a folder, and those that it lies in; it may exist.
bool make_folder(const std::string& path, std::string* error);

/// Writes a file that may exist or not; if it exists, in one step.
bool write_text_file(const std::string& path, std::string_view text, std::string* error);

}  // namespace owlint
