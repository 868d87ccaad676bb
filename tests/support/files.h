// Files for tests: the repository's, and folders that vanish after the test.
#pragma once

#include <string>
#include <vector>

namespace owlint::test {

/// The repository's folder, or a path inside it.
std::string repository(const std::string& path = {});

/// All bytes of a file; fails the test when it can't be read.
std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& bytes);

/// All files below a folder, sorted.
std::vector<std::string> files_below(const std::string& folder);

/// Whether this run rewrites expectations and snapshots (OWLINT_UPDATE=1) instead of checking them.
bool updating();

/// An empty folder that is removed with everything in it.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::string& path() const { return path_; }
  /// Writes a file (folders on the way are made) and gives its path.
  std::string write(const std::string& name, const std::string& bytes) const;

 private:
  std::string path_;
};

}  // namespace owlint::test
