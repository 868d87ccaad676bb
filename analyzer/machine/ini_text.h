// A machine's INI line by line, as people see it: every section, key, value and comment with its place, also those that
// no reader of LinuxCNC finds. The rules about INIs (OW412 to OW424) begin here; what the readers make of the same lines is in
// ini.h (2.8 and 2.9), check_config.h (the check before the start) and strict_ini.h (2.10).
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/text/files.h"

namespace owlint {

/// Lines beyond these are not read. The largest INI of a real machine has a few thousand.
inline constexpr size_t kMostIniLines = 100'000;
/// Measured: what follows this many bytes of a line counts as a line of its own.
inline constexpr size_t kLongestIniLine = 255;
/// Measured: so many lines may be continued in a row.
inline constexpr size_t kMostContinued = 20;

struct IniLine {
  enum class Kind : uint8_t {
    kComment,
    kSection,      ///< `[NAME]`, and what follows it
    kOpenSection,  ///< `[NAME` without `]`
    kKey,          ///< with a `=`
    kText,         ///< none of these
  };
  Kind kind = Kind::kText;
  bool continued = false;     ///< its last character is `\`
  bool continuation = false;  ///< the line before is continued, so that LinuxCNC does not see this one
  bool ended = true;          ///< by a line feed
  uint32_t source = 0;        ///< in IniText::sources()
  uint32_t number = 1;        ///< in its file
  int32_t section = -1;       ///< in IniText::sections(): the one that it stands in, or opens
  Span span;                  ///< without blanks at its ends
  Span name;                  ///< of the key, up to the first blank or `=`; of the section, between the brackets
  Span value;                 ///< behind the first `=`, without blanks at its ends; behind `]`: the rest of the line
};

class IniText {
 public:
  /// One line `[NAME]`.
  struct Section {
    std::string name;
    size_t line = 0;     ///< in lines()
    bool first = false;  ///< of that name: the only one that LinuxCNC 2.8 and 2.9 read
  };

  /// `source`: of the INI, if it could be read. Files that it includes are read from `files`.
  void parse(const Files& files, const std::shared_ptr<const Source>& source);

  /// In their order, with those of included files in place; empty lines are left out.
  const std::vector<IniLine>& lines() const { return lines_; }
  const std::vector<Section>& sections() const { return sections_; }
  const std::vector<std::shared_ptr<const Source>>& sources() const { return sources_; }
  bool cut_short() const { return cut_short_; }

  const std::shared_ptr<const Source>& source(const IniLine& line) const { return sources_[line.source]; }
  std::string_view slice(const IniLine& line, Span span) const { return source(line)->slice(span); }
  std::string_view name(const IniLine& line) const { return slice(line, line.name); }
  std::string_view value(const IniLine& line) const { return slice(line, line.value); }
  std::string_view text(const IniLine& line) const { return slice(line, line.span); }
  /// The section that a line stands in; empty before the first one.
  std::string_view section_of(const IniLine& line) const {
    return line.section < 0 ? std::string_view() : std::string_view(sections_[static_cast<size_t>(line.section)].name);
  }
  /// The first section of a name; null if there is none.
  const Section* find_section(std::string_view name) const {
    const auto found = first_.find(name);
    return found == first_.end() ? nullptr : &sections_[found->second];
  }
  /// Whether a line is one that LinuxCNC 2.8 and 2.9 find: in the first section of its name, and no continuation.
  bool is_read(const IniLine& line) const {
    return line.section >= 0 && sections_[static_cast<size_t>(line.section)].first && !line.continuation;
  }
  /// The line on which LinuxCNC finds a key's value, by its place in the file; null if it is on none.
  const IniLine* line_at(const Source& source, uint64_t offset) const;

 private:
  void read(const Files& files, const std::shared_ptr<const Source>& source, bool included);
  void add(std::string_view text, uint32_t source, uint64_t offset, uint32_t number, bool ended);

  std::vector<IniLine> lines_;
  std::vector<Section> sections_;
  std::map<std::string, size_t, std::less<>> first_;  // sections, by name
  std::vector<std::shared_ptr<const Source>> sources_;
  bool cut_short_ = false;
  bool continued_ = false;  // the line before
};

/// `#INCLUDE NAME` at the beginning of a line, as LinuxCNC's start script looks for it; empty if the line is another one.
std::string_view ini_include(std::string_view line);

/// `JOINT_`, `AXIS_` and `SPINDLE_` of `[JOINT_0]` and its like, any other name as it is.
std::string_view section_family(std::string_view section);

}  // namespace owlint
