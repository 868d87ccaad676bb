// The REMAP lines of an INI, for the rules about them.
#pragma once

#include <string>
#include <vector>

#include "analyzer/machine/remap_line.h"
#include "analyzer/program/machine_words.h"
#include "rules/driver/machine_rules.h"

namespace owlint::rules {

struct Remap {
  const IniLine* line = nullptr;
  RemapLine read;
  const IniLine* earlier = nullptr;  ///< the line that remaps the same code
};

/// Those that the interpreter reads, up to an empty one. Values that go on in the next line are left out.
std::vector<Remap> remaps_of(const IniText& text);

/// A code whose meaning a line takes away, as LinuxCNC cannot remap it.
struct LostRemap {
  const IniLine* line = nullptr;
  LostCode code;
  std::string name;      ///< as messages show it: `M5`
  bool crashes = false;  ///< LinuxCNC looks outside of its table for it (measured)
};
/// Those of the machine; none without its INI.
std::vector<LostRemap> lost_codes(const Profile& profile);
/// Adds the line to a finding about a program that uses the code, and what to do.
void blame(const Profile& profile, const LostRemap& lost, Finding& f);

/// A part of the line's value as a span of its file.
Span span_in(const IniText& text, const IniLine& line, std::string_view part);

/// The file of an `ngc=`; empty if it is nowhere.
std::string remap_file(const MachineSetup& setup, std::string_view ngc);

/// Whether a G code, in tenths, is a built-in motion, so that no REMAP of it is ever used (measured).
bool is_built_in_motion(int code);
/// Whether an M code of this modal group is the built-in one inside its own sub (measured).
bool is_built_in_inside(int code, int group);
/// What to do about an M code that calls its own sub again in that sub.
std::string help_for_own_code(int code);

}  // namespace owlint::rules
