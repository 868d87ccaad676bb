// OW415 value-malformed: a value of the INI that is not what it says.
// Depends on: LinuxCNC converts a value as a whole or not at all, and a comment behind it is a part of it (measured for each kind
// of key, with `rs274 -i` and with LinuxCNC itself).
#include <algorithm>
#include <set>

#include "analyzer/machine/ini_keys.h"
#include "rules/driver/ini_places.h"
#include "rules/driver/ini_values.h"
#include "rules/driver/start_files.h"
#include "rules/driver/start_refusals.h"

namespace owlint::rules::ow415 {
namespace {

using Type = IniKey::Type;

/// A number at the beginning of a value, with what follows.
bool begins_with_number(std::string_view value) {
  const size_t first = value.find_first_not_of("+-.");
  return first != std::string_view::npos && value[first] >= '0' && value[first] <= '9';
}

class Checker {
 public:
  Checker(const SetupInput& in, Reporter& out)
      : in_(in), out_(out), text_(in.setup.text), strict_(reads_strictly(in)) {}

  void run() {
    refusals_ = start_refusals(in_);
    check_unused_folders();
    check_start_files(in_, out_);
    for (const IniText::Section& section : text_.sections()) {
      if (!section.first) continue;
      std::set<std::string_view> seen;  // only the first value counts
      for (const IniLine* line : lines_of(text_, section.name)) {
        const bool key = line->kind == IniLine::Kind::kKey;
        if (!key && line->name.end == line->span.end) continue;
        if (!seen.insert(text_.name(*line)).second || !key || line->value.begin == line->value.end) continue;
        check(section.name, *line);
      }
    }
  }

 private:
  void check(const std::string& section, const IniLine& line) {
    if (line.continued) return;
    const IniKey* key = find_ini_key(section, text_.name(line));
    const std::string_view value = text_.value(line);
    if (key != nullptr && (key->type == Type::kPath || key->type == Type::kPaths)) return check_path(*key, line);
    if (strict_) return;
    const size_t comment = comment_in(value);
    if (key == nullptr || key->type == Type::kText) {
      check_text(section, line, comment);
      return;
    }
    if (key->type == Type::kGcode || key->type == Type::kRemap || is_good(*key, value)) return;
    const std::string_view plain =
        comment == std::string_view::npos ? value : value.substr(0, value.find_last_not_of(" \t", comment - 1) + 1);
    const bool read = reads_section(text_, section);
    if (harmless(*key, plain) || (!read && comment == std::string_view::npos)) return;
    Finding& f = add_at(in_, out_, line, line.value, message_of(*key, line, comment, plain));
    if (comment != std::string_view::npos) {
      f.help = "put the comment on a line of its own";
      f.fixes.push_back(comment_above(text_, line, comment));
    } else if (const std::optional<bool> meant = ini_truth(value); meant && wants_number(*key)) {
      f.help = std::string("write `") + (*meant ? "1" : "0") + "`";
      // With that one on, a mistake in an O-word crashes LinuxCNC where it only stopped the program before.
      f.fixes.push_back(write_value(line, *meant ? "1" : "0", key->name != "OWORD_WARNONLY"));
    } else if (!ini_real(value) && begins_with_number(value) &&
               (key->type == Type::kNumber || key->type == Type::kInteger)) {
      f.help =
          key->type == Type::kInteger ? "write a whole number and nothing else" : "write the number and nothing else";
    } else {
      f.help = help_of(*key);
    }
    if (key->refuses && read) say_refused(f, line);
  }

  static bool wants_number(const IniKey& key) { return key.type == Type::kSwitch || key.type == Type::kInteger; }

  static bool is_good(const IniKey& key, std::string_view value) {
    switch (key.type) {
      case Type::kSwitch: return ini_switch(value).has_value();
      case Type::kTruth: return is_truth(value);
      case Type::kJointType: return small_letters(value) == "linear" || small_letters(value) == "angular";
      case Type::kInteger:
        return ini_integer(value).has_value() && (key.name != "SPINDLES" || is_spindle_count(*ini_integer(value)));
      case Type::kNumber: return ini_real(value).has_value() && in_range(key, *ini_real(value));
      case Type::kUnits: return key.name == "LINEAR_UNITS" ? is_linear_unit(value) : is_angular_unit(value);
      default: return true;
    }
  }

