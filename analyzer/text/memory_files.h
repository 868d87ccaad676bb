// Files that are not on disk.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "analyzer/text/files.h"

namespace owlint {

/// Files and folders in memory, and no others: for tests, and for programs that stand alone. Errors are those of disk().
class MemoryFiles : public Files {
 public:
  /// Adds a file, or replaces one; the folders that it lies in are made, as for all that is added. One that begins with `#!`
  /// may be executed.
  void add_file(const std::string& path, std::string bytes);
  void add_folder(const std::string& path);
  /// `target`: absolute, or seen from the link's folder; it need not exist.
  void add_link(const std::string& path, const std::string& target);
  /// A FIFO, a device or the like.
  void add_other(const std::string& path);
  /// From now on what has been added by this path can be neither read nor entered.
  void forbid(const std::string& path);

  std::shared_ptr<const Source> read(const std::string& path, std::string* error) const override;
  FileInfo info(const std::string& path) const override;
  bool readable(const std::string& path) const override;
  std::vector<FolderEntry> list(const std::string& folder, std::string* error) const override;
  std::string real_path(const std::string& path) const override;

 private:
  struct Node {
    FileKind kind;
    std::string text;  ///< of a file its bytes, of a link where it leads
    bool forbidden = false;
  };
  /// Where a path leads.
  struct Place {
    std::string path;  ///< without links, as far as it exists
    const Node* node;  ///< null: nothing is there
    int problem;       ///< why there is nothing, as in errno
  };
  void add(const std::string& path, Node node);
  Place find(const std::string& path) const;

  std::map<std::string, Node, std::less<>> nodes_;  // by their absolute paths, without the slash at the end
};

/// Other files, some of which have a text that is not saved: standard input, an open document, a fix that is not written.
/// Only their bytes are others: what exists, and where, is as it was saved.
class UnsavedFiles : public Files {
 public:
  /// The text of a file that is not saved, null for all others. It may be asked from many threads.
  using Text = std::function<std::shared_ptr<const Source>(const std::string& path)>;

  UnsavedFiles(const Files& saved, Text text) : saved_(saved), text_(std::move(text)) {}

  std::shared_ptr<const Source> read(const std::string& path, std::string* error) const override {
    auto text = text_(path);
    return text != nullptr ? text : saved_.read(path, error);
  }
  FileInfo info(const std::string& path) const override { return saved_.info(path); }
  bool readable(const std::string& path) const override { return saved_.readable(path); }
  std::vector<FolderEntry> list(const std::string& folder, std::string* error) const override {
    return saved_.list(folder, error);
  }
  std::string real_path(const std::string& path) const override { return saved_.real_path(path); }

 private:
  const Files& saved_;
  Text text_;
};

}  // namespace owlint
