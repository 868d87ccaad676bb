#include "analyzer/machine/search_path.h"

#include <algorithm>

#include "analyzer/text/paths.h"

namespace owlint {
namespace {

constexpr size_t kMaxListed = 500'000;  // files of one folder, or of a tree, that are remembered
constexpr std::string_view kEnding = ".ngc";

bool plain_name(std::string_view name) {
  return !name.empty() && name.find('\0') == std::string_view::npos && !leaves_folders(name) && !expands(name);
}

}  // namespace

bool expands(std::string_view name) { return name.find_first_of("`$") != std::string_view::npos; }

namespace {

/// The end of `${…}`, of which `at` is the `{`; npos where wordexp() takes it for a mistake.
size_t end_of_variable(std::string_view name, size_t at) {
  const auto in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const size_t begin = at + 1;
  size_t end = begin;
  while (end < name.size() && in_name(name[end])) ++end;
  if (end == begin || end == name.size()) return std::string_view::npos;
  if (name[end] == '}') return end;
  return std::string_view(":-=?+#%").find(name[end]) == std::string_view::npos ? std::string_view::npos
                                                                               : name.find('}', end);
}

}  // namespace

bool breaks_expansion(std::string_view name) {
  char quote = '\0';
  bool pattern = false;  // behind `*`, `?` or `[` only quotes are looked for
  for (size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (quote == '\'') {
      if (c == '\'') quote = '\0';
    } else if (c == '\\') {
      if (++i == name.size()) return true;
    } else if (c == '"') {
      quote = quote == '"' ? '\0' : '"';
    } else if (c == '`') {
      i = name.find('`', i + 1);
      if (i == std::string_view::npos) return true;
    } else if (c == '$' && name.substr(i + 1).starts_with('{')) {
      i = end_of_variable(name, i + 1);
      if (i == std::string_view::npos) return true;
    } else if (c == '$' && name.substr(i + 1).starts_with('(')) {
      i = name.find(')', i + 1);
      if (i == std::string_view::npos) return true;
    } else if (quote == '\0') {
      if (c == '\'') quote = c;
      if (std::string_view("*?[").find(c) != std::string_view::npos) pattern = true;
      if (!pattern && std::string_view("|&;<>(){}\n").find(c) != std::string_view::npos) return true;
    }
  }
  return quote != '\0';
}

bool leaves_folders(std::string_view name) {
  if (name.starts_with('/') || name.starts_with('~')) return true;
  for (size_t at = 0; at <= name.size();) {
    const size_t slash = std::min(name.find('/', at), name.size());
    if (name.substr(at, slash - at) == "..") return true;
    at = slash + 1;
  }
  return false;
}

std::vector<FoundFile> SearchPath::look_up(std::string_view name, size_t most) const {
  std::vector<FoundFile> found;
  if (!plain_name(name)) return found;
  const std::string file = std::string(name) + std::string(kEnding);
  for (size_t i = 0; i < folders_.size() && found.size() < most; ++i) {
    if (auto one = look_in(i, file)) found.push_back(std::move(*one));
  }
  return found;
}

std::optional<FoundFile> SearchPath::look_in(size_t folder, const std::string& file) const {
  if (folders_[folder].tree) {
    const Tree& tree = trees()[folder];
    const auto below = tree.find(file);
    return below == tree.end() ? std::nullopt : std::optional(FoundFile{below->second, true, folder});
  }
  if (!may_be_in(folder, file)) return std::nullopt;
  const std::string path = joined_path(folders_[folder].path, file);
  const FileKind kind = files_.info(path).kind;
  if (kind == FileKind::kNone || !files_.readable(path)) return std::nullopt;
  return FoundFile{normal_path(path), kind == FileKind::kFile, folder};
}

/// Whether it is worth asking the file system. A few names are; for many the folders are read once.
bool SearchPath::may_be_in(size_t folder, const std::string& file) const {
  constexpr uint32_t kMany = 256;
  if (file.find('/') != std::string::npos || lookups_.fetch_add(1, std::memory_order_relaxed) < kMany) return true;
  const std::vector<std::string>& files = listing()[folder];
  return files.size() >= kMaxListed || std::ranges::binary_search(files, file);
}

std::vector<FoundFile> SearchPath::find_all(std::string_view name) const { return look_up(name, SIZE_MAX); }

std::optional<FoundFile> SearchPath::find(std::string_view name) const {
  std::vector<FoundFile> found = look_up(name, 1);
  if (found.empty()) return std::nullopt;
  return std::move(found.front());
}

const std::vector<std::vector<std::string>>& SearchPath::listing() const {
  std::call_once(listed_, [this] {
    for (const SearchFolder& folder : folders_) {
      auto& files = listing_.emplace_back();
      if (folder.tree) continue;
      std::string unread;  // then nothing is found there
      for (FolderEntry& entry : files_.list(folder.path, &unread)) {
        if (files.size() == kMaxListed) break;
        if (small_letters(entry.name).ends_with(kEnding)) files.push_back(std::move(entry.name));
      }
      std::ranges::sort(files);
    }
  });
  return listing_;
}

const std::vector<SearchPath::Tree>& SearchPath::trees() const {
  std::call_once(walked_, [this] {
    for (const SearchFolder& folder : folders_) {
      Tree& tree = trees_.emplace_back();
      if (folder.tree) walk(folder.path, &tree);
    }
  });
  return trees_;
}

/// A folder and those below it; not where links lead.
void SearchPath::walk(const std::string& folder, Tree* tree) const {
  std::string unread;  // then nothing is found there
  for (const FolderEntry& entry : files_.list(folder, &unread)) {
    if (tree->size() >= kMaxListed) return;
    const std::string path = joined_path(folder, entry.name);
    if (ending_of(entry.name) == kEnding) tree->emplace(entry.name, path);
    if (entry.kind == FileKind::kFolder) walk(path, tree);
  }
}

std::optional<std::string> SearchPath::find_other_case(std::string_view name) const {
  const std::string wanted = small_letters(name) + std::string(kEnding);
  for (size_t i = 0; i < folders_.size(); ++i) {
    for (const std::string& file : listing()[i]) {
      if (small_letters(file) == wanted && file != wanted) return joined_path(folders_[i].path, file);
    }
  }
  return std::nullopt;
}

std::optional<std::string> SearchPath::find_other_ending(std::string_view name) const {
  if (!plain_name(name)) return std::nullopt;
  for (const SearchFolder& folder : folders_) {
    for (const std::string_view ending : {".nc", ".tap", ".cnc", ".gcode", ".txt", ""}) {
      const std::string path = joined_path(folder.path, std::string(name) + std::string(ending));
      if (!folder.tree && files_.is_file(path)) return normal_path(path);
    }
  }
  return std::nullopt;
}

std::vector<std::string> SearchPath::names() const {
  std::vector<std::string> names;
  for (const auto& files : listing()) {
    for (const std::string& file : files) {
      if (file == small_letters(file)) names.push_back(file.substr(0, file.size() - kEnding.size()));
    }
  }
  for (const Tree& tree : trees()) {
    for (const auto& [file, path] : tree) names.push_back(file.substr(0, file.size() - kEnding.size()));
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace owlint
