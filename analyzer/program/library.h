// The called files of a run. Each is read and parsed once, even if many programs call it from many threads.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "analyzer/machine/profile.h"
#include "analyzer/program/program.h"
#include "analyzer/text/files.h"

namespace owlint {

class Library {
 public:
  /// `files` must outlive this, and the search paths that it makes.
  explicit Library(const Files& files) : files_(files) {}

  const Files& files() const { return files_; }

  /// The files that a run checks. Findings use these names, however a call finds the file.
  void name_files(std::vector<std::string> paths);
  /// A file has changed: it is read again when needed.
  void forget(const std::string& path);

  /// The program in the file that a call found; an empty one if there is nothing that LinuxCNC could
  /// read (a folder, a device, a file that was deleted). Never null.
  std::shared_ptr<const Program> load_called(const std::string& path, const Profile& profile = {});
  /// The program in a file that is checked itself. It is kept if others may call it, that is, if it defines the sub with
  /// its own name.
  std::shared_ptr<const Program> load(std::shared_ptr<const Source> source, const Profile& profile = {});

  /// Where the files that a program calls are looked for: as the INI says, or without one in the program's own folder and
  /// those of `--sub-path`.
  std::shared_ptr<const SearchPath> search_path(const std::string& program, const Profile& profile);

  /// How many files were parsed, how many of them for calls, and how many calls lead to one.
  size_t parsed() const { return parsed_; }
  size_t called() const { return called_; }
  size_t uses() const { return uses_; }

 private:
  struct Slot {
    std::once_flag once;
    std::string path;  ///< by which it is read if it is called
    std::shared_ptr<const Program> program;
    bool called = false;
  };
  std::shared_ptr<Slot> slot(const std::string& path, const std::string& key, bool for_call);
  const Files& files_;
  std::mutex mutex_;
  std::vector<std::string> unnamed_;  // of name_files(), until something is called: most runs need no names
  std::unordered_map<std::string, std::string> names_;  // after that, by file_key()
  std::map<std::string, std::shared_ptr<Slot>> slots_;  // by file_key() and, behind a NUL, WordsOfMachine::key()
  std::map<std::vector<std::string>, std::shared_ptr<const SearchPath>>
      search_paths_;  // without an INI, by their folders
  std::atomic<size_t> parsed_ = 0;
  std::atomic<size_t> called_ = 0;
  std::atomic<size_t> uses_ = 0;
};

}  // namespace owlint
