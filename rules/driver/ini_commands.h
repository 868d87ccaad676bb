// Lines of G-code in a machine's INI, each run as a program of its own: what it stops with, in the subs that it calls, too.
#pragma once

#include <string>
#include <vector>

#include "rules/driver/machine_rules.h"

namespace owlint::rules {

enum class RunsAt : uint8_t {
  kStart,  ///< before any other code: the machine has just been started
  kAny,    ///< when an operator wants it: any modes may be in effect, at any place
};

/// Each run of the line stops here.
struct CommandStop {
  std::string_view code;  ///< of the rule that says so
  Span span;              ///< of the line: what is wrong, or the line's call
  std::string message, help, interpreter;
  std::vector<Related> related;
  bool in_sub = false;  ///< the line itself is fine
};

class CommandRuns {
 public:
  explicit CommandRuns(const SetupInput& in) : in_(in) {}

  /// In the order of the line; those of subs come last. A sub that is nowhere is another rule's: only if `missing_subs`.
  std::vector<CommandStop> stops(const std::string& code, RunsAt when, bool missing_subs = false) const;
  /// The line moves an axis beyond a limit, wherever the machine is and in whichever modes: what OW907 says of it.
  std::vector<CommandStop> beyond_limits(const std::string& code) const;
  /// `o<sub> call` with `values` arguments reads more than these: what OW507 says of it; empty if it does not.
  std::vector<Finding> unpassed(const std::string& sub, size_t values) const;
  /// The lines of the called subs that each run gets to: those before any branch.
  struct SubLine {
    std::string code;  ///< bare_code() of it
    Related place;
  };
  std::vector<SubLine> lines_in_subs(const std::string& code) const;

 private:
  const SetupInput& in_;
};

/// Without comments, in upper case, so that words can be looked for.
std::string bare_code(std::string_view code);
/// Whether a line without comments has a code, such as `M` and 6; `G38.2` counts as 38.
bool has_code(std::string_view line, char letter, int number);

}  // namespace owlint::rules
