// Which codes and axes the words of a program have on its machine: the table of codes, and what the INI adds to it and takes
// away. And what else of the machine decides whether a line runs: spindles and tools.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/machine/profile.h"
#include "analyzer/syntax/codes.h"
#include "analyzer/syntax/modes.h"

namespace owlint {

/// The release whose table of codes holds for a profile. Up to 2.9 that of the interpreter with which all is measured.
Release release_of(const Profile& profile);

/// The code that a REMAP line of an INI (`M400 modalgroup=10 …`) is for, and what it runs; the result points into the line.
/// Nothing for lines that LinuxCNC refuses, and for M codes that stay what they are. Built-in G codes, which stay, too, are
/// among them.
std::optional<RemappedCode> remapped_code(std::string_view remap, Release release);

/// The code whose meaning such a line takes away, as LinuxCNC cannot remap it. Nothing for other codes, for lines that LinuxCNC
/// refuses, and for M98 and M99, which are read before.
std::optional<LostCode> lost_code(std::string_view remap, Release release);

/// The entry of an INI that limits an axis (by Axis): `[AXIS_X]MAX_LIMIT`, or if it has none, that of its joint, where each joint
/// is an axis. Null if there is none. Limits are in units of the machine.
const Ini::Entry* limit_entry(const Ini& ini, size_t axis, bool greatest);

struct WordsOfMachine {
  explicit WordsOfMachine(const Profile& profile);
  WordsOfMachine(const WordsOfMachine&) = delete;
  WordsOfMachine& operator=(const WordsOfMachine&) = delete;

  /// Equal for machines on which all lines of words are read alike.
  std::string key() const;

  std::vector<RemappedCode> remapped;
  std::vector<LostCode> lost;
  std::vector<Tool> tools;
  ModeState start;                            ///< the modes in which a program begins: start-up code has run
  MachineWords words;                         ///< refers to these
  std::shared_ptr<const MachineSetup> setup;  ///< to which `remapped` refers
};

}  // namespace owlint