  static bool is_spindle_count(int count) { return count >= 1 && count <= 8; }

  /// `on` and `off` are none (measured).
  static bool is_truth(std::string_view value) {
    const std::string word = small_letters(value);
    return word == "true" || word == "yes" || word == "false" || word == "no" || ini_integer(value);
  }

  static bool in_range(const IniKey& key, double value) {
    if (key.name == "CENTER_ARC_RADIUS_TOLERANCE_INCH") return value >= 0.00004 && value <= 0.00282842713;
    if (key.name == "CENTER_ARC_RADIUS_TOLERANCE_MM") return value >= 0.001 && value <= 0.0282842713;
    return true;
  }

  /// Where the default is what the value says.
  static bool harmless(const IniKey& key, std::string_view plain) {
    if (key.type != Type::kSwitch && (key.type != Type::kInteger || key.refuses)) return false;
    const std::optional<bool> meant = ini_truth(plain);
    return meant && *meant == key.on && key.name != "LOCKING_INDEXER_JOINT";
  }

  std::string message_of(const IniKey& key, const IniLine& line, size_t comment, std::string_view plain) const {
    const std::string value(text_.value(line));
    const std::string name(key.name);
    std::string message;
    if (comment != std::string_view::npos) {
      message = "the comment is a part of the value: LinuxCNC reads `" + value + "` as `" + name + "`";
    } else if (ini_real(value) && key.type == Type::kNumber) {
      return "`" + name + "` is out of range: LinuxCNC uses its default instead of " + value;
    } else {
      message = "`" + value + "` is not a value that LinuxCNC understands for `" + name + "`";
    }
    if (key.refuses) return message;
    if (key.name == "LOCKING_INDEXER_JOINT") return message + ", so it uses joint 0";
    const bool off = key.type == Type::kSwitch || (key.type == Type::kInteger && ini_truth(plain).has_value());
    return message + (off ? key.on ? ", so it stays on" : ", so it stays off" : ", so it uses the default");
  }

  static std::string help_of(const IniKey& key) {
    switch (key.type) {
      case Type::kSwitch: return "write `1` for on, `0` for off";
      case Type::kTruth: return "write `YES` or `NO`";
      case Type::kJointType: return "write `LINEAR` or `ANGULAR`";
      case Type::kInteger: return key.name == "SPINDLES" ? "write a number from 1 to 8" : "write a whole number";
      case Type::kUnits: return key.name == "LINEAR_UNITS" ? "write `mm` or `inch`" : "write `degree`";
      default:
        if (key.name == "CENTER_ARC_RADIUS_TOLERANCE_INCH") return "write a number from 0.00004 to 0.002828427";
        if (key.name == "CENTER_ARC_RADIUS_TOLERANCE_MM") return "write a number from 0.001 to 0.028284271";
        return "write a number";
    }
  }

  void say_refused(Finding& f, const IniLine& line) const {
    for (const BlamedRefusal& blamed : refusals_) {
      if (blamed.refusal.line != &line && blamed.refusal.axis != &line) continue;
      const bool endless = blamed.refusal.kind == StartRefusal::Kind::kEndlessJoints;
      refuses(f, blamed.refusal.message);
      f.message += endless ? ", and LinuxCNC's check before the start never ends" : ", and LinuxCNC does not start";
      f.stops = !endless;
      f.never_ends = endless;
      return;
    }
    const std::string value(text_.value(line));
    refuses_machine(in_, f,
                    text_.name(line) == "SPINDLES" && ini_integer(value)
                        ? "emcTrajSetSpindles failing: spindles=" + value
                        : conversion_error(text_, line));
    if (f.stops) f.message += ", and LinuxCNC does not start";
  }

