#include "analyzer/text/paths.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace owlint {
namespace {

/// The parts of a path, without empty ones.
std::vector<std::string_view> parts_of(std::string_view path) {
  std::vector<std::string_view> parts;
  for (size_t at = 0; at < path.size();) {
    const size_t slash = std::min(path.find('/', at), path.size());
    if (slash > at) parts.push_back(path.substr(at, slash - at));
    at = slash + 1;
  }
  return parts;
}

}  // namespace

std::string file_key(const std::string& path) {
  static const std::string here = [] {
    std::error_code ignored;
    return std::filesystem::current_path(ignored).string();
  }();
  std::string absolute = path.starts_with('/') ? path : here + "/" + path;
  // Normalising is slow, and nearly all paths have nothing to normalise.
  const bool plain = absolute.find("/.") == std::string::npos && absolute.find("//") == std::string::npos;
  return plain ? absolute : normal_path(absolute);
}

std::string_view folder_of(std::string_view path) {
  const size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : path.substr(0, std::max<size_t>(slash, 1));
}

std::string_view stem_of(std::string_view path) {
  const std::string_view name = name_of(path);
  return name.substr(0, name.size() - ending_of(name).size());
}

std::string_view name_of(std::string_view path) {
  return path.substr(path.rfind('/') + 1);  // all of it where there is none
}

std::string_view ending_of(std::string_view path) {
  const std::string_view name = name_of(path);
  const size_t dot = name.rfind('.');
  return dot == std::string_view::npos || dot == 0 || name == ".." ? std::string_view() : name.substr(dot);
}

std::string joined_path(std::string_view folder, std::string_view path) {
  if (path.starts_with('/') || folder.empty()) return std::string(path);
  std::string out(folder);
  if (!out.ends_with('/')) out += '/';
  return out += path;
}

std::string normal_path(std::string_view path) {
  const bool absolute = path.starts_with('/');
  std::vector<std::string_view> kept;
  for (const std::string_view part : parts_of(path)) {
    if (part == ".") continue;
    if (part != ".." || (kept.empty() && !absolute) || (!kept.empty() && kept.back() == "..")) {
      kept.push_back(part);
    } else if (!kept.empty()) {
      kept.pop_back();
    }
  }
  if (kept.empty()) return absolute ? "/" : path.empty() ? "" : ".";
  std::string out;
  for (const std::string_view part : kept) {
    if (absolute || !out.empty()) out += '/';
    out += part;
  }
  const std::string_view last = name_of(path);
  const bool folder = last.empty() || last == "." || last == "..";
  if (folder && kept.back() != "..") out += '/';
  return out;
}

std::string relative_path(std::string_view path, std::string_view folder) {
  const std::vector<std::string_view> to = parts_of(path);
  const std::vector<std::string_view> from = parts_of(folder);
  const auto differ = std::ranges::mismatch(to, from);
  std::string out;
  const auto add = [&out](std::string_view part) {
    if (!out.empty()) out += '/';
    out += part;
  };
  for (auto above = differ.in2; above != from.end(); ++above) add("..");
  for (auto below = differ.in1; below != to.end(); ++below) add(*below);
  return out.empty() ? "." : out;
}

}  // namespace owlint
