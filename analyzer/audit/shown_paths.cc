#include "analyzer/audit/shown_paths.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "analyzer/text/paths.h"
#include "analyzer/text/source.h"

namespace owlint::audit {
namespace {

/// The last `count` parts of a path, without a slash at its end.
std::string_view tail(std::string_view path, size_t count) {
  size_t at = path.size();
  for (; count > 0 && at != std::string_view::npos; --count)
    at = at == 0 ? std::string_view::npos : path.rfind('/', at - 1);
  return at == std::string_view::npos ? path : path.substr(at + 1);
}

std::string without_slash(std::string path) {
  while (path.size() > 1 && path.ends_with('/')) path.pop_back();
  return path;
}

/// For each path as few of its last parts as tell it apart from the others.
std::vector<std::string> short_names(const std::vector<std::string>& paths) {
  std::vector<size_t> parts(paths.size(), 1);
  std::vector<std::string> names(paths.size());
  for (bool again = true; again;) {
    again = false;
    std::map<std::string, size_t> times;
    for (size_t i = 0; i < paths.size(); ++i) ++times[names[i] = std::string(tail(paths[i], parts[i]))];
    for (size_t i = 0; i < paths.size(); ++i) {
      if (times[names[i]] == 1 || names[i].size() == paths[i].size()) continue;
      ++parts[i];
      again = true;
    }
  }
  for (std::string& name : names) {
    name.erase(0, name.find_first_not_of('/'));
    if (name.empty()) name = "root";
  }
  return names;
}

std::string outside(std::string_view path) {
  const std::string_view end = tail(path, 2);
  return "…/" + std::string(end.substr(end.starts_with('/') ? 1 : 0));
}

constexpr size_t kLongest = 4096;                        // bytes of a path
constexpr std::string_view kEnds = "/ \t\n,;:|)]>`'\"";  // what may follow a part of one

bool starts_path(std::string_view words, size_t at) {
  constexpr std::string_view kBefore = " \t\n`'\"(:=,;|<[";
  if (words[at] != '/' || (at > 0 && kBefore.find(words[at - 1]) == std::string_view::npos) || at + 1 == words.size())
    return false;
  const auto next = static_cast<unsigned char>(words[at + 1]);
  return std::isalpha(next) != 0 || next == '_' || next == '.' || next >= 0x80;  // `/ M30` and `[#1 /2]` are none
}

/// Where a path ends that starts at `at`: at the quote or bracket that closes it, or else at the next blank.
size_t path_end(std::string_view words, size_t at) {
  const char before = at == 0 ? ' ' : words[at - 1];
  const std::string_view ends = before == '`' ? "`"
      : before == '"'                         ? "\""
      : before == '\''                        ? "'"
      : before == '('                         ? ")"
                                              : " \t\n,;:|)]>`'\"";
  return std::min(words.find_first_of(ends, at), words.size());
}

}  // namespace

ShownPaths::ShownPaths(const std::vector<std::string>& roots) {
  std::vector<std::string> paths;
  std::unordered_set<std::string> seen;
  for (const std::string& root : roots) {
    std::string path = without_slash(file_key(root));
    if (seen.insert(path).second) paths.push_back(std::move(path));
  }
  names_ = short_names(paths);
  for (size_t i = 0; i < paths.size(); ++i) roots_.emplace(paths[i] == "/" ? "" : paths[i], names_[i]);
}

void ShownPaths::know(const std::string& path) {
  const std::string folder(folder_of(file_key(path)));
  if (folder.size() > 1) elsewhere_.insert(folder);
}

std::string ShownPaths::path(const std::string& path) const {
  const std::string key = file_key(path);
  if (const auto self = roots_.find(key); self != roots_.end()) return self->second;
  for (size_t slash = 0; slash != std::string::npos;
       slash = key.find('/', slash + 1)) {  // the outermost root names what is in it
    if (const auto root = roots_.find(key.substr(0, slash)); root != roots_.end())
      return below(root->second) + key.substr(slash + 1);
  }
  return outside(key);
}

std::string ShownPaths::text(std::string_view words) const {
  std::string out;
  for (size_t at = 0; at < words.size();) {
    if (!starts_path(words, at)) {
      out += words[at++];
      continue;
    }
    // Paths may hold blanks: what is known is looked for first, the outermost root before all.
    const std::string* root = nullptr;
    size_t end = 0;
    size_t folder = 0;
    for (size_t next = at; root == nullptr && next < words.size() && next - at < kLongest;) {
      next = std::min(words.find_first_of(kEnds, next + 1), words.size());
      const std::string path(words.substr(at, next - at));
      if (const auto known = roots_.find(path); known != roots_.end()) root = &known->second;
      if (root != nullptr) end = next;
      if (elsewhere_.contains(path)) folder = next;
    }
    if (root != nullptr && end + 1 < words.size() && words[end] == '/') {
      out += below(*root);
      at = end + 1;
    } else if (root != nullptr) {
      out += *root;
      at = end;
    } else if (folder > 0) {
      out += "…/" + std::string(tail(words.substr(at, folder - at), 1));
      at = folder;
    } else {
      end = path_end(words, at);
      const std::string path = without_slash(std::string(words.substr(at, end - at)));
      out += path.find('/', 1) == std::string::npos ? path : outside(path);
      at = end;
    }
  }
  return out;
}

}  // namespace owlint::audit
