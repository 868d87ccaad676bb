#include "analyzer/machine/predefined.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace owlint {
namespace {

struct Predefined {
  std::string_view name;
  Version some = Version::k2_7;  ///< the first version of which some releases have it
  Version all = Version::k2_7;   ///< the first version of which all have it
};

constexpr Version k7 = Version::k2_7;
constexpr Version k8 = Version::k2_8;
constexpr Version k9 = Version::k2_9;
constexpr Version k10 = Version::k2_10;

// In the order of their names.
constexpr Predefined kPredefined[] = {{"_a"},
                                      {"_abs_a", k7, k8},
                                      {"_abs_b", k7, k8},
                                      {"_abs_c", k7, k8},
                                      {"_abs_u", k9, k10},
                                      {"_abs_v", k9, k10},
                                      {"_abs_w", k9, k10},
                                      {"_abs_x", k7, k8},
                                      {"_abs_y", k7, k8},
                                      {"_abs_z", k7, k8},
                                      {"_absolute"},
                                      {"_adaptive_feed"},
                                      {"_b"},
                                      {"_c"},
                                      {"_call_level"},
                                      {"_ccomp"},
                                      {"_coord_system"},
                                      {"_current_pocket"},
                                      {"_current_tool"},
                                      {"_feed"},
                                      {"_feed_hold"},
                                      {"_feed_override"},
                                      {"_flood"},
                                      {"_ijk_absolute_mode"},
                                      {"_imperial"},
                                      {"_incremental"},
                                      {"_inverse_time"},
                                      {"_lathe_diameter_mode"},
                                      {"_lathe_radius_mode"},
                                      {"_line"},
                                      {"_metric"},
                                      {"_metric_machine", k8, k9},
                                      {"_mist"},
                                      {"_motion_mode"},
                                      {"_plane"},
                                      {"_remap_level"},
                                      {"_retract_old_z"},
                                      {"_retract_r_plane"},
                                      {"_rpm"},
                                      {"_selected_pocket"},
                                      {"_selected_tool"},
                                      {"_speed_override"},
                                      {"_spindle_css_mode"},
                                      {"_spindle_cw"},
                                      {"_spindle_on"},
                                      {"_spindle_rpm_mode"},
                                      {"_task"},
                                      {"_tool_offset"},
                                      {"_u"},
                                      {"_units_per_minute"},
                                      {"_units_per_rev"},
                                      {"_v"},
                                      {"_value"},
                                      {"_value_returned"},
                                      {"_vmajor"},
                                      {"_vminor"},
                                      {"_w"},
                                      {"_x"},
                                      {"_y"},
                                      {"_z"}};
static_assert(std::ranges::is_sorted(kPredefined, {}, &Predefined::name));

const Predefined* find(std::string_view name) {
  const auto* found = std::ranges::lower_bound(kPredefined, name, {}, &Predefined::name);
  return found != std::end(kPredefined) && found->name == name ? found : nullptr;
}

constexpr std::string_view kIni = "_ini[";
constexpr std::string_view kHal = "_hal[";

std::string capitals(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return out;
}

/// The entry that `_ini[section]entry` names; LinuxCNC looks for it in capital letters (measured).
const Ini::Entry* ini_entry(std::string_view name, const MachineSetup& setup) {
  const size_t close = name.find(']');
  if (close == std::string_view::npos) return nullptr;
  const Ini::Entry* entry =
      setup.ini.find(capitals(name.substr(kIni.size(), close - kIni.size())), capitals(name.substr(close + 1)));
  return entry != nullptr && !entry->value.empty() ? entry : nullptr;
}

/// Decimal, with a sign and an exponent if it likes; LinuxCNC takes nothing else for a number (measured).
std::optional<double> number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

}  // namespace

NameKind name_kind(std::string_view name, const Profile& profile) {
  if (!name.starts_with('_')) return NameKind::kLocal;
  if (const Predefined* known = find(name)) {
    if (profile.version >= known->all) return NameKind::kPredefined;
    return profile.version >= known->some ? NameKind::kSomeReleases : NameKind::kGlobal;
  }
  const bool ini = name.starts_with(kIni);
  if (!ini && !name.starts_with(kHal)) return NameKind::kGlobal;
  // Before 2.8 the FEATURE mask switched both on.
  if (profile.setup == nullptr || profile.version < Version::k2_8) return NameKind::kOfMachine;
  if (!ini) return profile.setup->reads_hal ? NameKind::kOfMachine : NameKind::kGlobal;
  return ini_number(name, profile) ? NameKind::kPredefined : NameKind::kGlobal;
}

std::optional<double> ini_number(std::string_view name, const Profile& profile) {
  if (!name.starts_with(kIni) || profile.setup == nullptr || !profile.setup->reads_ini) return std::nullopt;
  const Ini::Entry* entry = ini_entry(name, *profile.setup);
  return entry == nullptr ? std::nullopt : number(entry->value);
}

bool is_ini_text(std::string_view name, const Profile& profile) {
  if (!name.starts_with(kIni) || profile.setup == nullptr) return false;
  const Ini::Entry* entry = ini_entry(name, *profile.setup);
  return entry != nullptr && !number(entry->value);
}

std::optional<Version> predefined_since(std::string_view name) {
  const Predefined* known = find(name);
  return known == nullptr ? std::nullopt : std::optional(known->some);
}

std::vector<std::string> predefined_names(Version version) {
  std::vector<std::string> names;
  for (const Predefined& known : kPredefined) {
    if (version >= known.all) names.emplace_back(known.name);
  }
  return names;
}

bool may_be_predefined(std::string_view name) {
  return name.starts_with('_') && (find(name) != nullptr || name.starts_with(kIni) || name.starts_with(kHal));
}

bool fixed_by_machine(std::string_view name) {
  constexpr std::string_view kFixed[] = {"_metric_machine", "_task", "_vmajor", "_vminor"};
  return name.starts_with(kIni) || std::ranges::find(kFixed, name) != std::end(kFixed);
}

bool read_only_number(long number, Version version) {
  if (number >= 5021 && number <= 5029) return version >= Version::k2_10;
  return (number >= 5400 && number <= 5413) || (number >= 5420 && number <= 5428);
}

}  // namespace owlint
