#include "analyzer/cli/walk.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <unordered_set>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "analyzer/cli/ignore.h"
#include "analyzer/text/parallel.h"
#include "analyzer/text/source.h"

namespace owlint::cli {
namespace {

namespace fs = std::filesystem;

/// Times are kept coarsely, by some file systems in steps of two seconds: what was changed just now may be changed again
/// and look the same.
uint64_t stamp(const struct stat& info) {
  constexpr time_t kCoarse = 2;
  const time_t now = ::time(nullptr);
  if (info.st_mtim.tv_sec + kCoarse >= now || info.st_ctim.tv_sec + kCoarse >= now) return 0;
  const std::array<int64_t, 6> all = {info.st_size, static_cast<int64_t>(info.st_ino), info.st_mtim.tv_sec, info.st_mtim.tv_nsec, info.st_ctim.tv_sec, info.st_ctim.tv_nsec};
  return XXH3_64bits(all.data(), sizeof(all)) | 1;
}

bool has_program_ending(std::string_view name) {
  static constexpr std::array<std::string_view, 5> kEndings = {".ngc", ".nc", ".tap", ".cnc", ".gcode"};
  const size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || name.size() - dot > 6) return false;
  const std::string ending = small_letters(name.substr(dot));
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

using FileId = std::pair<dev_t, ino_t>;

/// What the ignore files of a folder say, and of those above it.
struct Ignored {
  std::shared_ptr<const Ignored> above;
  size_t prefix = 0;  ///< of the folder's path, with the slash
  IgnorePatterns patterns;

  bool leaves_out(std::string_view path, bool folder) const {
    for (const Ignored* at = this; at != nullptr; at = at->above.get()) {
      if (const auto decided = at->patterns.decide(path.substr(at->prefix), folder)) return *decided;
    }
    return false;
  }
};

struct Folder {
  std::string path;  ///< with a slash at its end, empty for the working folder
  std::shared_ptr<const Ignored> ignored;
};

/// What is in one folder.
struct Content {
  std::optional<FileId> id;
  std::vector<WalkedFile> files;
  std::vector<Folder> folders;
  std::vector<std::string> links;
  std::string problem;
  std::string without_ini;  ///< the folder's file_key, where it has no *.ini
};

/// Walks one tree after the other, the folders of a level over all cores; remembers what it has seen.
class Walker {
 public:
  Walker(const WalkOptions& options, Walk& out) : options_(options), out_(out) {
    for (const std::string& pattern : options.exclude) excluded_.add(pattern);
    for (const std::string& pattern : options.include) included_.add(pattern);
  }

  void tree(const std::string& root) {
    const size_t before = out_.files.size();
    walk_tree(root);
    // Links come after everything that is no link, so that a program is known by its own path.
    for (size_t next = 0; next < links_.size(); ++next) {
      const std::string link = links_[next];
      struct stat info {};
      if (::stat(link.c_str(), &info) != 0) continue;  // it leads nowhere
      if (S_ISDIR(info.st_mode)) {
        if (options_.follow_links) walk_tree(link);
      } else if (S_ISREG(info.st_mode)) {
        add_linked(link, info);
      }
    }
    links_.clear();
    // Folder by folder they are nearly in order: merging is faster than partitioning.
    std::ranges::stable_sort(out_.files.begin() + static_cast<std::ptrdiff_t>(before), out_.files.end(), {}, &WalkedFile::path);
    if (out_.files.size() == before) out_.empty.push_back(root);
  }

 private:
  void walk_tree(const std::string& root) {
    std::string path = fs::path(root).lexically_normal().string();
    if (path == "." || path == "./") path.clear();
    if (!path.empty() && !path.ends_with('/')) path += '/';
    std::shared_ptr<const Ignored> ignored;
    if (!excluded_.empty()) ignored = std::make_shared<Ignored>(Ignored{nullptr, path.size(), excluded_});
    std::vector<Folder> level = {{path, ignored}};
    while (!level.empty()) {
      std::vector<Content> contents(level.size());
      for_each(level.size(), [&](size_t i) { contents[i] = read(level[i]); });
      level.clear();
      for (Content& content : contents) {
        if (!content.problem.empty()) out_.problems.push_back(content.problem);
        if (options_.follow_links && content.id && !folders_.insert(*content.id).second) continue;  // by another link
        std::ranges::move(content.files, std::back_inserter(out_.files));
        std::ranges::move(content.folders, std::back_inserter(level));
        std::ranges::move(content.links, std::back_inserter(links_));
        if (!content.without_ini.empty()) out_.without_ini.insert(std::move(content.without_ini));
      }
    }
  }

