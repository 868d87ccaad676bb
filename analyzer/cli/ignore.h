// Which paths an ignore file leaves out, in the language of `.gitignore`: a pattern a line, `#` comments, `!` takes back,
// `/` at the end means folders, a `/` elsewhere ties it to the file's own folder, `**` is any number of folders. The last
// pattern that fits decides. Source: gitignore(5).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace owlint::cli {

class IgnorePatterns {
 public:
  /// Adds what a file says.
  void add(std::string_view text);
  bool empty() const { return patterns_.empty(); }
  /// Whether a path, seen from the folder of the patterns, is left out (true) or taken back (false); nothing where no
  /// pattern fits.
  std::optional<bool> decide(std::string_view relative, bool folder) const;

 private:
  struct Pattern {
    std::vector<std::string> parts;  // between the slashes
    bool taken_back = false;
    bool folders_only = false;
  };
  void add_line(std::string_view line);
  std::vector<Pattern> patterns_;
};

}  // namespace owlint::cli
