// OW422 limits-inconsistent: limits, joints, coordinates and units of the INI that contradict each other, or are not there.
// Depends on: LinuxCNC's check before the start, and what task needs (measured with LinuxCNC without a screen).
#include <algorithm>
#include <cctype>
#include <set>

#include "analyzer/machine/ini_keys.h"
#include "rules/driver/ini_joints.h"
#include "rules/driver/ini_values.h"
#include "rules/driver/start_files.h"
#include "rules/driver/start_refusals.h"

namespace owlint::rules::ow422 {
namespace {

class Checker {
 public:
  Checker(const SetupInput& in, Reporter& out) : in_(in), out_(out), text_(in.setup.text) {}

  void run() {
    check_start();
    check_joints();
    check_ini_joints(in_, out_);
    check_change_position_limits(in_, out_);
    if (is_whole_machine(in_) && has_most()) {
      check_unit("LINEAR_UNITS", "mm");
      check_unit("ANGULAR_UNITS", "degree");
    }
    for (const IniText::Section& section : text_.sections()) {
      if (!section.first || !section_family(section.name).ends_with('_')) continue;
      check_order(section.name);
      check_empty(section.name);
    }
    check_coordinates();
  }

 private:
  /// Whether an INI is more than a part of one, so that what it lacks is a mistake.
  bool has_most() const {
    static constexpr std::string_view kOfMachines[] = {"TRAJ", "KINS", "HAL", "TASK", "EMCMOT", "EMCIO", "JOINT_0"};
    constexpr int kEnough = 2;
    return std::ranges::count_if(kOfMachines, [&](std::string_view name) { return section_line(name) != nullptr; }) >=
        kEnough;
  }

  const IniLine* section_line(std::string_view name) const {
    const IniText::Section* section = text_.find_section(name);
    return section == nullptr ? nullptr : &text_.lines()[section->line];
  }

  /// Where to say that a key is missing: where it is empty, else at its section, else at `[EMC]`.
  const IniLine* place_of(std::string_view section, std::string_view key) const {
    for (const IniLine* line : lines_of(text_, section)) {
      if (text_.name(*line) == key) return line;
    }
    const IniLine* const line = section_line(section);
    return line == nullptr ? section_line("EMC") : line;
  }

  /// What is missing may be in a file that the INI includes and that is not here.
  void refuse(Finding& f, std::string message) const {
    refuses(f, std::move(message));
    f.unproven = !in_.setup.ini.missing_includes().empty();
  }

  void check_start() {
    const std::vector<BlamedRefusal> refusals = start_refusals(in_);
    const bool letters_wrong = check_letters(refusals);
    for (const BlamedRefusal& blamed : refusals) {
      if (blamed.cause != nullptr) continue;
      const StartRefusal& refusal = blamed.refusal;
      if (letters_wrong && is_of_limit(refusal)) continue;
      switch (refusal.kind) {
        case StartRefusal::Kind::kNoKinematics: add_missing("KINEMATICS", refusal.message); break;
        case StartRefusal::Kind::kNoJoints: add_missing("JOINTS", refusal.message); break;
        case StartRefusal::Kind::kMinLimit:
        case StartRefusal::Kind::kMaxLimit: add_limit(refusal); break;
        case StartRefusal::Kind::kBeforeSection:
        case StartRefusal::Kind::kEndlessJoints:
        case StartRefusal::Kind::kNoUnits: break;  // OW412, OW415 and below
      }
    }
  }

  static bool is_of_limit(const StartRefusal& refusal) {
    return refusal.kind == StartRefusal::Kind::kMinLimit || refusal.kind == StartRefusal::Kind::kMaxLimit;
  }

  /// Measured: `coordinates={XYZ}` and `coordinates=X,Y,Z`: each character is an axis for the check before the start, which
  /// then compares the limits of wrong ones; trivkins refuses the character itself. True if there is such a character.
  bool check_letters(const std::vector<BlamedRefusal>& refusals) {
    const IniLine* const line = find_line(text_, "KINS", "KINEMATICS");
    const std::string letters = line == nullptr ? "" : trivial_axes(text_.value(*line));
    const size_t bad = letters.find_first_not_of("xyzabcuvwXYZABCUVW");
    if (bad == std::string::npos || !is_whole_machine(in_)) return false;
    const std::string character = letters.substr(bad, 1);
    const uint64_t begin = line->value.begin + text_.value(*line).find(letters, text_.value(*line).find('='));
    Finding& f = add_at(in_, out_, *line, {begin, begin + letters.size()},
                        "`" + character + "` in `coordinates=` is not an axis: LinuxCNC does not start");
    std::string plain;
    for (const char c : letters) {
      if (std::string_view("xyzabcuvwXYZABCUVW").find(c) != std::string_view::npos) plain += c;
    }
    f.help = "write only the letters of the axes, one after the other: `coordinates=" + plain + "`";
    const auto limit = std::ranges::find_if(refusals, [](const BlamedRefusal& b) { return is_of_limit(b.refusal); });
    if (limit != refusals.end()) {
      refuse(f, limit->refusal.message);
    } else {  // if a HAL file loads `[KINS]KINEMATICS`
      f.interpreter = "Invalid character '" + character + "' in coordinates '" + letters + "'";
    }
    return true;
  }

