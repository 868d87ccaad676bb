#include "analyzer/machine/profile.h"

#include <algorithm>
#include <array>

namespace owlint {
namespace {

constexpr uint32_t kWarnOnlyBit = 0x20;
constexpr std::array<std::string_view, 4> kVersions = {"2.7", "2.8", "2.9", "2.10"};

}  // namespace

std::optional<Version> version_from_text(std::string_view text) {
  const auto found = std::ranges::find(kVersions, text);
  if (found == kVersions.end()) return std::nullopt;
  return static_cast<Version>(found - kVersions.begin());
}

std::string_view version_text(Version version) { return kVersions[static_cast<size_t>(version)]; }

bool Profile::warn_only() const {
  if (feature && (*feature & kWarnOnlyBit) != 0) return true;
  if (setup == nullptr) return false;
  if (setup->warnonly && version >= Version::k2_8) return true;
  return mask_counts() && setup->mask && (*setup->mask & kWarnOnlyBit) != 0;
}

}  // namespace owlint
