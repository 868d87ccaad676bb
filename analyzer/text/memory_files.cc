#include "analyzer/text/memory_files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "analyzer/text/paths.h"

namespace owlint {
namespace {

/// A path without the slash at its end; empty for the root.
std::string key_of(const std::string& path) {
  std::string key = file_key(path);
  if (key.ends_with('/')) key.pop_back();
  return key;
}

/// Puts the parts of a path on a stack, so that the first is on top.
void push_parts(std::string_view path, std::vector<std::string>& stack) {
  for (size_t end = path.size(); end > 0;) {
    const size_t slash = path.rfind('/', end - 1);
    const size_t begin = slash == std::string_view::npos ? 0 : slash + 1;
    if (begin < end) stack.emplace_back(path.substr(begin, end - begin));
    end = slash == std::string_view::npos ? 0 : slash;
  }
}

}  // namespace

void MemoryFiles::add(const std::string& path, Node node) {
  const std::string key = key_of(path);
  for (size_t slash = key.find('/', 1); slash != std::string::npos; slash = key.find('/', slash + 1))
    nodes_.try_emplace(key.substr(0, slash), Node{FileKind::kFolder, "", false});
  nodes_.insert_or_assign(key, std::move(node));
}

void MemoryFiles::add_file(const std::string& path, std::string bytes) {
  add(path, {FileKind::kFile, std::move(bytes), false});
}

void MemoryFiles::add_folder(const std::string& path) { add(path, {FileKind::kFolder, "", false}); }

void MemoryFiles::add_link(const std::string& path, const std::string& target) {
  add(path, {FileKind::kLink, target, false});
}

void MemoryFiles::add_other(const std::string& path) { add(path, {FileKind::kOther, "", false}); }

void MemoryFiles::forbid(const std::string& path) { nodes_.at(key_of(path)).forbidden = true; }

MemoryFiles::Place MemoryFiles::find(const std::string& path) const {
  static const Node root{FileKind::kFolder, "", false};
  constexpr int kMaxLinks = 40;  // as Linux has it
  std::vector<std::string> parts;
  push_parts(path, parts);
  if (!path.starts_with('/')) push_parts(file_key("."), parts);
  Place at{"", &root, 0};
  for (int links = 0; !parts.empty();) {
    const std::string part = std::move(parts.back());
    parts.pop_back();
    if (part == ".") continue;
    if (at.node != nullptr && at.node->kind != FileKind::kFolder) at = {at.path, nullptr, ENOTDIR};
    if (at.node != nullptr && at.node->forbidden) at = {at.path, nullptr, EACCES};
    if (part == "..") {
      at.path.resize(at.path.empty() ? 0 : at.path.rfind('/'));
      if (at.node != nullptr) at.node = at.path.empty() ? &root : &nodes_.at(at.path);
      continue;
    }
    std::string next = at.path + '/' + part;
    const auto found = nodes_.find(next);
    const Node* node = at.node == nullptr || found == nodes_.end() ? nullptr : &found->second;
    if (node != nullptr && node->kind == FileKind::kLink) {
      if (++links > kMaxLinks) return {file_key(path), nullptr, ELOOP};
      if (node->text.starts_with('/')) at.path.clear();
      if (at.path.empty()) at.node = &root;
      push_parts(node->text, parts);
      continue;
    }
    at = {std::move(next), node, node != nullptr ? 0 : at.problem != 0 ? at.problem : ENOENT};
  }
  return at;
}

std::shared_ptr<const Source> MemoryFiles::read(const std::string& path, std::string* error) const {
  const Place at = find(path);
  if (at.node == nullptr || at.node->forbidden) {
    *error = std::strerror(at.node == nullptr ? at.problem : EACCES);
    return nullptr;
  }
  if (at.node->kind != FileKind::kFile) {
    *error = at.node->kind == FileKind::kFolder ? "is a directory" : "is not a regular file";
    return nullptr;
  }
  return Source::own(path, at.node->text);
}

FileInfo MemoryFiles::info(const std::string& path) const {
  const Place at = find(path);
  if (at.node == nullptr) return {};
  return {at.node->kind, at.node->text.size(), at.node->text.starts_with("#!"), 0};
}

bool MemoryFiles::readable(const std::string& path) const {
  const Place at = find(path);
  return at.node != nullptr && !at.node->forbidden;
}

std::vector<FolderEntry> MemoryFiles::list(const std::string& folder, std::string* error) const {
  const Place at = find(folder);
  const int problem = at.node == nullptr   ? at.problem
      : at.node->kind != FileKind::kFolder ? ENOTDIR
      : at.node->forbidden                 ? EACCES
                                           : 0;
  if (problem != 0) {
    *error = std::strerror(problem);
    return {};
  }
  std::vector<FolderEntry> entries;
  const std::string below = at.path + '/';
  for (auto node = nodes_.lower_bound(below); node != nodes_.end() && node->first.starts_with(below); ++node) {
    const std::string_view name = std::string_view(node->first).substr(below.size());
    if (name.find('/') == std::string_view::npos) entries.push_back({std::string(name), node->second.kind});
  }
  return entries;
}

std::string MemoryFiles::real_path(const std::string& path) const {
  const Place at = find(path);
  return at.path.empty() ? "/" : at.path;
}

}  // namespace owlint
