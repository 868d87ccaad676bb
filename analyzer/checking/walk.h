// From paths on the command line to files.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_set>
#include <vector>

#include "analyzer/checking/ignore.h"
#include "analyzer/text/files.h"

namespace owlint::checking {

struct WalkOptions {
  bool follow_links = false;   ///< links to folders are followed; what they lead to is taken once
  bool ignore_files = true;    ///< `.gitignore` and `.owlintignore` in the folders are heeded
  bool allow_empty = false;    ///< a folder without programs is no problem
  bool force_exclude = false;  ///< what is excluded is left out also where it is named
  bool takes_inis = false;     ///< `*.ini` is a machine's INI, and no program; folders are searched for them as well
  /// Patterns as in an ignore file, seen from the folder that is walked and from the working folder: what is left out, and
  /// which files are programs as well.
  std::vector<std::string> exclude, include;
};

/// What a configuration file says of the files below its folder.
struct FilePatterns {
  std::string folder;  ///< absolute; the patterns are seen from here
  IgnorePatterns exclude, include;
};

/// The patterns of the configuration that holds in a folder; null for none. Asked for the folders that are walked and for those
/// that have a configuration file, one call at a time.
using PatternsIn = std::function<std::shared_ptr<const FilePatterns>(const std::string& folder)>;

struct WalkedFile {
  std::string path;
  uint64_t stamp = 0;  ///< as in FileInfo
  uint64_t bytes = 0;
};

struct Walk {
  std::vector<WalkedFile> files;  ///< in the order in which they are reported; each once
  std::vector<std::string>
      problems;  ///< messages for people, about paths that cannot be read and folders without programs
  std::unordered_set<std::string> without_ini;  ///< folders that were read and have no *.ini, by their file_key
};

/// Files are taken whatever their name; folders are searched for *.ngc *.nc *.tap *.cnc *.gcode in any case, sorted,
/// without hidden folders. What decides about a file: the options before its configuration, and that before ignore files.
Walk walk(const Files& files, const std::vector<std::string>& paths, const WalkOptions& options,
          const PatternsIn& patterns = nullptr);

}  // namespace owlint::checking