  void check_path(const IniKey& key, const IniLine& line) {
    const std::string value(text_.value(line));
    const std::string name(key.name);
    if (name == "SUBROUTINE_PATH" && value.find_first_not_of(':') == std::string::npos) {
      Finding& f = add_at(in_, out_, line, line.value,
                          "`SUBROUTINE_PATH` has `:` but no folder: LinuxCNC crashes when it starts");
      f.help = "name a folder, or remove the line";
      f.never_ends = true;
      f.reach = Reach::kAlways;
      return;
    }
    if (const size_t comment = comment_in(value); comment != std::string_view::npos) {
      Finding& f = add_at(in_, out_, line, line.value,
                          "the comment is a part of the value: LinuxCNC looks for " +
                              std::string(key.type == Type::kPaths ? "the folders" : "the file") + " `" + value + "`");
      if (name == "PROGRAM_PREFIX")
        f.message = "the comment is a part of the value: LinuxCNC finds no user M codes in `" + value + "`";
      f.help = "put the comment on a line of its own";
      const bool there = key.type == Type::kPath && is_file_beside(value);
      if (there) {
        f.message += ", which is there";
        f.help += "; take over what LinuxCNC has written to that file before";
      }
      f.fixes.push_back(comment_above(text_, line, comment));
      f.fixes.back().safe = !there;
    } else if (name == "TOOL_TABLE" || name == "PARAMETER_FILE") {
      check_machine_file(in_, out_, line);
    } else if (key.type == Type::kPaths && value.find(',') != std::string::npos) {
      Finding& f =
          add_at(in_, out_, line, line.value, "`,` does not separate folders: LinuxCNC reads it as a part of the name");
      f.help = "separate the folders with `:`";
    }
  }

  /// Measured with LinuxCNC: such a name counts as it is written, blanks and all.
  bool is_file_beside(std::string_view value) const {
    return in_.library.files().is_file(normal_path(joined_path(folder_of(in_.setup.path), value)));
  }

  /// Measured without a screen: with any other text than `1.1` LinuxCNC wants to convert the INI first.
  void check_version(const IniLine& line, size_t comment) {
    if (version_meant(text_.value(line)) != "1.1") return;  // OW424
    Finding& f =
        add_at(in_, out_, line, line.value,
               "the comment is a part of the value: LinuxCNC does not find that `VERSION` is 1.1, and does not "
               "start before it has converted the INI");
    f.help = "put the comment on a line of its own";
    f.fixes.push_back(comment_above(text_, line, comment));
    refuses(f, "INI file [EMC]VERSION indicates update is needed, but the update GUI can't run without an X display");
  }

  /// Measured: with `5,5,5` the first M6 never ends, with `5 5 5` it moves there.
  void check_change_position(const IniLine& line) {
    const std::string value(text_.value(line));
    if (value.find(',') == std::string::npos) return;
    Finding& f = add_at(in_, out_, line, line.value,
                        "`,` does not separate the numbers of `TOOL_CHANGE_POSITION`: LinuxCNC waits for ever at `M6`");
    f.help = "separate the numbers with spaces";
    f.never_ends = true;
  }

  /// The list goes on where LinuxCNC has stopped to read it.
  void check_unused_folders() {
    std::set<std::string_view> said;
    for (const IniFolder* const folder : unused_folders(in_.setup)) {
      if (!said.insert(folder->key).second) continue;
      const bool called = folder->key == "SUBROUTINE_PATH";
      Finding& f = out_.add(
          folder->source, folder->span,
          called ? "LinuxCNC searches only the first 10 folders of `SUBROUTINE_PATH` that exist: `" + folder->text +
                  "` is never searched"
                 : "LinuxCNC reads only the first 5 folders of `USER_M_PATH`: `" + folder->text + "` is never read");
      f.help = "name the folders that are needed first, or put their files together";
    }
  }

  /// Each letter in it is an axis, those of a comment, too.
  void check_coordinates(const IniLine& line, size_t comment) {
    if (comment == std::string_view::npos) return;
    constexpr std::string_view kAxes = "xyzabcuvw";
    const std::string value = small_letters(text_.value(line));
    std::string added;
    for (const char axis : kAxes) {
      if (value.find(axis) >= comment && value.find(axis) != std::string::npos)
        added += (added.empty() ? "" : " ") + std::string(1, static_cast<char>(std::toupper(axis)));
    }
    if (added.empty()) return;
    Finding& f =
        add_at(in_, out_, line, line.value, "the comment is a part of the value: its letters make axes, too: " + added);
    f.help = "put the comment on a line of its own";
    f.fixes.push_back(comment_above(text_, line, comment));
  }

