// How the page of an audit names files: seen from the folders that were audited. The page is mailed and put on servers, where
// nobody needs to know in which folders of which machine a shop keeps its programs.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace owlint::audit {

class ShownPaths {
 public:
  /// `roots` are the paths that were audited.
  explicit ShownPaths(const std::vector<std::string>& roots);

  /// What the roots are called: by the last part of their paths, or by as many parts as tell them apart.
  const std::vector<std::string>& roots() const { return names_; }
  /// Of a file below the roots `mill/plate.ngc`, with the root's name before it where there are several roots. Of a file from
  /// elsewhere `…/subs/drill.ngc`.
  std::string path(const std::string& path) const;
  /// Words in which absolute paths are replaced likewise.
  std::string text(std::string_view words) const;
  /// Remembers the folder of a file from elsewhere: text() then knows it also where blanks in it hide its end.
  void know(const std::string& path);

 private:
  std::string below(const std::string& name) const { return names_.size() > 1 ? name + '/' : ""; }

  std::vector<std::string> names_;
  std::unordered_map<std::string, std::string> roots_;  // names, by path
  std::unordered_set<std::string> elsewhere_;           // folders
};

}  // namespace owlint::audit
