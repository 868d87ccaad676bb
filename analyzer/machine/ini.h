// Reads a LinuxCNC machine INI as LinuxCNC reads it: `[SECTION]`, `KEY = value`, keys that repeat, comments on lines of
// their own, lines continued with `\`, `#INCLUDE`. Source: LinuxCNC's `inivar` on files made for each question
// (tests/interpreter/ini.py compares the two), and what its start script does with `#INCLUDE`.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/text/files.h"

namespace owlint {

class Ini {
 public:
  struct Entry {
    std::string section;
    std::string key;
    std::string value;  ///< without spaces around it; an empty one hides later ones, and counts as none
    std::shared_ptr<const Source> source;  ///< the INI, or a file that it includes
    Span span;                             ///< the value's bytes there
  };

  /// Reads the file `path` and what it includes. Returns false and a message when the INI itself cannot be read.
  bool read(const Files& files, const std::string& path, std::string* error);
  /// Reads bytes; `#INCLUDE` is looked up from the folder of `source->path()`.
  void parse(const Files& files, const std::shared_ptr<const Source>& source);

  /// The value that LinuxCNC uses: the first of a key in the first section of that name. Null if there is none.
  const Entry* find(std::string_view section, std::string_view key) const;
  /// All values of a key that may repeat, in file order, up to an empty one: measured, it ends the list.
  std::vector<const Entry*> all(std::string_view section, std::string_view key) const;
  bool has_section(std::string_view section) const;
  bool has_sections() const { return !sections_.empty(); }

  const std::shared_ptr<const Source>& source() const { return source_; }
  const std::vector<Entry>& entries() const { return entries_; }
  /// Files that `#INCLUDE` names and that cannot be read, with the place.
  const std::vector<Entry>& missing_includes() const { return missing_includes_; }

 private:
  struct Line {
    std::string_view text;
    std::shared_ptr<const Source> source;
    bool ended;  ///< by a line feed
  };
  void read_lines(const Files& files, const std::shared_ptr<const Source>& source, bool included,
                  std::vector<Line>& lines);
  void read_section(const std::vector<Line>& lines, size_t at);

  std::shared_ptr<const Source> source_;
  std::vector<Entry> entries_;
  std::vector<Entry> missing_includes_;
  std::vector<std::string> sections_;
};

/// Whether a file is the INI of a LinuxCNC machine, and not another program's.
bool is_machine_ini(const Files& files, const std::string& path);

/// Replaces `~` and `~/…` by the home folder, as LinuxCNC does in paths of an INI; leaves other text.
std::string expand_home(std::string_view path);

}  // namespace owlint
