// Paths as text. Only file_key() asks for something else: for the working folder, once.
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

/// The last part of a path.
std::string_view name_of(std::string_view path);
/// The ending of a file's name, with its dot; empty if it has none.
std::string_view ending_of(std::string_view path);

/// `path` as seen from `folder`: an absolute path stays as it is.
std::string joined_path(std::string_view folder, std::string_view path);
/// Without `.`, `..` and repeated slashes, as far as the text alone allows it.
std::string normal_path(std::string_view path);
/// How a path is written in `folder`; both absolute and normal. `.` for the folder itself.
std::string relative_path(std::string_view path, std::string_view folder);

}  // namespace owlint
