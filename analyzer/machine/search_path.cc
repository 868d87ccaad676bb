#include "analyzer/machine/search_path.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "analyzer/text/source.h"

namespace owlint {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxListed = 500'000;  // files of one folder, or of a tree, that are remembered
constexpr std::string_view kEnding = ".ngc";

bool plain_name(std::string_view name) {
  return !name.empty() && name.find('\0') == std::string_view::npos && !leaves_folders(name) && !expands(name);
}

std::optional<FoundFile> look(const std::string& path, size_t folder) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0 || ::access(path.c_str(), R_OK) != 0) return std::nullopt;
  return FoundFile{fs::path(path).lexically_normal().string(), S_ISREG(info.st_mode), folder};
}

}  // namespace

bool expands(std::string_view name) { return name.find_first_of("`$") != std::string_view::npos; }

bool breaks_expansion(std::string_view name) {
  if (name.find_first_of("|&;<>(){}\n") != std::string_view::npos) return true;
  return std::ranges::count(name, '\'') % 2 != 0 || std::ranges::count(name, '"') % 2 != 0;
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

SearchPath::SearchPath(std::vector<std::string> folders, std::string tree) : folders_(std::move(folders)), tree_root_(std::move(tree)) {}

std::vector<FoundFile> SearchPath::look_up(std::string_view name, size_t most) const {
  std::vector<FoundFile> found;
  if (!plain_name(name)) return found;
  const std::string file = std::string(name) + std::string(kEnding);
  for (size_t i = 0; i < folders_.size() && found.size() < most; ++i) {
    if (!may_be_in(i, file)) continue;
    if (auto one = look((fs::path(folders_[i]) / file).string(), i)) found.push_back(std::move(*one));
  }
  if (!tree_root_.empty() && found.size() < most) {
    const auto below = tree().find(file);
    if (below != tree().end()) found.push_back({below->second, true, folders_.size()});
  }
  return found;
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
    for (const std::string& folder : folders_) {
      auto& files = listing_.emplace_back();
      std::error_code error;
      fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
      for (; !error && entry != fs::directory_iterator() && files.size() < kMaxListed; entry.increment(error)) {
        std::string file = entry->path().filename().string();
        if (small_letters(file).ends_with(kEnding)) files.push_back(std::move(file));
      }
      std::ranges::sort(files);
    }
  });
  return listing_;
}

const std::map<std::string, std::string, std::less<>>& SearchPath::tree() const {
  std::call_once(walked_, [this] {
    std::error_code error;
    fs::recursive_directory_iterator entry(tree_root_, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator() && tree_.size() < kMaxListed; entry.increment(error)) {
      if (entry->path().extension() == kEnding) tree_.emplace(entry->path().filename().string(), entry->path().string());
    }
  });
  return tree_;
}

std::optional<std::string> SearchPath::find_other_case(std::string_view name) const {
  const std::string wanted = small_letters(name) + std::string(kEnding);
  for (size_t i = 0; i < folders_.size(); ++i) {
    for (const std::string& file : listing()[i]) {
      if (small_letters(file) == wanted && file != wanted) return (fs::path(folders_[i]) / file).string();
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
  if (!tree_root_.empty()) {
    for (const auto& [file, path] : tree()) names.push_back(file.substr(0, file.size() - kEnding.size()));
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace owlint
