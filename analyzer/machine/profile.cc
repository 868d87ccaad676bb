#include "analyzer/machine/profile.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "analyzer/text/source.h"

namespace owlint {
namespace {

constexpr uint32_t kWarnOnlyBit = 0x20;
constexpr std::array<std::string_view, 4> kVersions = {"2.7", "2.8", "2.9", "2.10"};

std::string_view trim(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool is_true(std::string_view value) {
  std::string lower(value);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "1" || lower == "true" || lower == "yes" || lower == "on" || lower == "y" || lower == "t";
}

void apply_setting(std::string_view key, std::string_view value, Profile* profile) {
  // LinuxCNC takes the first of repeated keys.
  if ((key == "FEATURES" || key == "FEATURE") && !profile->ini_mask) {
    profile->ini_mask = parse_mask(value);
  } else if (key == "OWORD_WARNONLY") {
    profile->ini_warnonly = is_true(value);
  } else if (key == "SUBROUTINE_PATH") {
    profile->ini_has_folders = true;
  }
}

}  // namespace

std::optional<Version> version_from_text(std::string_view text) {
  const auto found = std::ranges::find(kVersions, text);
  if (found == kVersions.end()) return std::nullopt;
  return static_cast<Version>(found - kVersions.begin());
}

std::string_view version_text(Version version) { return kVersions[static_cast<size_t>(version)]; }

std::optional<uint32_t> parse_mask(std::string_view text) {
  text = trim(text);
  int base = 10;
  if (text.starts_with("0x") || text.starts_with("0X")) {
    text.remove_prefix(2);
    base = 16;
  }
  uint32_t mask = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), mask, base);
  if (problem != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return mask;
}

bool Profile::warn_only() const {
  if (feature && (*feature & kWarnOnlyBit) != 0) return true;
  if (ini_warnonly && version >= Version::k2_8) return true;
  const bool mask_counts = !version_given || version < Version::k2_8;
  return mask_counts && ini_mask && (*ini_mask & kWarnOnlyBit) != 0;
}

bool read_ini(const std::string& path, Profile* profile, std::string* error) {
  const auto source = Source::map(path, error);
  if (source == nullptr) return false;
  profile->ini_given = true;
  profile->ini_path = path;
  std::string_view rest = source->bytes();
  bool in_section = false;
  bool in_display = false;
  while (!rest.empty()) {
    const size_t feed = rest.find('\n');
    const std::string_view line = trim(rest.substr(0, feed));
    rest = feed == std::string_view::npos ? std::string_view{} : rest.substr(feed + 1);
    if (line.empty() || line[0] == '#' || line[0] == ';') continue;
    if (line[0] == '[') {
      in_section = line.starts_with("[RS274NGC]");
      in_display = line.starts_with("[DISPLAY]");
      continue;
    }
    const size_t equals = line.find('=');
    if (equals == std::string_view::npos) continue;
    if (in_display && trim(line.substr(0, equals)) == "PROGRAM_PREFIX") profile->ini_has_folders = true;
    if (!in_section) continue;
    apply_setting(trim(line.substr(0, equals)), trim(line.substr(equals + 1)), profile);
  }
  return true;
}

}  // namespace owlint
