// Which paths an ignore file leaves out. The syntax is that of `.gitignore`: one pattern on each line, `#` for comments, `!`
// includes again, `/` at the end means folders, a `/` elsewhere makes the pattern relative to the file's own folder, `**` is
// any number of folders. The last pattern that matches decides. Source: gitignore(5).
// But for git `./name` matches nothing; here it is `/name`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace owlint::checking {

class IgnorePatterns {
 public:
  /// Adds the patterns of a file.
  void add(std::string_view text);
  bool empty() const { return patterns_.empty(); }
  /// Whether a path, relative to the folder of the patterns, is left out (true) or included again (false); nothing if no
  /// pattern matches.
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

}  // namespace owlint::checking