  /// Where a key is that LinuxCNC looks for in another section; null if it is nowhere.
  const IniLine* elsewhere(std::string_view section, std::string_view key) const {
    for (const IniLine& line : text_.lines()) {
      const bool there = line.kind == IniLine::Kind::kKey && text_.name(line) == key && !line.continuation;
      if (there && is_known_section(text_.section_of(line)) && text_.section_of(line) != section) return &line;
    }
    return nullptr;
  }

  /// A finding about a key that LinuxCNC does not start without.
  Finding* add_needed(const std::string& section, const std::string& key) {
    const std::string name = "`[" + section + "]" + key + "`";
    if (const IniLine* const line = elsewhere(section, key)) {
      Finding& f = add_at(in_, out_, *line, line->name,
                          "LinuxCNC looks for `" + key + "` in `[" + section + "]`, not in `[" +
                              std::string(text_.section_of(*line)) + "]`, and does not start without it");
      f.help = "move the line into `[" + section + "]`";
      return &f;
    }
    const IniLine* const line = place_of(section, key);
    if (line == nullptr) return nullptr;
    return &add_at(in_, out_, *line, "this INI has no " + name + ": LinuxCNC does not start without it");
  }

  void add_missing(const std::string& key, const std::string& message) {
    if (!has_most()) return;
    Finding* const finding = add_needed("KINS", key);
    if (finding == nullptr) return;
    Finding& f = *finding;
    if (!f.help.empty()) return refuse(f, message);
    f.help = key == "JOINTS" ? "add `JOINTS = ` with the number of joints to `[KINS]`"
                             : "add `KINEMATICS = trivkins coordinates=XYZ`, or what your machine has, to `[KINS]`";
    refuse(f, message);
  }

  void add_limit(const StartRefusal& refusal) {
    const std::string_view value = text_.value(*refusal.line);
    const std::string_view of_axis = refusal.axis == nullptr ? "" : text_.value(*refusal.axis);
    if (value.empty() || (refusal.axis != nullptr && of_axis.empty())) return add_empty(refusal);
    if (!ini_real(value) || (refusal.axis != nullptr && !ini_real(of_axis))) return;  // OW415
    const bool min = refusal.kind == StartRefusal::Kind::kMinLimit;
    const std::string key = min ? "MIN_LIMIT" : "MAX_LIMIT";
    const std::string joint = "`[" + refusal.joint_name + "]" + key + "` of " + std::string(value);
    const IniLine* place = refusal.axis == nullptr ? section_line(refusal.axis_name) : nullptr;
    Finding& f = add_at(in_, out_, place == nullptr ? *refusal.line : *place,
                        refusal.axis == nullptr
                            ? joint + ", but `[" + refusal.axis_name + "]` has no such limit: LinuxCNC does not start"
                            : joint + " does not reach `[" + refusal.axis_name + "]" + key + "` of " +
                                std::string(text_.value(*refusal.axis)) + ": LinuxCNC does not start");
    f.help = refusal.axis == nullptr ? "add `" + key + " = " + std::string(value) + "` to `[" + refusal.axis_name + "]`"
                                     : "give the axis a limit that its joint can reach";
    if (place != nullptr)
      f.related.push_back({refusal.line->span, "the limit of the joint",
                           refusal.line->source == place->source ? nullptr : text_.source(*refusal.line)});
    if (refusal.axis != nullptr)
      f.related.push_back({refusal.axis->span, "the limit of the axis",
                           refusal.axis->source == refusal.line->source ? nullptr : text_.source(*refusal.axis)});
    refuse(f, refusal.message);
  }

