#include "analyzer/program/machine_words.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <functional>

#include "analyzer/machine/remap_line.h"
#include "analyzer/machine/setup.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/syntax/mode_run.h"
#include "analyzer/text/source.h"

namespace owlint {
namespace {

/// The axis letters of `[TRAJ]COORDINATES`; X, Y and Z if it has none (measured).
uint32_t axes_of(const MachineSetup& setup) {
  const Ini::Entry* const coordinates = setup.ini.find("TRAJ", "COORDINATES");
  const std::string letters = coordinates == nullptr ? std::string() : small_letters(coordinates->value);
  uint32_t axes = 0;
  for (const char c : letters) {
    if (c >= 'a' && c <= 'z') axes |= letter_set({&c, 1}) & kAxisLetters;
  }
  return axes == 0 ? letter_set("xyz") : axes;
}

/// M codes that stay what they are, whatever an INI maps to them (measured; M7 and M8 up to 2.9).
bool keeps_its_meaning(int code, Release release) {
  constexpr int kKept[] = {2, 3, 4, 5, 19, 30, 48, 49, 50, 51, 52, 53, 70, 71, 72, 73, 98, 99};
  if (code == 7 || code == 8) return release < Release::k2_10;
  return std::ranges::find(kKept, code) != std::end(kKept) || (code >= 100 && code <= 199) || code >= 1000;
}

}  // namespace

std::optional<RemappedCode> remapped_code(std::string_view remap, Release release) {
  const RemapLine line = read_remap(remap, 0);
  if (line.problem != RemapLine::Problem::kNone) return std::nullopt;
  RemappedCode out{static_cast<char>(line.letter() - 'A' + 'a'),
                   0,
                   MGroup::kUser,
                   line.code,
                   line.ngc,
                   line.argspec,
                   !line.prolog.empty() || !line.python.empty(),
                   !line.epilog.empty() || !line.python.empty()};
  constexpr int kEnd = 1000;
  switch (line.letter()) {
    case 'T':
    case 'S':
    case 'F': return out;
    case 'G':
      if (line.g_number() < 0 || line.g_number() >= kEnd) return std::nullopt;
      out.number = static_cast<int16_t>(line.g_number());
      return out;
    case 'M':
      if (line.m_number() < 0 || keeps_its_meaning(line.m_number(), release)) return std::nullopt;
      out.number = static_cast<int16_t>(line.m_number());
      if (const int group = line.group.value_or(-1); group != -1) out.group = static_cast<MGroup>(group);
      return out;
    default: return std::nullopt;
  }
}

std::optional<LostCode> lost_code(std::string_view remap, Release release) {
  const RemapLine line = read_remap(remap, 0);
  if (line.problem != RemapLine::Problem::kNone) return std::nullopt;
  if (line.letter() == 'G') {
    const GCode* const code = g_code(line.g_number(), release);
    // These two count as motions when they are remapped (measured).
    constexpr int kG5_3 = 53, kG6_3 = 63;
    if (code == nullptr || code->group == GGroup::kMotion || code->tenths == kG5_3 || code->tenths == kG6_3)
      return std::nullopt;
    return LostCode{'g', code->tenths, MGroup::kUser};
  }
  const int number = line.m_number();
  if (line.letter() != 'M' || number < 0 || number == code::kM98 || number == code::kM99 ||
      !keeps_its_meaning(number, release))
    return std::nullopt;
  const int given = line.group.value_or(-1);
  const MGroup group = given == -1 ? MGroup::kUser : static_cast<MGroup>(given);
  const MCode* const code = m_code(number);
  // A user code keeps its program, but loses its words.
  if (code != nullptr && code->group == group && group != MGroup::kUser) return std::nullopt;
  return LostCode{'m', number, group};
}

namespace {

/// A table may have a thousand tools, and every file that is read keeps its key: so there is a hash of them in it.
size_t hash_of(const std::vector<Tool>& tools) {
  std::string text;
  for (const Tool& tool : tools) {
    text += std::to_string(tool.number) + ' ' + std::to_string(std::bit_cast<uint64_t>(tool.diameter)) + ' ' +
        std::to_string(tool.orientation);
    for (const double offset : tool.offset) text += ' ' + std::to_string(std::bit_cast<uint64_t>(offset));
  }
  return std::hash<std::string>()(text);
}

/// The line of code that LinuxCNC runs before the first program.
const Ini::Entry* startup_code(const Ini& ini) {
  const Ini::Entry* const code = ini.find("RS274NGC", "RS274NGC_STARTUP_CODE");
  return code != nullptr ? code : ini.find("EMC", "RS274NGC_STARTUP_CODE");
}

ModeState modes_behind(const std::string& code, const MachineWords& machine) {
  ModeState state = ModeState::started();
  Syntax syntax;
  LineParser parser(syntax, machine);
  Statement line;
  parser.parse(code, 0, &line);
  // A call may set anything.
  if (parser.words() == nullptr) return line.has_error() ? state : ModeState::unknown();
  std::vector<ModeFault> faults;
  ModeState after = state;
  return ModeRun(machine, *parser.words()).run(&after, &faults) ? after : state;
}

/// `[TRAJ]LINEAR_UNITS`, as units in a millimetre. With others LinuxCNC does not start; `rs274` takes inches.
double units_per_mm(const Ini& ini) {
  constexpr double kInch = 1 / 25.4;
  const Ini::Entry* const entry = ini.find("TRAJ", "LINEAR_UNITS");
  const std::string text = entry == nullptr ? std::string() : small_letters(entry->value);
  if (text == "mm" || text == "metric") return 1;
  double number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  return problem == std::errc{} && number > 0 ? number : kInch;
}

/// How much the radii of an arc by its center may differ; what is out of its bounds changes nothing (measured).
void set_tolerance(const Ini& ini, const char* key, double least, double* tolerance) {
  const Ini::Entry* const entry = ini.find("RS274NGC", key);
  if (entry == nullptr) return;
  double number = 0;
  const auto [end, problem] = std::from_chars(entry->value.data(), entry->value.data() + entry->value.size(), number);
  if (problem == std::errc{} && number >= least && number <= *tolerance) *tolerance = number;
}

/// A value that is one number as a whole, as LinuxCNC reads it.
std::optional<double> whole_number(const Ini::Entry* entry) {
  if (entry == nullptr) return std::nullopt;
  const char* const last = entry->value.data() + entry->value.size();
  const char* const first = entry->value.data() + (entry->value.starts_with('+') ? 1 : 0);
  double number = 0;
  const auto [end, problem] = std::from_chars(first, last, number);
  if (problem != std::errc{} || end != last) return std::nullopt;
  return number;
}

/// The joint of an axis where each joint is one: trivkins, whose letters are in the order of the joints.
std::optional<size_t> joint_of(const Ini& ini, size_t axis) {
  constexpr std::string_view kTrivial = "trivkins", kOption = "coordinates=";
  const Ini::Entry* const entry = ini.find("KINS", "KINEMATICS");
  const std::string kinematics = entry == nullptr ? std::string() : small_letters(entry->value);
  if (!kinematics.starts_with(kTrivial)) return std::nullopt;
  const size_t option = kinematics.find(kOption);
  std::string letters = kAxisOrder;
  if (option != std::string::npos) letters = kinematics.substr(option + kOption.size());
  letters = letters.substr(0, letters.find_first_of(" \t"));
  const size_t joint = letters.find(kAxisOrder[axis]);
  return joint == std::string::npos ? std::nullopt : std::optional(joint);
}

bool is_in_degrees(const Ini& ini) {
  const Ini::Entry* const entry = ini.find("TRAJ", "ANGULAR_UNITS");
  const std::string text = entry == nullptr ? std::string() : small_letters(entry->value);
  return text == "deg" || text == "degree";
}

AxisLimits limits_of(const Ini& ini, size_t axis) {
  AxisLimits limits;
  if (!is_length(axis) && !is_in_degrees(ini)) return limits;
  limits.least = whole_number(limit_entry(ini, axis, false)).value_or(limits.least);
  limits.greatest = whole_number(limit_entry(ini, axis, true)).value_or(limits.greatest);
  return limits.least < limits.greatest ? limits
                                        : AxisLimits{};  // else no move is right, and that is no program's mistake
}

}  // namespace

const Ini::Entry* limit_entry(const Ini& ini, size_t axis, bool greatest) {
  const char* const key = greatest ? "MAX_LIMIT" : "MIN_LIMIT";
  const char letter = static_cast<char>(kAxisOrder[axis] - 'a' + 'A');
  const Ini::Entry* const entry = ini.find(std::string("AXIS_") + letter, key);
  if (entry != nullptr) return entry;
  const std::optional<size_t> joint = joint_of(ini, axis);
  return joint ? ini.find("JOINT_" + std::to_string(*joint), key) : nullptr;
}

Release release_of(const Profile& profile) { return profile.version < Version::k2_10 ? Release::k2_8 : Release::k2_10; }

WordsOfMachine::WordsOfMachine(const Profile& profile) : start(ModeState::started()), setup(profile.setup) {
  words.start = &start;
  words.release = release_of(profile);
  words.measures_extents = profile.measures_extents;
  words.unsure = profile.setup == nullptr;
  if (words.unsure) return;
  // A part of an INI, without the section, does not say which axes there are.
  if (profile.setup->ini.has_section("TRAJ")) words.axes = axes_of(*profile.setup);
  for (const Ini::Entry* remap : profile.setup->ini.all("RS274NGC", "REMAP")) {
    const auto code = remapped_code(remap->value, words.release);
    const auto same = [&](const RemappedCode& known) {
      return known.letter == code->letter && known.number == code->number;
    };
    if (code && std::ranges::none_of(remapped, same)) remapped.push_back(*code);
    if (const auto taken = lost_code(remap->value, words.release)) lost.push_back(*taken);
  }
  words.remapped = remapped;
  words.lost = lost;
  const Ini& ini = profile.setup->ini;
  words.units_per_mm = units_per_mm(ini);
  set_tolerance(ini, "CENTER_ARC_RADIUS_TOLERANCE_MM", 0.001, &words.arc_tolerance_mm);
  set_tolerance(ini, "CENTER_ARC_RADIUS_TOLERANCE_INCH", 0.00004, &words.arc_tolerance_inch);
  for (const char axis : std::string_view("ABC")) {
    const std::string section = std::string("AXIS_") + axis;
    const char letter = static_cast<char>(axis - 'A' + 'a');
    if (const Ini::Entry* const wraps = ini.find(section, "WRAPPED_ROTARY"); wraps != nullptr && wraps->value == "1")
      words.wrapped |= letter_set({&letter, 1});
    if (const Ini::Entry* const locks = ini.find(section, "LOCKING_INDEXER_JOINT");
        locks != nullptr && locks->value != "-1")
      words.indexing |= letter_set({&letter, 1});
  }
  for (size_t axis = 0; axis < words.limits.size(); ++axis) {
    if ((words.axes & letter_set({&kAxisOrder[axis], 1})) != 0) words.limits[axis] = limits_of(ini, axis);
    words.has_limits = words.has_limits || words.limits[axis] != AxisLimits{};
  }
  words.spindles = profile.setup->spindles;
  words.change_keeps_spindle = profile.setup->change_keeps_spindle;
  words.change_stays = profile.setup->change_stays;
  words.retains_offset = profile.setup->retains_offset;
  if (profile.setup->tools) {
    for (const ToolRow& row : profile.setup->tools->rows)
      tools.push_back({row.number, row.diameter, row.orientation, row.has_offset, row.offset});
    words.tools = tools;
  }
  if (const Ini::Entry* const code = startup_code(ini)) start = modes_behind(code->value, words);
}

std::string WordsOfMachine::key() const {
  std::string key =
      std::to_string(static_cast<int>(words.release)) + ' ' + std::to_string(words.axes) + (words.unsure ? "?" : "");
  for (const RemappedCode& code : remapped) {
    key += ' ';
    key += code.letter;
    key += std::to_string(code.number) + ':' + std::to_string(static_cast<int>(code.group)) + '>';
    key += code.sub;
  }
  for (const LostCode& code : lost) {
    key += " -";
    key += code.letter;
    key += std::to_string(code.number) + ':' + std::to_string(static_cast<int>(code.group));
  }
  key += " $" + std::to_string(words.spindles) + (words.change_keeps_spindle ? "+" : "") +
      (words.change_stays ? "s" : "") + (words.retains_offset ? "r" : "");
  key += " =" + std::to_string(words.units_per_mm) + ',' + std::to_string(words.arc_tolerance_mm) + ',' +
      std::to_string(words.arc_tolerance_inch);
  if (words.measures_extents) key += " extents";
  for (const AxisLimits& limits : words.limits)
    key += ' ' + std::to_string(limits.least) + ':' + std::to_string(limits.greatest);
  key += ',' + std::to_string(words.wrapped) + ',' + std::to_string(words.indexing);
  for (const ValueSet values : start.now.may) key += ',' + std::to_string(values);
  if (words.tools) key += " T" + std::to_string(tools.size()) + ':' + std::to_string(hash_of(tools));
  return key;
}

}  // namespace owlint