  Content read(const Folder& folder) const {
    Content content;
    DIR* const open = ::opendir(folder.path.empty() ? "." : folder.path.c_str());
    if (open == nullptr) {
      content.problem = folder.path + ": " + std::strerror(errno);
      return content;
    }
    struct stat info {};
    if (::fstat(::dirfd(open), &info) == 0) content.id = {info.st_dev, info.st_ino};
    const std::shared_ptr<const Ignored> ignored = options_.ignore_files ? ignored_in(folder, ::dirfd(open)) : folder.ignored;
    bool has_ini = false;
    while (const dirent* entry = ::readdir(open)) {
      has_ini = has_ini || std::string_view(static_cast<const char*>(entry->d_name)).ends_with(".ini");
      take(folder, ignored, ::dirfd(open), *entry, &content);
    }
    ::closedir(open);
    if (!has_ini) content.without_ini = file_key(folder.path.size() > 1 ? folder.path.substr(0, folder.path.size() - 1) : folder.path.empty() ? "." : folder.path);
    return content;
  }

  void take(const Folder& folder, const std::shared_ptr<const Ignored>& ignored, int fd, const dirent& entry, Content* content) const {
    const std::string_view name(static_cast<const char*>(entry.d_name));
    if (name.starts_with('.')) return;
    unsigned char type = entry.d_type;
    struct stat info {};
    if (type == DT_UNKNOWN) {  // some file systems do not say
      if (::fstatat(fd, entry.d_name, &info, AT_SYMLINK_NOFOLLOW) != 0) return;
      type = S_ISDIR(info.st_mode) ? DT_DIR : S_ISLNK(info.st_mode) ? DT_LNK : S_ISREG(info.st_mode) ? DT_REG : DT_UNKNOWN;
    }
    if (type == DT_REG && !is_program(name)) return;
    if (type != DT_REG && type != DT_DIR && type != DT_LNK) return;
    std::string path = folder.path + std::string(name);
    if (ignored != nullptr && ignored->leaves_out(path, type == DT_DIR)) return;
    if (type == DT_DIR) {
      content->folders.push_back({path + '/', ignored});
    } else if (type == DT_LNK) {
      content->links.push_back(std::move(path));
    } else if (::fstatat(fd, entry.d_name, &info, AT_SYMLINK_NOFOLLOW) == 0) {
      content->files.push_back({std::move(path), stamp(info), static_cast<uint64_t>(info.st_size)});
    }
  }

  static std::shared_ptr<const Ignored> ignored_in(const Folder& folder, int fd) {
    IgnorePatterns patterns;
    for (const char* name : {".gitignore", ".owlintignore"}) {
      std::string error;
      if (::faccessat(fd, name, F_OK, 0) != 0) continue;
      if (const auto file = Source::map(folder.path + name, &error)) patterns.add(file->bytes());
    }
    if (patterns.empty()) return folder.ignored;
    return std::make_shared<Ignored>(Ignored{folder.ignored, folder.path.size(), std::move(patterns)});
  }

  bool is_program(std::string_view name) const { return has_program_ending(name) || (!included_.empty() && included_.decide(name, false).value_or(false)); }

  void add_linked(const std::string& link, const struct stat& info) {
    const std::string_view name = std::string_view(link).substr(link.rfind('/') + 1);
    if (!is_program(name)) return;
    // A link to a program that is walked itself says nothing new, unless it is called by the link's name.
    if (options_.follow_links) {
      std::error_code problem;
      const std::string target = fs::canonical(link, problem).string();
      if (known_.empty()) {
        for (const WalkedFile& file : out_.files) known_.insert(fs::weakly_canonical(file_key(file.path), problem).string());
      }
      if (!known_.insert(target).second) return;
    }
    out_.files.push_back({link, stamp(info), static_cast<uint64_t>(info.st_size)});
  }

  const WalkOptions& options_;
  Walk& out_;
  IgnorePatterns excluded_, included_;
  std::vector<std::string> links_;
  std::set<FileId> folders_;
  std::unordered_set<std::string> known_;  // where links to files lead, and what is no link
};

}  // namespace

uint64_t stamp_of(const std::string& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0 ? stamp(info) : 0;
}

Walk walk(const std::vector<std::string>& paths, const WalkOptions& options) {
  Walk out;
  Walker walker(options, out);
  for (const std::string& path : paths) {
    std::error_code problem;
    if (path != "-" && fs::is_directory(path, problem)) {
      walker.tree(path);
    } else {
      struct stat info {};
      const bool there = path != "-" && ::stat(path.c_str(), &info) == 0;
      out.files.push_back({path, there ? stamp(info) : 0, there ? static_cast<uint64_t>(info.st_size) : 0});
    }
  }
  if (paths.size() == 1) return out;  // then nothing can be there twice
  std::unordered_set<std::string> seen;
  std::erase_if(out.files, [&](const WalkedFile& file) { return !seen.insert(file_key(file.path)).second; });
  return out;
}

}  // namespace owlint::cli
