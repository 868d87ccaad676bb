#include "rules/driver/start_refusals.h"

#include <algorithm>
#include <cctype>

#include "analyzer/machine/ini_keys.h"
#include "rules/driver/ini_values.h"
#include "rules/driver/machine_rules.h"
#include "rules/driver/stops.h"

namespace owlint::rules {
namespace {

std::string trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

bool is_bracket(const IniLine& line) {
  return line.kind == IniLine::Kind::kSection || line.kind == IniLine::Kind::kOpenSection;
}

/// The line that was meant to open a section, where none opens it for the check.
const IniLine* meant_line(const IniText& text, std::string_view section, bool* misspelt) {
  for (const IniLine& line : text.lines()) {
    if (is_bracket(line) && !is_checked_section(text, line) && trimmed(text.name(line)) == section) return &line;
    if (is_unopened_section(text, line) && text.text(line).starts_with(section) &&
        text.text(line).size() == section.size() + 1)
      return &line;
  }
  for (const IniLine& line : text.lines()) {
    if (!is_bracket(line)) continue;
    const std::string name = trimmed(text.name(line));
    if (name == section && name.size() != text.name(line).size()) return &line;
    if (name != section && meant_section(text, name) == section) {
      *misspelt = true;
      return &line;
    }
  }
  return nullptr;
}

/// The line that was meant for a key that the section lacks: misspelt, without `=`, or joined to the line above, which is then
/// the one that is wrong.
const IniLine* meant_key_line(const IniText& text, std::string_view section, std::string_view key, bool* misspelt) {
  const std::vector<IniLine>& lines = text.lines();
  for (size_t i = 0; i < lines.size(); ++i) {
    const IniLine& line = lines[i];
    if (text.section_of(line) != section) continue;
    const std::string_view body = text.text(line);
    const bool begins = body.starts_with(key) &&
        (body.size() == key.size() || std::string_view(" \t=:").find(body[key.size()]) != std::string_view::npos);
    if (line.continuation) {
      if (begins && i > 0) return &lines[i - 1];
      continue;
    }
    if (line.kind == IniLine::Kind::kText && begins) return &line;
    const bool has_value = line.kind == IniLine::Kind::kKey && line.value.begin != line.value.end;
    if (has_value && text.name(line) != key && find_ini_key(section, text.name(line)) == nullptr &&
        !is_display_key(section, text.name(line)) && meant_key(section, text.name(line)) == key) {
      *misspelt = true;
      return &line;
    }
  }
  return nullptr;
}

/// Of a key of a section that LinuxCNC needs.
void blame(const IniText& text, std::string_view section, std::string_view key, bool has_section,
           BlamedRefusal& blamed) {
  blamed.cause =
      has_section ? meant_key_line(text, section, key, &blamed.misspelt) : meant_line(text, section, &blamed.misspelt);
}

bool has_checked(const IniText& text, std::string_view section) {
  return std::ranges::any_of(
      text.lines(), [&](const IniLine& line) { return is_checked_section(text, line) && text.name(line) == section; });
}

/// Above the first line with `=`: a section's line that is none for the check.
const IniLine* first_bracket_above(const IniText& text, const IniLine& before) {
  for (const IniLine& line : text.lines()) {
    if (&line == &before) return nullptr;
    if (is_bracket(line)) return &line;
  }
  return nullptr;
}

/// Whether a section has a key that LinuxCNC reads in another one.
bool has_key_of(const IniText& text, std::string_view section, std::string_view other) {
  return std::ranges::any_of(lines_of(text, section), [&](const IniLine* line) {
    return line->kind == IniLine::Kind::kKey && find_ini_key(other, text.name(*line)) != nullptr;
  });
}

}  // namespace

bool is_unopened_section(const IniText& text, const IniLine& line) {
  constexpr size_t kShortest = 4;
  const std::string_view body = text.text(line);
  if (line.kind != IniLine::Kind::kText || body.size() < kShortest || !body.ends_with(']')) return false;
  const std::string_view name = body.substr(0, body.size() - 1);
  return std::ranges::all_of(name,
                             [](unsigned char c) { return std::isupper(c) != 0 || std::isdigit(c) != 0 || c == '_'; });
}

std::string meant_section(const IniText& text, std::string_view name) {
  const auto is_there = [&](std::string_view wanted) { return text.find_section(wanted) != nullptr; };
  if (name.size() < 3) return {};
  // `[AXIS_x]` is not `[AXIS_X]`, nor is `[AXIS_0]`, which in a LinuxCNC before 2.8 was an axis and a joint.
  if (name.starts_with("AXIS_") && name.size() == 6 && find_line(text, "KINS", "JOINTS") != nullptr) {
    constexpr std::string_view kLetters = "XYZABCUVW";
    const char end = name[5];
    const char letter = end >= '0' && end <= '8' ? kLetters[static_cast<size_t>(end - '0')]
                                                 : static_cast<char>(std::toupper(static_cast<unsigned char>(end)));
    if (kLetters.find(letter) == std::string_view::npos || letter == end) return {};
    const std::string axis = std::string("AXIS_") + letter, joint = std::string("JOINT_") + end;
    if (reads_section(text, axis) && !is_there(axis)) return axis;
    return end <= '8' && reads_section(text, joint) && !is_there(joint) ? joint : std::string();
  }
  if (is_known_section(name)) return {};
  std::string letters(name);
  std::ranges::transform(letters, letters.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::ranges::replace(letters, '-', '_');
  std::vector<std::string> candidates;
  for (const IniSection& section : machine_sections()) {
    if (!section.name.ends_with('_') && !is_there(section.name)) candidates.emplace_back(section.name);
  }
  // `[JOINT0]` and `[axis_x]`
  for (const std::string_view family : {"JOINT", "AXIS"}) {
    if (!letters.starts_with(family)) continue;
    std::string end = letters.substr(family.size());
    if (end.starts_with('_')) end.erase(0, 1);
    const std::string wanted = std::string(family) + "_" + end;
    const bool fits = end.size() == 1 &&
        (family == "JOINT" ? std::isdigit(static_cast<unsigned char>(end[0])) != 0
                           : std::string_view("XYZABCUVW").find(end[0]) != std::string_view::npos);
    if (fits && !is_there(wanted)) return wanted;
  }
  if (std::ranges::find(candidates, letters) != candidates.end()) return letters;
  // `[RS274]`, `[TRAJECTORY]`: one name begins the other, and a key in it decides.
  for (const std::string& candidate : candidates) {
    if ((candidate.starts_with(letters) || letters.starts_with(candidate)) && has_key_of(text, name, candidate))
      return candidate;
  }
  if (letters.size() < 5) return {};
  const std::string near = nearest(letters, candidates, 1);
  return !near.empty() && has_key_of(text, name, near) ? near : std::string();
}

std::string meant_key(std::string_view section, std::string_view name) {
  constexpr size_t kShort = 5;
  constexpr size_t kLong = 10;
  std::vector<std::string> candidates;
  std::string whole;  // `STARTUP_CODE` for `RS274NGC_STARTUP_CODE`, if one key alone ends so
  size_t wholes = 0;
  for (const IniKey& key : ini_keys()) {
    if (key.section != section_family(section)) continue;
    if (small_letters(key.name) == small_letters(name)) return std::string(key.name);
    // Displays have many keys of their own.
    if (section == "DISPLAY" && key.name != "DISPLAY" && key.name != "PROGRAM_PREFIX" &&
        key.name != "NGCGUI_SUBFILE_PATH")
      continue;
    if (name.size() >= kLong && key.name.ends_with("_" + std::string(name))) {
      whole = key.name;
      ++wholes;
    }
    candidates.emplace_back(key.name);
  }
  if (wholes == 1) return whole;
  if (name.size() < kShort) return section == "TASK" ? nearest(std::string(name), {"TASK"}, 1) : std::string();
  return nearest(std::string(name), candidates, name.size() < kLong ? 1 : 2);
}

std::vector<BlamedRefusal> start_refusals(const SetupInput& in) {
  std::vector<BlamedRefusal> out;
  if (!is_whole_machine(in)) return out;
  const IniText& text = in.setup.text;
  for (StartRefusal& refusal : check_config(text)) {
    BlamedRefusal& blamed = out.emplace_back();
    switch (refusal.kind) {
      case StartRefusal::Kind::kBeforeSection: blamed.cause = first_bracket_above(text, *refusal.line); break;
      case StartRefusal::Kind::kNoKinematics:
      case StartRefusal::Kind::kNoJoints: {
        const bool joints = refusal.kind == StartRefusal::Kind::kNoJoints;
        blame(text, "KINS", joints ? "JOINTS" : "KINEMATICS", has_checked(text, "KINS"), blamed);
        break;
      }
      case StartRefusal::Kind::kMinLimit:
      case StartRefusal::Kind::kMaxLimit:
        if (refusal.axis == nullptr)
          blame(text, refusal.axis_name, refusal.kind == StartRefusal::Kind::kMinLimit ? "MIN_LIMIT" : "MAX_LIMIT",
                has_checked(text, refusal.axis_name), blamed);
        break;
      case StartRefusal::Kind::kEndlessJoints:
      case StartRefusal::Kind::kNoUnits: break;
    }
    blamed.refusal = std::move(refusal);
  }
  for (const std::string_view key : {"LINEAR_UNITS", "ANGULAR_UNITS"}) {
    if (find_line(text, "TRAJ", key) != nullptr) continue;
    BlamedRefusal& blamed = out.emplace_back();
    blamed.refusal.kind = StartRefusal::Kind::kNoUnits;
    blamed.key = key;
    blamed.refusal.message = "emcTrajSetUnits failed to set [TRAJ]LINEAR_UNITS or [TRAJ]ANGULAR_UNITS";
    blame(text, "TRAJ", key, text.find_section("TRAJ") != nullptr, blamed);
  }
  return out;
}

}  // namespace owlint::rules
