#include "analyzer/machine/ini_keys.h"

#include <algorithm>
#include <array>

#include "analyzer/machine/ini_text.h"

namespace owlint {
namespace {

using Type = IniKey::Type;

constexpr bool kRefuses = true;
constexpr bool kSeveral = true;

constexpr IniKey kKeys[] = {
    {"EMC", "VERSION"},
    {"EMC", "MACHINE"},
    {"EMC", "DEBUG"},
    {"EMC", "RS274NGC_STARTUP_CODE", Type::kGcode},
    {"DISPLAY", "DISPLAY"},
    {"DISPLAY", "PROGRAM_PREFIX", Type::kPath},
    {"DISPLAY", "NGCGUI_SUBFILE", Type::kText, false, kSeveral},
    {"DISPLAY", "NGCGUI_SUBFILE_PATH", Type::kPaths},
    {"DISPLAY", "LATHE"},
    {"DISPLAY", "MAX_FEED_OVERRIDE", Type::kNumber},
    {"TASK", "TASK"},
    {"TASK", "CYCLE_TIME"},
    {"TASK", "INTERPRETER"},
    {"RS274NGC", "PARAMETER_FILE", Type::kPath},
    {"RS274NGC", "SUBROUTINE_PATH", Type::kPaths},
    {"RS274NGC", "USER_M_PATH", Type::kPaths},
    {"RS274NGC", "REMAP", Type::kRemap, false, kSeveral},
    {"RS274NGC", "RS274NGC_STARTUP_CODE", Type::kGcode},
    {"RS274NGC", "ON_ABORT_COMMAND", Type::kGcode},
    {"RS274NGC", "INI_VARS", Type::kSwitch, false, false, true},
    {"RS274NGC", "HAL_PIN_VARS", Type::kSwitch, false, false, true},
    {"RS274NGC", "OWORD_NARGS", Type::kSwitch},
    {"RS274NGC", "NO_DOWNCASE_OWORD", Type::kSwitch},
    {"RS274NGC", "OWORD_WARNONLY", Type::kSwitch},
    {"RS274NGC", "RETAIN_G43", Type::kSwitch},
    {"RS274NGC", "DISABLE_FANUC_STYLE_SUB", Type::kInteger},
    {"RS274NGC", "DISABLE_G92_PERSISTENCE", Type::kInteger},
    {"RS274NGC", "ORIENT_OFFSET", Type::kNumber},
    {"RS274NGC", "CENTER_ARC_RADIUS_TOLERANCE_INCH", Type::kNumber},
    {"RS274NGC", "CENTER_ARC_RADIUS_TOLERANCE_MM", Type::kNumber},
    {"RS274NGC", "LOG_LEVEL"},
    {"RS274NGC", "LOG_FILE"},
    {"RS274NGC", "FEATURES"},
    {"RS274NGC", "FEATURE"},
    {"RS274NGC", "USER_DEFINED_FUNCTION_MAX_DIRS"},
    {"RS274NGC", "G64_DEFAULT_TOLERANCE", Type::kNumber},
    {"RS274NGC", "G64_DEFAULT_NAIVETOLERANCE", Type::kNumber},
    {"RS274NGC", "G73_PECK_CLEARANCE", Type::kNumber},
    {"RS274NGC", "G83_PECK_CLEARANCE", Type::kNumber},
    {"RS274NGC", "DISABLE_AUTO_G54"},
    {"WIZARD", "WIZARD_ROOT", Type::kPath},
    {"PYTHON", "TOPLEVEL", Type::kPath},
    {"PYTHON", "PATH_PREPEND", Type::kPath, false, kSeveral},
    {"PYTHON", "PATH_APPEND", Type::kPath, false, kSeveral},
    {"PYTHON", "LOG_LEVEL"},
    {"PYTHON", "RELOAD_ON_CHANGE"},
    {"HAL", "HALFILE", Type::kText, false, kSeveral},
    {"HAL", "POSTGUI_HALFILE", Type::kText, false, kSeveral},
    {"HAL", "HALCMD", Type::kText, false, kSeveral},
    {"HAL", "HALUI"},
    {"HAL", "TWOPASS"},
    {"HAL", "SHUTDOWN"},
    {"HALUI", "MDI_COMMAND", Type::kGcode, false, kSeveral},
    {"FILTER", "PROGRAM_EXTENSION", Type::kText, false, kSeveral},
    {"EMCMOT", "EMCMOT"},
    {"EMCMOT", "SERVO_PERIOD"},
    {"EMCMOT", "BASE_PERIOD"},
    {"EMCMOT", "COMM_TIMEOUT"},
    {"EMCIO", "EMCIO"},
    {"EMCIO", "CYCLE_TIME"},
    {"EMCIO", "TOOL_TABLE", Type::kPath},
    {"EMCIO", "DB_PROGRAM"},
    {"EMCIO", "TOOL_CHANGE_AT_G30", Type::kInteger},
    {"EMCIO", "TOOL_CHANGE_QUILL_UP", Type::kInteger},
    {"EMCIO", "TOOL_CHANGE_WITH_SPINDLE_ON", Type::kInteger},
    {"EMCIO", "TOOL_CHANGE_POSITION"},
    {"EMCIO", "RANDOM_TOOLCHANGER", Type::kInteger},
    {"KINS", "KINEMATICS"},
    {"KINS", "JOINTS", Type::kInteger, kRefuses},
    {"TRAJ", "COORDINATES"},
    {"TRAJ", "LINEAR_UNITS", Type::kUnits, kRefuses},
    {"TRAJ", "ANGULAR_UNITS", Type::kUnits, kRefuses},
    {"TRAJ", "SPINDLES", Type::kInteger, kRefuses},
    {"TRAJ", "DEFAULT_LINEAR_VELOCITY", Type::kNumber, kRefuses},
    {"TRAJ", "MAX_LINEAR_VELOCITY", Type::kNumber, kRefuses},
    {"TRAJ", "DEFAULT_LINEAR_ACCELERATION", Type::kNumber, kRefuses},
    {"TRAJ", "MAX_LINEAR_ACCELERATION", Type::kNumber, kRefuses},
    {"TRAJ", "ARC_BLEND_ENABLE", Type::kInteger, kRefuses},
    {"TRAJ", "ARC_BLEND_FALLBACK_ENABLE", Type::kInteger, kRefuses},
    {"TRAJ", "ARC_BLEND_OPTIMIZATION_DEPTH", Type::kInteger, kRefuses},
    {"TRAJ", "ARC_BLEND_GAP_CYCLES", Type::kNumber, kRefuses},
    {"TRAJ", "ARC_BLEND_RAMP_FREQ", Type::kNumber, kRefuses},
    {"TRAJ", "ARC_BLEND_KINK_RATIO", Type::kNumber, kRefuses},
    {"TRAJ", "NO_PROBE_JOG_ERROR", Type::kTruth, kRefuses},
    {"TRAJ", "NO_PROBE_HOME_ERROR", Type::kTruth, kRefuses},
    {"TRAJ", "NO_FORCE_HOMING"},
    {"TRAJ", "POSITION_FILE", Type::kPath},
    {"TRAJ", "HOME"},
    {"AXIS_", "MIN_LIMIT", Type::kNumber, kRefuses},
    {"AXIS_", "MAX_LIMIT", Type::kNumber, kRefuses},
    {"AXIS_", "MAX_VELOCITY", Type::kNumber, kRefuses},
    {"AXIS_", "MAX_ACCELERATION", Type::kNumber, kRefuses},
    {"AXIS_", "OFFSET_AV_RATIO", Type::kNumber, kRefuses},
    {"AXIS_", "WRAPPED_ROTARY", Type::kInteger},
    {"AXIS_", "LOCKING_INDEXER_JOINT", Type::kInteger},
    {"JOINT_", "TYPE", Type::kJointType, kRefuses},
    {"JOINT_", "MIN_LIMIT", Type::kNumber, kRefuses},
    {"JOINT_", "MAX_LIMIT", Type::kNumber, kRefuses},
    {"JOINT_", "MAX_VELOCITY", Type::kNumber, kRefuses},
    {"JOINT_", "MAX_ACCELERATION", Type::kNumber, kRefuses},
    {"JOINT_", "BACKLASH", Type::kNumber, kRefuses},
    {"JOINT_", "FERROR", Type::kNumber, kRefuses},
    {"JOINT_", "MIN_FERROR", Type::kNumber, kRefuses},
    {"JOINT_", "COMP_FILE", Type::kPath},
    {"JOINT_", "COMP_FILE_TYPE", Type::kInteger, kRefuses},
    {"JOINT_", "HOME", Type::kNumber, kRefuses},
    {"JOINT_", "HOME_OFFSET", Type::kNumber, kRefuses},
    {"JOINT_", "HOME_SEARCH_VEL", Type::kNumber, kRefuses},
    {"JOINT_", "HOME_LATCH_VEL", Type::kNumber, kRefuses},
    {"JOINT_", "HOME_FINAL_VEL", Type::kNumber, kRefuses},
    {"JOINT_", "HOME_SEQUENCE", Type::kInteger, kRefuses},
    {"JOINT_", "HOME_USE_INDEX", Type::kTruth, kRefuses},
    {"JOINT_", "HOME_IGNORE_LIMITS", Type::kTruth, kRefuses},
    {"JOINT_", "HOME_INDEX_NO_ENCODER_RESET", Type::kTruth, kRefuses},
    {"JOINT_", "HOME_IS_SHARED", Type::kTruth, kRefuses},
    {"JOINT_", "HOME_ABSOLUTE_ENCODER", Type::kInteger, kRefuses},
    {"JOINT_", "VOLATILE_HOME", Type::kTruth, kRefuses},
    {"JOINT_", "LOCKING_INDEXER", Type::kTruth, kRefuses},
};

constexpr std::array<std::string_view, 14> kMachineSections{"EMC",  "DISPLAY", "TASK",   "RS274NGC", "PYTHON",
                                                            "HAL",  "HALUI",   "FILTER", "EMCMOT",   "EMCIO",
                                                            "KINS", "TRAJ",    "AXIS_",  "JOINT_"};

/// Near enough to a key of LinuxCNC to be taken for a misspelt one.
constexpr std::array<std::pair<std::string_view, std::string_view>, 30> kDisplayKeys{{
    {"TRAJ", "DEFAULT_ANGULAR_VELOCITY"},
    {"TRAJ", "MAX_ANGULAR_VELOCITY"},
    {"TRAJ", "MIN_LINEAR_VELOCITY"},
    {"TRAJ", "MIN_ANGULAR_VELOCITY"},
    {"TRAJ", "DEFAULT_ANGULAR_ACCELERATION"},
    {"TRAJ", "MAX_ANGULAR_ACCELERATION"},
    {"TRAJ", "DEFAULT_LINEAR_ACCEL"},
    {"TRAJ", "MAX_LINEAR_ACCEL"},
    {"TRAJ", "DEFAULT_VELOCITY"},
    {"TRAJ", "DEFAULT_ACCELERATION"},
    {"TRAJ", "MAX_VELOCITY"},
    {"TRAJ", "MAX_ACCELERATION"},
    {"TRAJ", "AXES"},
    {"TRAJ", "JOINTS"},
    {"TRAJ", "SPINDLE"},
    {"AXIS_", "MIN_LIMIT_TURN"},
    {"AXIS_", "MAX_LIMIT_TURN"},
    {"AXIS_", "FERROR"},
    {"AXIS_", "MIN_FERROR"},
    {"AXIS_", "HOME"},
    {"JOINT_", "USE_INDEX"},
    {"JOINT_", "MIN_HARD_LIMIT"},
    {"JOINT_", "MAX_HARD_LIMIT"},
    {"JOINT_", "NAME"},
    {"JOINT_", "UNITS"},
    {"JOINT_", "PID_MAX_VEL"},
    {"HAL", "EZTROL_HALFILE"},
    {"HAL", "POSTTASK_HALFILE"},
    {"HAL", "POSTGUI_HALCMD"},
    {"DISPLAY", "MAX_FEED_OVERIDE"},
}};

}  // namespace

std::span<const IniKey> ini_keys() { return kKeys; }
std::span<const std::string_view> machine_sections() { return kMachineSections; }

const IniKey* find_ini_key(std::string_view section, std::string_view name) {
  const std::string_view family = section_family(section);
  const auto found =
      std::ranges::find_if(kKeys, [&](const IniKey& key) { return key.section == family && key.name == name; });
  return found == std::end(kKeys) ? nullptr : &*found;
}

bool is_known_section(std::string_view section) {
  return std::ranges::find(kMachineSections, section_family(section)) != kMachineSections.end();
}

bool is_display_key(std::string_view section, std::string_view name) {
  return std::ranges::find(kDisplayKeys, std::pair(section_family(section), name)) != kDisplayKeys.end();
}

}  // namespace owlint
