// From paths on the command line to files.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

namespace owlint::cli {

struct WalkOptions {
  bool follow_links = false;         ///< links to folders are followed; what they lead to is taken once
  bool ignore_files = true;          ///< `.gitignore` and `.owlintignore` in the folders are heeded
  std::vector<std::string> exclude;  ///< patterns as in an ignore file, seen from the folder that is walked
  std::vector<std::string> include;  ///< patterns of file names that are programs as well
};

struct WalkedFile {
  std::string path;
  uint64_t stamp = 0;  ///< changes whenever the file's size, times or inode do; 0: look at its bytes
  uint64_t bytes = 0;
};

struct Walk {
  std::vector<WalkedFile> files;      ///< in the order in which they are reported; each once
  std::vector<std::string> problems;  ///< messages for people, about paths that cannot be read
  std::vector<std::string> empty;     ///< folders without programs
  std::unordered_set<std::string> without_ini;  ///< folders that were read and have no *.ini, by their file_key
};

/// Files are taken whatever their name; folders are searched for *.ngc *.nc *.tap *.cnc *.gcode in any case, sorted,
/// without hidden folders.
Walk walk(const std::vector<std::string>& paths, const WalkOptions& options);

/// The stamp of a file now; 0 where there is none, or it is too young for its times to tell a change.
uint64_t stamp_of(const std::string& path);

}  // namespace owlint::cli
