// The one way to files and folders: no room below the front ends reads them otherwise. A Files comes from whoever starts the
// work: disk() from the command line, files in memory from tests, and unsaved text from an editor (memory_files.h).
//
// Symbolic links are followed, wherever they lead; list() alone tells that an entry is one. Where links go round in a circle,
// there is no file. What is neither file nor folder (a FIFO, a socket, a device) is there, but never read: to open it could
// hang, and its bytes need not end.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "analyzer/text/source.h"

namespace owlint {

enum class FileKind : uint8_t { kNone, kFile, kFolder, kLink, kOther };

/// What is known of a file without reading it.
struct FileInfo {
  FileKind kind = FileKind::kNone;  ///< kNone: there is nothing; never kLink
  uint64_t bytes = 0;
  bool executable = false;  ///< its owner may execute it
  uint64_t stamp = 0;  ///< changes with the file's size, times or inode; 0: only its bytes tell whether it has changed
};

struct FolderEntry {
  std::string name;
  FileKind kind = FileKind::kOther;  ///< of the entry itself: kLink for a link, wherever it leads
};

/// Relative paths are seen from the working folder. All of it may be asked from many threads.
class Files {
 public:
  Files() = default;
  virtual ~Files() = default;
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  /// The bytes of a file, which reports then name by `path`. Null and a message for people if it cannot be read, or is none.
  virtual std::shared_ptr<const Source> read(const std::string& path, std::string* error) const = 0;
  virtual FileInfo info(const std::string& path) const = 0;
  /// Whether this user may read it.
  virtual bool readable(const std::string& path) const = 0;
  /// What is in a folder, in no order, without `.` and `..`. Empty, with a message for people, if it cannot be read.
  virtual std::vector<FolderEntry> list(const std::string& folder, std::string* error) const = 0;
  /// The absolute path without links; what does not exist is kept as it is.
  virtual std::string real_path(const std::string& path) const = 0;

  bool exists(const std::string& path) const { return info(path).kind != FileKind::kNone; }
  bool is_file(const std::string& path) const { return info(path).kind == FileKind::kFile; }
  bool is_folder(const std::string& path) const { return info(path).kind == FileKind::kFolder; }
  /// The shortest path from the working folder, both without links.
  std::string seen_from_here(const std::string& path) const;
};

/// The files of this computer.
const Files& disk();

}  // namespace owlint