  /// Keys with any text as their value, and those that LinuxCNC itself does not read.
  void check_text(const std::string& section, const IniLine& line, size_t comment) {
    const std::string_view value = text_.value(line);
    const std::string_view name = text_.name(line);
    if (section == "TRAJ" && name == "COORDINATES") return check_coordinates(line, comment);
    if (section == "KINS" && name == "KINEMATICS") return check_kinematics(in_, out_, line);
    if (section == "TRAJ" && name == "NO_FORCE_HOMING" && !begins_with_number(value)) {
      const bool on = ini_truth(value).value_or(false);
      if (!on) return;
      Finding& f =
          add_at(in_, out_, line, line.value,
                 "`NO_FORCE_HOMING` needs a number: LinuxCNC reads `" + std::string(value) + "` as 0, which is off");
      f.help = "write `1`";
      f.interpreter = "invalid [TRAJ] NO_FORCE_HOMING in " + std::string(name_of(text_.source(line)->path())) + " (" +
          std::string(value) + "); using default 0";
      f.fixes.push_back(write_value(line, "1", false));  // the machine then moves without being homed
      return;
    }
    if (section == "EMC" && name == "VERSION" && comment != std::string_view::npos) return check_version(line, comment);
    if (section == "EMCIO" && name == "TOOL_CHANGE_POSITION") return check_change_position(line);
    if (section == "DISPLAY" && name == "LATHE" && !ini_truth(value).value_or(true)) {
      Finding& f = add_at(in_, out_, line, line.value,
                          "`LATHE = " + std::string(value) + "` turns lathe mode on in AXIS and QtVCP: any text does");
      f.help = "remove the line";
      return;
    }
    if (comment == std::string_view::npos || !begins_with_number(value)) return;
    const std::string_view plain = value.substr(0, value.find_last_not_of(" \t", comment - 1) + 1);
    const bool in_machine = section_family(section).ends_with('_') || section == "TRAJ" || section == "EMCMOT";
    if (!in_machine || !ini_real(plain)) return;
    Finding& f =
        add_at(in_, out_, line, line.value,
               "the comment is a part of the value `" + std::string(value) +
                   "`: LinuxCNC does not start if a HAL file uses it, because the comment makes too many words");
    f.help = "put the comment on a line of its own";
    f.fixes.push_back(comment_above(text_, line, comment));
  }

  const SetupInput& in_;
  Reporter& out_;
  const IniText& text_;
  bool strict_;
  std::vector<BlamedRefusal> refusals_;
};

void check_setup(const SetupInput& in, Reporter& out) { Checker(in, out).run(); }

}  // namespace

extern const Rule kRule{
    .code = "OW415",
    .name = "value-malformed",
    .summary = "a value of the INI that LinuxCNC reads as something else",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what = R"(A value with a comment after it, `YES` where LinuxCNC reads a number, `7mm`, an unknown unit, a
tolerance that is out of range, a search path with `,` or without a folder, the 11th and later folders of
`SUBROUTINE_PATH` or the 6th and later ones of `USER_M_PATH`, kinematics, a HAL file or a display that
does not exist, a tool table that is not there, quotes or `~` in its name or that of `PARAMETER_FILE`.)",
            .why =
                R"(A comment must be on a line of its own: after a value, it is a part of the value. LinuxCNC does not
convert a value that is only partly a number. In `[RS274NGC]` and `[EMCIO]` it then uses the default
and gives no message. In `[TRAJ]`, `[KINS]`, `[JOINT_…]` and `[AXIS_…]` LinuxCNC ends with
`ERR_CONVERSION`, and `JOINTS = 3 # three` makes the start hang. A HAL file that uses such a value
gets the comment, too.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
RETAIN_G43 = YES
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
RETAIN_G43 = 1
)",
            .fix = R"(Write only the value. Put the comment on a line of its own, above.)",
            .level_reason = "Warning: LinuxCNC starts, with its default instead of the value. Error if it does not "
                            "start, hangs or crashes.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow415
