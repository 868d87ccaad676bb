// Paths as text. Nothing here looks at files.
#pragma once

#include <string>
#include <string_view>

namespace owlint {

/// The same text for the same file, however its path is written; the file need not exist.
std::string file_key(const std::string& path);

/// The folder of a file, without the `/` at its end; empty if the path has none.
std::string_view folder_of(std::string_view path);
/// The name of a file without its folder and its ending.
std::string_view stem_of(std::string_view path);

}  // namespace owlint
