// What surrounds a program: the LinuxCNC version and the settings of the machine's INI that change what O-words do.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace owlint {

/// A supported LinuxCNC version; ordered by age.
enum class Version : uint8_t { k2_7, k2_8, k2_9, k2_10 };

std::optional<Version> version_from_text(std::string_view text);
std::string_view version_text(Version version);

struct Profile {
  Version version = Version::k2_9;
  bool version_given = false;
  bool ini_given = false;
  std::optional<uint32_t> feature;      ///< from --feature or the configuration
  std::optional<uint32_t> ini_mask;     ///< FEATURE or FEATURES of the INI
  bool ini_warnonly = false;            ///< OWORD_WARNONLY of the INI
  bool ini_has_folders = false;         ///< the INI names folders with subs, which are not searched yet
  std::string ini_path;

  /// FEATURE 0x20 as interface.md defines it: the documented abort list only warns.
  bool warn_only() const;
};

/// Reads the settings above from a machine INI. Returns false and a message when it can't be read.
bool read_ini(const std::string& path, Profile* profile, std::string* error);

/// A FEATURE mask in decimal or 0x hexadecimal.
std::optional<uint32_t> parse_mask(std::string_view text);

}  // namespace owlint
