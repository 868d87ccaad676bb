#include "analyzer/text/paths.h"

#include <algorithm>
#include <filesystem>

namespace owlint {

std::string file_key(const std::string& path) {
  static const std::string here = [] {
    std::error_code ignored;
    return std::filesystem::current_path(ignored).string();
  }();
  std::string absolute = path.starts_with('/') ? path : here + "/" + path;
  // Normalising is slow, and nearly all paths have nothing to normalise.
  const bool plain = absolute.find("/.") == std::string::npos && absolute.find("//") == std::string::npos;
  return plain ? absolute : std::filesystem::path(absolute).lexically_normal().string();
}

std::string_view folder_of(std::string_view path) {
  const size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : path.substr(0, std::max<size_t>(slash, 1));
}

std::string_view stem_of(std::string_view path) {
  const std::string_view name = path.substr(path.rfind('/') + 1);  // all of it where there is none
  const size_t dot = name.rfind('.');
  return dot == std::string_view::npos || dot == 0 ? name : name.substr(0, dot);
}

}  // namespace owlint
