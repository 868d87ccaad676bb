#include "analyzer/checking/walk.h"

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
#include <mutex>
#include <optional>
#include <set>
#include <unordered_set>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "analyzer/text/parallel.h"
#include "analyzer/text/paths.h"
#include "analyzer/text/source.h"

namespace owlint::checking {
namespace {

namespace fs = std::filesystem;

/// Times are kept coarsely, by some file systems in steps of two seconds: what was changed just now may be changed again
/// and look the same.
uint64_t stamp(const struct stat& info) {
  constexpr time_t kCoarse = 2;
  const time_t now = ::time(nullptr);
  if (info.st_mtim.tv_sec + kCoarse >= now || info.st_ctim.tv_sec + kCoarse >= now) return 0;
  const std::array<int64_t, 6> all = {info.st_size,        static_cast<int64_t>(info.st_ino),
                                      info.st_mtim.tv_sec, info.st_mtim.tv_nsec,
                                      info.st_ctim.tv_sec, info.st_ctim.tv_nsec};
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

/// Patterns, and how a path that is walked looks from the folder that they are seen from.
class View {
 public:
  View(std::shared_ptr<const FilePatterns> patterns, const std::string& root)
      : patterns_(std::move(patterns)), prefix_(root.size()) {
    const std::string from =
        fs::path(file_key(root.empty() ? "." : root)).lexically_relative(patterns_->folder).string();
    if (from != ".") lead_ = from.ends_with('/') ? from : from + '/';
  }

  std::optional<bool> excludes(std::string_view path, bool folder) const {
    return decide(patterns_->exclude, path, folder);
  }
  /// Whether a file or one of the folders that it lies in is left out.
  bool excludes_from_above(std::string_view file) const {
    const std::string path = lead_ + std::string(file.substr(prefix_));
    for (size_t slash = path.find('/'); slash != std::string::npos; slash = path.find('/', slash + 1)) {
      if (patterns_->exclude.decide(path.substr(0, slash), true).value_or(false)) return true;
    }
    return patterns_->exclude.decide(path, false).value_or(false);
  }
  bool includes(std::string_view path) const { return decide(patterns_->include, path, false).value_or(false); }

 private:
  std::optional<bool> decide(const IgnorePatterns& patterns, std::string_view path, bool folder) const {
    if (patterns.empty()) return std::nullopt;
    return patterns.decide(lead_ + std::string(path.substr(prefix_)), folder);
  }

  std::shared_ptr<const FilePatterns> patterns_;
  std::string lead_;  // from the folder of the patterns to the one that is walked
  size_t prefix_;     // of a path: the folder that is walked, with the slash
};

/// All that hold in a folder.
struct Views {
  std::vector<View> given;  ///< by options: they decide first
  std::optional<View> configured;

  std::optional<bool> excludes(std::string_view path, bool folder) const {
    for (const View& view : given) {
      if (const auto decided = view.excludes(path, folder)) return decided;
    }
    return configured ? configured->excludes(path, folder) : std::nullopt;
  }
  bool includes(std::string_view path) const {
    return std::ranges::any_of(given, [&](const View& view) { return view.includes(path); }) ||
        (configured && configured->includes(path));
  }
};

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
  std::shared_ptr<const Views> views;
  std::shared_ptr<const Ignored> ignored;

  bool takes(const std::string& file, bool is_folder) const {
    if (const auto decided = views->excludes(file, is_folder)) return !*decided;
    return ignored == nullptr || !ignored->leaves_out(file, is_folder);
  }
};

bool is_program(const std::string& file, const Views& views) {
  return has_program_ending(std::string_view(file).substr(file.rfind('/') + 1)) || views.includes(file);
}

struct Link {
  std::string path;
  std::shared_ptr<const Views> views;
};

/// What is in one folder.
struct Content {
  std::optional<FileId> id;
  std::vector<WalkedFile> files;
  std::vector<Folder> folders;
  std::vector<Link> links;
  std::string problem;
  std::string without_ini;  ///< the folder's file_key, where it has no *.ini
};

/// The names in a folder that matter.
struct Listing {
  struct Entry {
    std::string name;
    unsigned char type;
  };
  std::vector<Entry> entries;
  bool has_ini = false, has_ignore_file = false, has_configuration = false;

