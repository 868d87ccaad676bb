// The findings room: one finding, and what decides its severity, whether it is suppressed, how it is fixed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/findings/arc_sketch.h"
#include "analyzer/text/reach.h"
#include "analyzer/text/source.h"

namespace owlint {

/// Ordered: a higher one is worse.
enum class Severity : uint8_t { kOff, kInfo, kWarning, kError };

std::string_view severity_text(Severity severity);
/// `off`, `info`, `warning`, `error`; false for anything else.
bool severity_from_text(std::string_view text, Severity* severity);

std::string_view reach_text(Reach reach);

/// Another line that a finding is about.
struct Related {
  Span span;
  std::string message;
  std::shared_ptr<const Source> source;  ///< the file it is in; null: the finding's own
};

struct Edit {
  Span span;
  std::string text;
};

/// A change that fixes a finding. Safe: a program that ran still runs, with the same output.
struct Fix {
  std::string title;
  bool safe = false;
  std::vector<Edit> edits;
  bool if_all_stop = false;  ///< safe only where every run stops at the finding: skipped, the line was no O-word before
};

/// Another stop that the same mistake causes, on other runs. Not a finding of its own.
struct Consequence {
  std::string_view code;
  Span span;
  std::string interpreter;
};

/// How much a finding may matter, whatever its rule says.
enum class Weight : uint8_t {
  kFull,
  kAside,   ///< never more than info: its file is for another controller, or nothing comes of it here
  kRemark,  ///< nothing that an author has to change: info, and off unless its code is selected
};

struct Finding {
  std::string_view code;
  std::string_view rule;
  Severity severity = Severity::kWarning;
  Span span;                             ///< bytes of the file
  std::shared_ptr<const Source> source;  ///< the file, if it is not the report's
  std::string scope;    ///< the sub and the block that its line belongs to, `o<probe> o100`; empty in the main program
  std::string message;  ///< what is wrong; lower case, no full stop
  std::string help;     ///< how to fix it; may be empty
  std::string interpreter;  ///< the message that LinuxCNC prints; may be empty
  Reach reach = Reach::kMaybe;
  bool stops = false;       ///< the interpreter stops here with this error on some path
  bool further = false;     ///< another mistake of the line stops it first, then this one
  bool unproven = false;    ///< it may not happen on the real machine: never more than a warning
  bool uncertain = false;   ///< unproven, and it depends on what only the program's author knows: info
  bool never_ends = false;  ///< it hangs or crashes here on some path
  bool runs_other = false;  ///< on some path other lines run here than those that are written
  Weight weight = Weight::kFull;
  std::vector<Related> related;
  std::vector<Related>
      path;  ///< the branch outcomes that lead here, or the line that keeps every run away; shown behind `related`
  std::vector<Fix> fixes;
  std::vector<Consequence> consequences;
  std::shared_ptr<const ArcSketch> arc;  ///< what can be drawn of it; or null
  std::string missing;  ///< the file or folder that an INI names and that is not here, if the finding follows from that
  std::string
      group;  ///< findings of one rule and group, wherever they are in a run, are one mistake: see checking/groups.h
  /// The severity where several files of a run have it: what all of them leave out is left out on purpose, and what all of them
  /// call is on the machine. A rule sets it; the driver decides on it as on `severity`.
  std::optional<Severity> habit_severity;
  std::string block_delete;           ///< `on` or `off` if it is about runs with that setting only; empty: both
  std::vector<std::string> versions;  ///< the LinuxCNC versions that have it, if not all that were checked
};

}  // namespace owlint
