// What surrounds a program: the LinuxCNC version, FEATURE 0x20, and the machine that an INI describes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/machine/setup.h"

namespace owlint {

/// A supported LinuxCNC version; ordered by age.
enum class Version : uint8_t { k2_7, k2_8, k2_9, k2_10 };
inline constexpr Version kAllVersions[] = {Version::k2_7, Version::k2_8, Version::k2_9, Version::k2_10};

std::optional<Version> version_from_text(std::string_view text);
std::string_view version_text(Version version);

struct Profile {
  Version version = Version::k2_9;
  bool version_given = false;
  bool block_delete = false;        ///< lines that begin with `/` are skipped: so LinuxCNC starts; off in rs274
  bool measures_extents = false;    ///< how far programs go is noted: Syntax::extents
  std::optional<uint32_t> feature;  ///< from --feature or the configuration
  std::shared_ptr<const MachineSetup> setup;  ///< what the INI says; null without one
  /// Codes in capitals that INIs above the program remap, of which it is not known which one is the machine's; null: none.
  std::shared_ptr<const std::set<std::string>> remapped_perhaps;
  std::vector<std::string>
      sub_path;  ///< folders that users name for called files; the setup's search path has them already

  /// FEATURE 0x20 as interface.md defines it: the documented abort list only warns.
  bool warn_only() const;
  /// Whether LinuxCNC still reads the mask from the INI.
  bool mask_counts() const { return !version_given || version < Version::k2_8; }
  /// Whether a called sub that is not found may be a function of the machine's Python module.
  bool may_be_python() const { return setup != nullptr && setup->has_python; }
};

}  // namespace owlint