  /// Measured: the check compares an empty limit as the text `{}`.
  void add_empty(const StartRefusal& refusal) {
    const bool of_joint = refusal.line->value.begin == refusal.line->value.end;
    const IniLine& line = of_joint ? *refusal.line : *refusal.axis;
    said_empty_.insert(&line);
    Finding& f = add_at(in_, out_, line,
                        "`" + std::string(text_.name(line)) +
                            "` is empty: LinuxCNC does not start, as its check takes "
                            "`[" +
                            refusal.joint_name + "]` and `[" + refusal.axis_name + "]` to contradict each other");
    f.help = "write the limit, or remove the line";
    if (!of_joint) f.help = "write the limit that `[" + refusal.joint_name + "]` has";
    refuse(f, refusal.message);
  }

  /// Measured: motion has 1 to 16 joints, and trivkins gives each letter of `coordinates=` one.
  void check_joints() {
    const IniLine* line = find_line(text_, "KINS", "JOINTS");
    const std::optional<int> count = line == nullptr ? std::nullopt : ini_integer(text_.value(*line));
    if (!count || !is_whole_machine(in_)) return;
    constexpr int kMostJoints = 16;
    if (*count < 1 || *count > kMostJoints) {
      Finding& f = add_at(in_, out_, *line, line->value,
                          "LinuxCNC has 1 to 16 joints, and does not start with " + std::to_string(*count));
      f.help = "write how many joints there are";
      refuses(f, "num_joints is " + std::to_string(*count) + ", must be between 1 and 16");
      return;
    }
    const IniLine* kinematics = find_line(text_, "KINS", "KINEMATICS");
    const std::string letters = kinematics == nullptr ? "" : trivial_axes(text_.value(*kinematics));
    const bool axes = letters.find_first_not_of("xyzabcuvwXYZABCUVW") == std::string::npos;
    if (!axes || static_cast<size_t>(*count) >= letters.size()) return;
    const auto joint = static_cast<size_t>(*count);
    const std::string name = "joint." + std::to_string(joint) + ".";
    const auto capital = static_cast<char>(std::toupper(static_cast<unsigned char>(letters[joint])));
    const bool has_another =
        small_letters(letters).substr(0, joint).find(small_letters(letters)[joint]) != std::string::npos;
    const bool used = hal_files_have(in_, name);
    Finding& f =
        add_at(in_, out_, *line, line->value,
               "`coordinates=" + letters + "` needs " + std::to_string(letters.size()) + " joints, and `JOINTS` is " +
                   std::to_string(joint) +
                   (used ? ": LinuxCNC does not start, as a HAL file uses `" + name + "…`"
                         : (has_another ? ": only one joint moves " : ": no joint moves ") + std::string(1, capital)));
    f.help = "write `JOINTS = " + std::to_string(letters.size()) + "`, or name fewer axes";
    f.related.push_back({kinematics->span, "the axes of the joints",
                         kinematics->source == line->source ? nullptr : text_.source(*kinematics)});
    if (used) refuses(f, "");
  }

  void check_unit(const std::string& key, const std::string& example) {
    if (find_line(text_, "TRAJ", key) != nullptr) return;
    // A line that was meant for it is the mistake.
    const std::vector<BlamedRefusal> refusals = start_refusals(in_);
    if (std::ranges::any_of(refusals, [&](const BlamedRefusal& b) { return b.key == key && b.cause != nullptr; }))
      return;
    Finding* const finding = add_needed("TRAJ", key);
    if (finding == nullptr) return;
    Finding& f = *finding;
    if (f.help.empty()) f.help = "add `" + key + " = " + example + "` to `[TRAJ]`";
    refuse(f, "emcTrajSetUnits failed to set [TRAJ]LINEAR_UNITS or [TRAJ]ANGULAR_UNITS");
  }

  /// Measured: the check compares numbers with nothing, and passes; the axis then has no limit.
  void check_empty(const std::string& section) {
    if (!reads_section(text_, section)) return;
    std::set<std::string_view> seen;
    for (const IniLine* line : lines_of(text_, section)) {
      const std::string_view name = text_.name(*line);
      if (line->kind != IniLine::Kind::kKey || (name != "MIN_LIMIT" && name != "MAX_LIMIT") ||
          !seen.insert(name).second)
        continue;
      if (line->value.begin != line->value.end || said_empty_.contains(line)) continue;
      Finding& f = add_at(in_, out_, *line,
                          "`" + std::string(name) + "` is empty: `[" + section +
                              "]` has no such limit, and "
                              "may move any distance");
      f.help = "write the limit, or remove the line";
    }
  }

