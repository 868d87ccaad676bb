// Where LinuxCNC looks for the file of a called sub: the current folder, PROGRAM_PREFIX, the folders of
// SUBROUTINE_PATH in their order, and below WIZARD_ROOT; `name.ngc`, the first one found. Measured with `rs274 -i`.
// After these come the folders of `--sub-path`, for users whose INI is missing or does not fit this computer.
// Unlike LinuxCNC, owlint expands nothing, and no name leads out of these folders.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/text/files.h"

namespace owlint {

/// A file as a call finds it.
struct FoundFile {
  std::string path;
  bool regular = true;  ///< LinuxCNC opens folders and devices too, but finds no sub in them
  size_t folder = 0;    ///< its index in the search path
};

/// A part of the search path.
struct SearchFolder {
  std::string path;
  bool tree = false;  ///< searched with all folders below it

  bool operator==(const SearchFolder&) const = default;
};

class SearchPath {
 public:
  /// `folders` in the order of the search; `files` must outlive this.
  SearchPath(const Files& files, std::vector<SearchFolder> folders) : files_(files), folders_(std::move(folders)) {}

  /// The file that a call of `name` reads.
  std::optional<FoundFile> find(std::string_view name) const;
  /// All files with that name on the search path, the one that LinuxCNC reads first.
  std::vector<FoundFile> find_all(std::string_view name) const;
  /// A file whose name differs from `name.ngc` only in upper and lower case, so that no call finds it.
  std::optional<std::string> find_other_case(std::string_view name) const;
  /// A file `name.nc`, or with another ending of G-code, which no call finds.
  std::optional<std::string> find_other_ending(std::string_view name) const;
  /// The names of all subs that could be called, sorted; read once, when first needed.
  std::vector<std::string> names() const;

  const std::vector<SearchFolder>& folders() const { return folders_; }
  const Files& files() const { return files_; }

 private:
  std::vector<FoundFile> look_up(std::string_view name, size_t most) const;
  using Tree = std::map<std::string, std::string, std::less<>>;  // file name -> path
  /// File names ending in `.ngc` (in any case), by folder; of trees none.
  const std::vector<std::vector<std::string>>& listing() const;
  /// The files of each tree; of other folders none.
  const std::vector<Tree>& trees() const;
  void walk(const std::string& folder, Tree* tree) const;
  std::optional<FoundFile> look_in(size_t folder, const std::string& file) const;
  bool may_be_in(size_t folder, const std::string& file) const;

  const Files& files_;
  std::vector<SearchFolder> folders_;
  mutable std::atomic<uint32_t> lookups_ = 0;
  mutable std::once_flag listed_, walked_;
  mutable std::vector<std::vector<std::string>> listing_;
  mutable std::vector<Tree> trees_;
};

/// Whether LinuxCNC, looking for a file of this name, could do more than open `name.ngc` in its folders.
bool expands(std::string_view name);  ///< a shell would replace parts of it, or run a command
/// Expansion fails, and LinuxCNC crashes: an open quote or back quote, a `\` at the end, `${` without a name, or one of
/// `|&;<>(){}` outside quotes and not behind `*`, `?` or `[` (50 names run by rs274 2.9.4).
bool breaks_expansion(std::string_view name);
bool leaves_folders(std::string_view name);  ///< absolute, `~`, or with `..`

}  // namespace owlint