  void add(const dirent& entry) {
    const std::string_view name(static_cast<const char*>(entry.d_name));
    if (name.ends_with(".ini")) has_ini = true;
    if (name == ".gitignore" || name == ".owlintignore") has_ignore_file = true;
    if (name == "owlint.toml" || name == ".owlint.toml") has_configuration = true;
    if (!name.starts_with('.')) entries.push_back({std::string(name), entry.d_type});
  }
};

/// Walks one tree after the other, the folders of a level over all cores; remembers what it has seen.
class Walker {
 public:
  Walker(const WalkOptions& options, const PatternsIn& patterns, Walk& out)
      : options_(options), patterns_(patterns), out_(out) {}

  void tree(const std::string& root) {
    const size_t before = out_.files.size();
    walk_tree(root);
    // Links come after everything that is no link, so that a program is known by its own path.
    for (size_t next = 0; next < links_.size(); ++next) {
      const Link link = links_[next];
      struct stat info {};
      if (::stat(link.path.c_str(), &info) != 0) continue;  // it leads nowhere
      if (S_ISDIR(info.st_mode)) {
        if (options_.follow_links) walk_tree(link.path);
      } else if (S_ISREG(info.st_mode)) {
        add_linked(link, info);
      }
    }
    links_.clear();
    // Folder by folder they are nearly in order: merging is faster than partitioning.
    std::ranges::stable_sort(out_.files.begin() + static_cast<std::ptrdiff_t>(before), out_.files.end(), {},
                             &WalkedFile::path);
    if (out_.files.size() == before && !options_.allow_empty) {
      out_.problems.push_back("no programs in " + root +
                              " (*.ngc *.nc *.tap *.cnc *.gcode); `--include` adds other names, and `--allow-empty` "
                              "allows a folder without programs");
    }
  }

  /// Whether a file that is named is excluded, by options or by its configuration.
  bool excludes(const std::string& file) {
    const std::string folder = file.substr(0, file.rfind('/') + 1);
    const auto views = views_in(folder, given_views(folder));
    return std::ranges::any_of(views->given, [&](const View& view) { return view.excludes_from_above(file); }) ||
        (views->configured && views->configured->excludes_from_above(file));
  }

 private:
  /// What holds in a folder with a configuration of its own, or in the one that is walked.
  std::shared_ptr<const Views> views_in(const std::string& folder, std::vector<View> given) {
    auto views = std::make_shared<Views>(Views{std::move(given), std::nullopt});
    const std::lock_guard lock(asking_);
    if (auto patterns = patterns_ ? patterns_(folder.empty() ? "." : folder) : nullptr)
      views->configured.emplace(std::move(patterns), folder);
    return views;
  }

  /// The patterns of the options, as they are seen from the folder that is walked and from the working folder.
  std::vector<View> given_views(const std::string& root) const {
    if (options_.exclude.empty() && options_.include.empty()) return {};
    FilePatterns given{file_key("."), {}, {}};
    for (const std::string& pattern : options_.exclude) given.exclude.add(pattern);
    for (const std::string& pattern : options_.include) given.include.add(pattern);
    FilePatterns below = given;
    below.folder = file_key(root.empty() ? "." : root);
    return {View(std::make_shared<FilePatterns>(std::move(below)), root),
            View(std::make_shared<FilePatterns>(std::move(given)), root)};
  }