  void check_order(const std::string& section) {
    const IniLine* min = find_line(text_, section, "MIN_LIMIT");
    const IniLine* max = find_line(text_, section, "MAX_LIMIT");
    if (min == nullptr || max == nullptr || !reads_section(text_, section)) return;
    const std::optional<double> low = ini_real(text_.value(*min));
    const std::optional<double> high = ini_real(text_.value(*max));
    if (!low || !high || *low <= *high) return;
    Finding& f = add_at(in_, out_, *max,
                        "`MAX_LIMIT` of " + std::string(text_.value(*max)) + " is below `MIN_LIMIT` of " +
                            std::string(text_.value(*min)) + ": LinuxCNC refuses every move of `[" + section + "]`");
    f.help = "swap the two values";
    f.related.push_back({min->span, "the other limit", min->source == max->source ? nullptr : text_.source(*min)});
  }

  static std::set<char> letters_of(std::string_view text) {
    std::set<char> letters;
    for (const char c : small_letters(text)) {
      if (std::string_view("xyzabcuvw").find(c) != std::string_view::npos) letters.insert(c);
    }
    return letters;
  }

  /// Of trivkins: LinuxCNC says that the two differ, and starts.
  void check_coordinates() {
    const IniLine* kinematics = find_line(text_, "KINS", "KINEMATICS");
    const IniLine* coordinates = find_line(text_, "TRAJ", "COORDINATES");
    if (kinematics == nullptr || coordinates == nullptr || !is_whole_machine(in_)) return;
    const std::string kins = trivial_axes(text_.value(*kinematics));
    if (kins.empty()) return;
    std::string_view traj = text_.value(*coordinates);
    traj = traj.substr(0, traj.find_first_of("#;"));
    if (letters_of(kins) == letters_of(traj)) return;
    Finding& f = add_at(in_, out_, *coordinates,
                        "`COORDINATES = " + std::string(traj) + "` and `coordinates=" + std::string(kins) +
                            "` of `[KINS]KINEMATICS` name different axes");
    f.help =
        "name the same axes in both: an axis without a joint never moves, and a program cannot use an axis that "
        "`COORDINATES` lacks";
    f.interpreter = "INCONSISTENT coordinates specifications:";
    f.related.push_back({kinematics->span, "the axes of the joints",
                         kinematics->source == coordinates->source ? nullptr : text_.source(*kinematics)});
  }

  const SetupInput& in_;
  Reporter& out_;
  const IniText& text_;
  std::set<const IniLine*> said_empty_;
};

void check_setup(const SetupInput& in, Reporter& out) {
  if (!reads_strictly(in)) Checker(in, out).run();
}

}  // namespace

extern const Rule kRule{
    .code = "OW422",
    .name = "limits-inconsistent",
    .summary = "limits, homing, joints, axes or units of the INI that contradict each other or are missing",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A joint that does not reach the limit of its axis, a maximum below the minimum, different axes in
`[TRAJ]COORDINATES` and `[KINS]KINEMATICS`, fewer joints than axes or a number of joints that LinuxCNC does
not have, a joint without a section, an empty limit, an INI without `KINEMATICS`, `JOINTS` or units.

A `HOME` or `TOOL_CHANGE_POSITION` beyond a limit, one of the two homing speeds without the other, and joints
of one axis that LinuxCNC homes one after the other.)",
            .why =
                R"(With `trivkins`, LinuxCNC compares the limits before it starts. It does not start if a joint cannot go as
far as its axis may: `[JOINT_0]MAX_LIMIT < [AXIS_X]MAX_LIMIT (50 < 100)`. An axis without a limit may go
anywhere. If the maximum is below the minimum, LinuxCNC refuses each move: `Linear move on line 5 would
exceed X's positive limit`.

LinuxCNC looks at the keys for homing only when it homes the joint, and then reports
`invalid homing config: non-zero SEARCH_VEL needs LATCH_VEL` or `Exceeded POSITIVE soft limit (100.00000) on
joint 0`. Two joints of one axis move together only if they have the same `HOME_SEQUENCE`, apart from its sign,
and at least one is negative.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[TRAJ]
COORDINATES = XYZ
[AXIS_X]
MIN_LIMIT = 100
MAX_LIMIT = -100
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[TRAJ]
COORDINATES = XYZ
[AXIS_X]
MIN_LIMIT = -100
MAX_LIMIT = 100
)",
            .fix = R"(Give each axis and its joint the same limits, or the joint wider ones.)",
            .level_reason = "Error if LinuxCNC does not start, else warning. An INI without `[EMC]VERSION = 1.1` is "
                            "only a part of an INI, or is for LinuxCNC 2.7: owlint does not report what it lacks.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow422
