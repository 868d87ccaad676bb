#include "analyzer/flow/parameters.h"

#include <algorithm>

namespace owlint::flow {
namespace {

// LinuxCNC's predefined named parameters; each was tried: reading works, assigning stops.
constexpr std::string_view kPredefined[] = {
    "_a", "_abs_a", "_abs_b", "_abs_c", "_abs_x", "_abs_y", "_abs_z", "_absolute", "_adaptive_feed", "_b", "_c",
    "_call_level", "_ccomp", "_coord_system", "_current_pocket", "_current_tool", "_feed", "_feed_hold",
    "_feed_override", "_flood", "_ijk_absolute_mode", "_imperial", "_incremental", "_inverse_time",
    "_lathe_diameter_mode", "_lathe_radius_mode", "_line", "_metric", "_mist", "_motion_mode", "_plane",
    "_remap_level", "_retract_old_z", "_retract_r_plane", "_rpm", "_selected_pocket", "_selected_tool",
    "_speed_override", "_spindle_css_mode", "_spindle_cw", "_spindle_on", "_spindle_rpm_mode", "_task",
    "_tool_offset", "_u", "_units_per_minute", "_units_per_rev", "_v", "_value", "_value_returned", "_vmajor",
    "_vminor", "_w", "_x", "_y", "_z"};

}  // namespace

bool is_global_name(std::string_view name) { return name.starts_with('_'); }

bool predefined_name(std::string_view name) { return is_global_name(name) && std::ranges::binary_search(kPredefined, name); }

bool machine_name(std::string_view name) { return name.starts_with("_ini[") || name.starts_with("_hal["); }

bool read_only_number(long number) {
  return (number >= 5400 && number <= 5413) || (number >= 5420 && number <= 5428);
}

}  // namespace owlint::flow
