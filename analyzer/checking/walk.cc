#include "analyzer/checking/walk.h"

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_set>

#include "analyzer/machine/ini.h"
#include "analyzer/text/parallel.h"
#include "analyzer/text/paths.h"
#include "analyzer/text/source.h"

namespace owlint::checking {
namespace {

bool has_program_ending(std::string_view name) {
  static constexpr std::array<std::string_view, 5> kEndings = {".ngc", ".nc", ".tap", ".cnc", ".gcode"};
  const size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || name.size() - dot > 6) return false;
  const std::string ending = small_letters(name.substr(dot));
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

/// Patterns, and how a path that is walked looks from the folder that they are seen from.
class View {
 public:
  View(std::shared_ptr<const FilePatterns> patterns, const std::string& root)
      : patterns_(std::move(patterns)), prefix_(root.size()) {
    const std::string from = relative_path(file_key(root.empty() ? "." : root), patterns_->folder);
    if (from != ".") lead_ = from + '/';
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
  std::string real_path;  ///< without links, where links to folders are followed

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
  std::vector<WalkedFile> files;
  std::vector<Folder> folders;
  std::vector<Link> links;
  std::string problem;
  std::string without_ini;  ///< the folder's file_key, where it has no *.ini
};

/// The names in a folder that matter.
struct Listing {
  std::vector<FolderEntry> entries;
  bool has_ini = false, has_ignore_file = false, has_configuration = false;

  explicit Listing(std::vector<FolderEntry> all) : entries(std::move(all)) {
    std::erase_if(entries, [this](const FolderEntry& entry) {
      const std::string& name = entry.name;
      if (name.ends_with(".ini")) has_ini = true;
      if (name == ".gitignore" || name == ".owlintignore") has_ignore_file = true;
      if (name == "owlint.toml" || name == ".owlint.toml") has_configuration = true;
      return name.starts_with('.');
    });
  }
};

/// Walks one tree after the other, the folders of a level over all cores; remembers what it has seen.
class Walker {
 public:
  Walker(const Files& files, const WalkOptions& options, const PatternsIn& patterns, Walk& out)
      : files_(files), options_(options), patterns_(patterns), out_(out) {}

  void tree(const std::string& root) {
    const size_t before = out_.files.size();
    walk_tree(root);
    // Links come after everything that is no link, so that a program is known by its own path.
    for (size_t next = 0; next < links_.size(); ++next) {
      const Link link = links_[next];
      const FileInfo info = files_.info(link.path);
      if (info.kind == FileKind::kFolder && options_.follow_links) walk_tree(link.path);
      if (info.kind == FileKind::kFile) add_linked(link, info);
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
    std::string path = normal_path(root);
    if (path == "." || path == "./") path.clear();
    if (!path.empty() && !path.ends_with('/')) path += '/';
    const std::string real_path = options_.follow_links ? files_.real_path(root) : std::string();
    std::vector<Folder> level = {{path, views_in(path, given_views(path)), nullptr, real_path}};
    while (!level.empty()) {
      std::vector<Content> contents(level.size());
      for_each(level.size(), [&](size_t i) { contents[i] = read(level[i]); });
      std::vector<Folder> next;
      for (size_t i = 0; i < level.size(); ++i) {
        Content& content = contents[i];
        if (!content.problem.empty()) out_.problems.push_back(content.problem);
        if (options_.follow_links && !folders_.insert(level[i].real_path).second) continue;  // by another link
        std::ranges::move(content.files, std::back_inserter(out_.files));
        std::ranges::move(content.folders, std::back_inserter(next));
        std::ranges::move(content.links, std::back_inserter(links_));
        if (!content.without_ini.empty()) out_.without_ini.insert(std::move(content.without_ini));
      }
      level = std::move(next);
    }
  }

  Content read(Folder folder) {
    Content content;
    const std::string name = folder.path.empty() ? "." : folder.path;
    std::string error;
    const Listing listing(files_.list(name, &error));
    if (!error.empty()) {
      content.problem = folder.path + ": " + error;
      return content;
    }
    if (listing.has_ignore_file && options_.ignore_files) folder.ignored = ignored_in(folder);
    if (listing.has_configuration) folder.views = views_in(folder.path, folder.views->given);
    for (const FolderEntry& entry : listing.entries) take(folder, entry, &content);
    if (!listing.has_ini) content.without_ini = file_key(name.size() > 1 ? name.substr(0, name.size() - 1) : name);
    return content;
  }

  void take(const Folder& folder, const FolderEntry& entry, Content* content) const {
    if (entry.kind == FileKind::kOther) return;
    std::string path = folder.path + entry.name;
    if (entry.kind == FileKind::kFile && !is_program(path, *folder.views) && !is_ini(path)) return;
    if (!folder.takes(path, entry.kind == FileKind::kFolder)) return;
    if (entry.kind == FileKind::kFolder) {
      content->folders.push_back({path + '/', folder.views, folder.ignored,
                                  folder.real_path.empty() ? "" : joined_path(folder.real_path, entry.name)});
    } else if (entry.kind == FileKind::kLink) {
      content->links.push_back({std::move(path), folder.views});
    } else if (const FileInfo info = files_.info(path); info.kind == FileKind::kFile) {
      content->files.push_back({std::move(path), info.stamp, info.bytes});
    }
  }

  bool is_ini(const std::string& path) const {
    return options_.takes_inis && ending_of(path) == ".ini" && is_machine_ini(files_, path);
  }

  std::shared_ptr<const Ignored> ignored_in(const Folder& folder) const {
    IgnorePatterns patterns;
    for (const char* name : {".gitignore", ".owlintignore"}) {
      std::string error;
      if (const auto file = files_.read(folder.path + name, &error)) patterns.add(file->bytes());
    }
    if (patterns.empty()) return folder.ignored;
    return std::make_shared<Ignored>(Ignored{folder.ignored, folder.path.size(), std::move(patterns)});
  }

  void add_linked(const Link& link, const FileInfo& info) {
    if (!is_program(link.path, *link.views)) return;
    // A link to a program that is walked itself says nothing new, unless it is called by the link's name.
    if (options_.follow_links) {
      if (known_.empty()) {
        for (const WalkedFile& file : out_.files) known_.insert(files_.real_path(file.path));
      }
      if (!known_.insert(files_.real_path(link.path)).second) return;
    }
    out_.files.push_back({link.path, info.stamp, info.bytes});
  }

  const Files& files_;
  const WalkOptions& options_;
  const PatternsIn& patterns_;
  std::mutex asking_;
  Walk& out_;
  std::vector<Link> links_;
  // Only where links to folders are followed, without links.
  std::unordered_set<std::string> folders_;
  std::unordered_set<std::string> known_;  // where links to files lead, and what is no link
};

}  // namespace

Walk walk(const Files& files, const std::vector<std::string>& paths, const WalkOptions& options,
          const PatternsIn& patterns) {
  Walk out;
  Walker walker(files, options, patterns, out);
  for (const std::string& path : paths) {
    const FileInfo info = path == "-" ? FileInfo() : files.info(path);
    if (info.kind == FileKind::kFolder) {
      walker.tree(path);
    } else if (path == "-" || !options.force_exclude || !walker.excludes(path)) {
      out.files.push_back({path, info.stamp, info.bytes});
    }
  }
  if (paths.size() == 1) return out;  // then nothing can be there twice
  std::unordered_set<std::string> seen;
  std::erase_if(out.files, [&](const WalkedFile& file) { return !seen.insert(file_key(file.path)).second; });
  return out;
}

}  // namespace owlint::checking
