#include "analyzer/checking/ignore.h"

#include <fnmatch.h>

#include <algorithm>

namespace owlint::checking {
namespace {

std::vector<std::string> split(std::string_view path) {
  std::vector<std::string> parts;
  for (size_t at = 0; at <= path.size();) {
    const size_t slash = std::min(path.find('/', at), path.size());
    const std::string_view part = path.substr(at, slash - at);
    if (!part.empty() && part != ".") parts.emplace_back(part);
    at = slash + 1;
  }
  return parts;
}

bool fits_part(const std::string& pattern, const std::string& part) {
  return ::fnmatch(pattern.c_str(), part.c_str(), 0) == 0;
}

/// Parts of a pattern against parts of a path. As with `*` in a text, only the last `**` has to be tried again.
bool fits(const std::vector<std::string>& pattern, const std::vector<std::string>& path) {
  size_t p = 0;
  size_t at = 0;
  size_t many = std::string::npos;  // the last `**`
  size_t tried = 0;                 // the part of the path that it ends before
  while (at < path.size()) {
    if (p < pattern.size() && pattern[p] == "**") {
      many = p++;
      tried = at;
    } else if (p < pattern.size() && fits_part(pattern[p], path[at])) {
      ++p;
      ++at;
    } else if (many != std::string::npos) {
      p = many + 1;
      at = ++tried;
    } else {
      return false;
    }
  }
  // `a/**` is what is in a, not a itself.
  return p == pattern.size();
}

}  // namespace

void IgnorePatterns::add(std::string_view text) {
  for (size_t at = 0; at < text.size();) {
    const size_t feed = std::min(text.find('\n', at), text.size());
    add_line(text.substr(at, feed - at));
    at = feed + 1;
  }
}

void IgnorePatterns::add_line(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  while (line.ends_with(' ') && !line.ends_with("\\ ")) line.remove_suffix(1);
  if (line.empty() || line.front() == '#') return;
  Pattern pattern;
  if (line.front() == '!') {
    pattern.taken_back = true;
    line.remove_prefix(1);
  }
  if (line.ends_with('/')) {
    pattern.folders_only = true;
    line.remove_suffix(1);
  }
  const bool tied = line.find('/') != std::string_view::npos;
  pattern.parts = split(line);
  if (pattern.parts.empty()) return;
  if (!tied) pattern.parts.insert(pattern.parts.begin(), "**");
  patterns_.push_back(std::move(pattern));
}

std::optional<bool> IgnorePatterns::decide(std::string_view relative, bool folder) const {
  const std::vector<std::string> parts = split(relative);
  for (auto pattern = patterns_.rbegin(); pattern != patterns_.rend(); ++pattern) {
    if (pattern->folders_only && !folder) continue;
    if (fits(pattern->parts, parts)) return !pattern->taken_back;
  }
  return std::nullopt;
}

}  // namespace owlint::checking