  void walk_tree(const std::string& root) {
    std::string path = fs::path(root).lexically_normal().string();
    if (path == "." || path == "./") path.clear();
    if (!path.empty() && !path.ends_with('/')) path += '/';
    std::vector<Folder> level = {{path, views_in(path, given_views(path)), nullptr}};
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

  Content read(Folder folder) {
    Content content;
    DIR* const open = ::opendir(folder.path.empty() ? "." : folder.path.c_str());
    if (open == nullptr) {
      content.problem = folder.path + ": " + std::strerror(errno);
      return content;
    }
    struct stat info {};
    if (::fstat(::dirfd(open), &info) == 0) content.id = {info.st_dev, info.st_ino};
    Listing listing;
    while (const dirent* entry = ::readdir(open)) listing.add(*entry);
    if (listing.has_ignore_file && options_.ignore_files) folder.ignored = ignored_in(folder);
    if (listing.has_configuration) folder.views = views_in(folder.path, folder.views->given);
    for (const Listing::Entry& entry : listing.entries) take(folder, ::dirfd(open), entry, &content);
    ::closedir(open);
    if (!listing.has_ini)
      content.without_ini = file_key(folder.path.size() > 1    ? folder.path.substr(0, folder.path.size() - 1)
                                         : folder.path.empty() ? "."
                                                               : folder.path);
    return content;
  }

  static void take(const Folder& folder, int fd, const Listing::Entry& entry, Content* content) {
    unsigned char type = entry.type;
    struct stat info {};
    if (type == DT_UNKNOWN) {  // some file systems do not say
      if (::fstatat(fd, entry.name.c_str(), &info, AT_SYMLINK_NOFOLLOW) != 0) return;
      type = S_ISDIR(info.st_mode) ? DT_DIR
          : S_ISLNK(info.st_mode)  ? DT_LNK
          : S_ISREG(info.st_mode)  ? DT_REG
                                   : DT_UNKNOWN;
    }
    if (type != DT_REG && type != DT_DIR && type != DT_LNK) return;
    std::string path = folder.path + entry.name;
    if (type == DT_REG && !is_program(path, *folder.views)) return;
    if (!folder.takes(path, type == DT_DIR)) return;
    if (type == DT_DIR) {
      content->folders.push_back({path + '/', folder.views, folder.ignored});
    } else if (type == DT_LNK) {
      content->links.push_back({std::move(path), folder.views});
    } else if (::fstatat(fd, entry.name.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0) {
      content->files.push_back({std::move(path), stamp(info), static_cast<uint64_t>(info.st_size)});
    }
  }

  static std::shared_ptr<const Ignored> ignored_in(const Folder& folder) {
    IgnorePatterns patterns;
    for (const char* name : {".gitignore", ".owlintignore"}) {
      std::string error;
      if (const auto file = Source::map(folder.path + name, &error)) patterns.add(file->bytes());
    }
    if (patterns.empty()) return folder.ignored;
    return std::make_shared<Ignored>(Ignored{folder.ignored, folder.path.size(), std::move(patterns)});
  }

  void add_linked(const Link& link, const struct stat& info) {
    if (!is_program(link.path, *link.views)) return;
    // A link to a program that is walked itself says nothing new, unless it is called by the link's name.
    if (options_.follow_links) {
      std::error_code problem;
      const std::string target = fs::canonical(link.path, problem).string();
      if (known_.empty()) {
        for (const WalkedFile& file : out_.files)
          known_.insert(fs::weakly_canonical(file_key(file.path), problem).string());
      }
      if (!known_.insert(target).second) return;
    }
    out_.files.push_back({link.path, stamp(info), static_cast<uint64_t>(info.st_size)});
  }

  const WalkOptions& options_;
  const PatternsIn& patterns_;
  std::mutex asking_;
  Walk& out_;
  std::vector<Link> links_;
  std::set<FileId> folders_;
  std::unordered_set<std::string> known_;  // where links to files lead, and what is no link
};

}  // namespace

uint64_t stamp_of(const std::string& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0 ? stamp(info) : 0;
}

Walk walk(const std::vector<std::string>& paths, const WalkOptions& options, const PatternsIn& patterns) {
  Walk out;
  Walker walker(options, patterns, out);
  for (const std::string& path : paths) {
    std::error_code problem;
    if (path != "-" && fs::is_directory(path, problem)) {
      walker.tree(path);
    } else if (path == "-" || !options.force_exclude || !walker.excludes(path)) {
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

}  // namespace owlint::checking
