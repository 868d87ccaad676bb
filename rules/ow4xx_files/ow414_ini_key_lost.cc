// OW414 ini-key-lost: a key of the INI whose value LinuxCNC never uses.
// Depends on: LinuxCNC uses the first value of a key; an empty one hides those below; names count letter by letter (measured).
#include <algorithm>
#include <map>
#include <set>

#include "analyzer/machine/ini_keys.h"
#include "rules/driver/machine_rules.h"
#include "rules/driver/start_files.h"
#include "rules/driver/start_refusals.h"
#include "rules/driver/stops.h"

namespace owlint::rules::ow414 {
namespace {

using Kind = IniLine::Kind;

/// Keys that LinuxCNC reads in one section, and people write into another one.
struct Home {
  std::string_view key;
  std::string_view section;
};
constexpr Home kHomes[] = {{"PROGRAM_PREFIX", "DISPLAY"},
                           {"SUBROUTINE_PATH", "RS274NGC"},
                           {"USER_M_PATH", "RS274NGC"},
                           {"PARAMETER_FILE", "RS274NGC"},
                           {"REMAP", "RS274NGC"},
                           {"RS274NGC_STARTUP_CODE", "RS274NGC"},
                           {"ON_ABORT_COMMAND", "RS274NGC"},
                           {"OWORD_NARGS", "RS274NGC"},
                           {"OWORD_WARNONLY", "RS274NGC"},
                           {"RETAIN_G43", "RS274NGC"},
                           {"DISABLE_FANUC_STYLE_SUB", "RS274NGC"},
                           {"DISABLE_G92_PERSISTENCE", "RS274NGC"},
                           {"ORIENT_OFFSET", "RS274NGC"},
                           {"CENTER_ARC_RADIUS_TOLERANCE_INCH", "RS274NGC"},
                           {"CENTER_ARC_RADIUS_TOLERANCE_MM", "RS274NGC"},
                           {"RANDOM_TOOLCHANGER", "EMCIO"},
                           {"TOOL_CHANGE_WITH_SPINDLE_ON", "EMCIO"},
                           {"TOOL_CHANGE_QUILL_UP", "EMCIO"},
                           {"TOOL_CHANGE_AT_G30", "EMCIO"},
                           {"TOOL_CHANGE_POSITION", "EMCIO"},
                           {"TOOL_TABLE", "EMCIO"},
                           {"DB_PROGRAM", "EMCIO"},
                           {"MDI_COMMAND", "HALUI"},
                           {"HALFILE", "HAL"},
                           {"COORDINATES", "TRAJ"},
                           {"POSITION_FILE", "TRAJ"},
                           {"SPINDLES", "TRAJ"},
                           {"NO_FORCE_HOMING", "TRAJ"}};

bool ends_lists(std::string_view section, std::string_view key) {
  return (section == "RS274NGC" && key == "REMAP") || (section == "HALUI" && key == "MDI_COMMAND") ||
      (section == "HAL" && key == "HALFILE") || (section == "FILTER" && key == "PROGRAM_EXTENSION");
}

class Checker {
 public:
  Checker(const SetupInput& in, Reporter& out) : in_(in), out_(out), text_(in.setup.text) {}

  void run() {
    for (const BlamedRefusal& blamed : start_refusals(in_)) {
      if (blamed.misspelt) refused_.try_emplace(blamed.cause, blamed.refusal.message);
    }
    check_sections();
    check_halui();
    for (const IniText::Section& section : text_.sections()) {
      if (section.first) check_section(section.name);
    }
  }

 private:
  void check_sections() {
    for (const IniText::Section& section : text_.sections()) {
      const std::string meant = meant_section(text_, section.name);
      if (meant.empty()) continue;
      const bool blanks = std::string_view(" \t").find(section.name.front()) != std::string_view::npos ||
          std::string_view(" \t").find(section.name.back()) != std::string_view::npos;
      if (blanks && !reads_strictly(in_)) continue;  // OW412
      const IniLine& line = text_.lines()[section.line];
      Finding& f = add_at(in_, out_, line, line.name,
                          "LinuxCNC reads no section `[" + section.name + "]`, and this INI has no `[" + meant + "]`");
      f.help = "write `[" + meant + "]` if you mean that one; upper and lower case matter";
      f.fixes.push_back({"write `" + meant + "`", false, {{line.name, meant}}});
      refuse(line, f);
    }
  }

  /// Where LinuxCNC does not start for want of what the line was meant for.
  void refuse(const IniLine& line, Finding& f) const {
    if (const auto found = refused_.find(&line); found != refused_.end()) refuses(f, found->second);
  }

  /// halui runs these, and nothing starts it.
  void check_halui() {
    const IniLine* const command = find_line(text_, "HALUI", "MDI_COMMAND");
    if (command == nullptr || !is_whole_machine(in_) || text_.find_section("HAL") == nullptr) return;
    for (const IniLine* line : lines_of(text_, "HAL")) {
      if (small_letters(text_.value(*line)).find("halui") != std::string::npos) return;
    }
    if (!in_.setup.ini.missing_includes().empty() || hal_files_have(in_, "halui")) return;
    Finding& f = add_at(in_, out_, *command, command->name,
                        "nothing runs `MDI_COMMAND`: the program for it, `halui`, is not started");
    f.help = "add `HALUI = halui` to `[HAL]`";
    f.unproven = true;  // a HAL file that is not here may start it
  }

  void check_section(const std::string& section) {
    std::map<std::string_view, const IniLine*> values;  // by key, the first
    std::map<std::string_view, const IniLine*> empty;
    std::set<std::string_view> hidden;
    const std::vector<const IniLine*> lines = lines_of(text_, section);
    for (const IniLine* line : lines) {
      if (line->kind == Kind::kKey) values.try_emplace(text_.name(*line), line);
    }
    std::set<std::string_view> seen;
    for (const IniLine* line : lines) {
      const std::string_view name = text_.name(*line);
      if (is_unopened_section(text_, *line)) return;  // OW412; what follows was meant for that one
      if (line->kind != Kind::kKey) {
        if (line->name.end != line->span.end) empty.try_emplace(name, line);
        continue;
      }
      const IniKey* key = find_ini_key(section, name);
      const bool first = seen.insert(name).second;
      const bool has_value = line->value.begin != line->value.end;
      if (const auto before = empty.find(name); before != empty.end() && has_value && hidden.insert(name).second) {
        check_hidden(section, *line, *before->second);
      } else if (key != nullptr && !key->several && !first && before == empty.end()) {
        check_twice(*line, *values[name]);
      } else if (key == nullptr && first && before == empty.end()) {
        check_name(section, *line, values);
      }
      if (!has_value) empty.try_emplace(name, line);
    }
  }

  void check_hidden(const std::string& section, const IniLine& line, const IniLine& before) {
    const std::string_view name = text_.name(line);
    const bool list = ends_lists(section, name);
    const IniKey* key = find_ini_key(section, name);
    if (!list && (key == nullptr || key->several)) return;
    Finding& f = add_at(in_, out_, line,
                        "`" + std::string(name) + "` is empty further up: LinuxCNC stops there, and does not find " +
                            (list ? "this line or the lines of the list below" : "this value"));
    f.help = "remove the empty line, or begin it with `#`";
    f.related.push_back({before.span, "the empty one", before.source == line.source ? nullptr : text_.source(before)});
  }

  void check_twice(const IniLine& line, const IniLine& first) {
    if (text_.value(line) == text_.value(first)) return;
    const std::string name(text_.name(line));
    const bool kinematics = name == "KINEMATICS";
    Finding& f = add_at(in_, out_, line,
                        "`" + name + "` is set twice: LinuxCNC uses the first value, `" +
                            std::string(text_.value(first)) + "`, and ignores this one");
    if (kinematics) f.message += "; but its check before the start looks at this one";
    f.help = "keep one of the two lines";
    const IniKey* const key = find_ini_key(text_.section_of(line), name);
    if (key != nullptr && key->type == IniKey::Type::kPaths && comment_in(text_.value(line)) == std::string::npos &&
        !line.continued && !first.continued)
      f.help = "write both in one line, with `:` between them: `" + name + " = " + std::string(text_.value(first)) +
          ":" + std::string(text_.value(line)) + "`";
    f.group = name + " twice";  // copies of one configuration have the same lines
    f.habit_severity = Severity::kInfo;
    f.related.push_back(
        {first.span, "the value that is used", first.source == line.source ? nullptr : text_.source(first)});
  }

  /// Whether the name of an unknown section is said to be wrong: here, or by OW412 for `[ RS274NGC ]`.
  bool is_said(const std::string& section) const {
    const size_t first = section.find_first_not_of(" \t");
    if (first == std::string::npos) return true;
    const std::string plain = section.substr(first, section.find_last_not_of(" \t") + 1 - first);
    return is_known_section(plain) || !meant_section(text_, section).empty();
  }

  /// Names that nobody gives to a key of their own.
  static bool is_of_machine(std::string_view name) {
    return name == "PARAMETER_FILE" || name == "SUBROUTINE_PATH" || name == "REMAP" || name == "USER_M_PATH" ||
        name == "RS274NGC_STARTUP_CODE" || name == "ON_ABORT_COMMAND";
  }

  /// A key that LinuxCNC itself does not read.
  void check_name(const std::string& section, const IniLine& line,
                  const std::map<std::string_view, const IniLine*>& values) {
    const std::string name(text_.name(line));
    const bool known = is_known_section(section);
    if (!known && section == "MACRO" && name == "MACRO" && text_.find_section("MACROS") == nullptr) {
      Finding& f = add_at(in_, out_, line, line.name, "displays look for `MACRO` in `[MACROS]`, not in `[MACRO]`");
      f.help = "name the section `[MACROS]`";
      return;
    }
    if (known ? is_display_key(section, name) : !is_of_machine(name) || is_said(section)) return;
    for (const Home& home : kHomes) {
      if (name != home.key) continue;
      if (find_line(text_, home.section, home.key) != nullptr) return;
      Finding& f = add_at(
          in_, out_, line, line.name,
          "LinuxCNC looks for `" + name + "` in `[" + std::string(home.section) + "]`, not in `[" + section + "]`");
      f.help = "move the line into `[" + std::string(home.section) + "]`";
      return;
    }
    if (!known) return;
    const std::string near = meant_key(section, name);
    if (near.empty() || values.contains(near)) return;
    Finding& f =
        add_at(in_, out_, line, line.name,
               "LinuxCNC reads no `" + name + "` in `[" + section + "]`, and this section has no `" + near + "`");
    f.help = "write `" + near + "` if you mean that one" +
        (small_letters(near) == small_letters(name) ? "; upper and lower case matter" : "");
    f.fixes.push_back({"write `" + near + "`", false, {{line.name, near}}});
    refuse(line, f);
  }

  const SetupInput& in_;
  Reporter& out_;
  const IniText& text_;
  std::map<const IniLine*, std::string> refused_;  // what LinuxCNC prints, by the line that is the cause
};

void check_setup(const SetupInput& in, Reporter& out) { Checker(in, out).run(); }

}  // namespace

extern const Rule kRule{
    .code = "OW414",
    .name = "ini-key-lost",
    .summary = "a key of the INI whose value LinuxCNC never uses",
    .group = Group::kFiles,
    .level = Severity::kWarning,
    .page =
        {
            .what =
                R"(A key or section whose name is nearly one that LinuxCNC reads and that this INI lacks, or only a part of it; a key in the wrong
section; a key that is set twice, to two values; a value below an empty line of the same key; an `MDI_COMMAND` of `[HALUI]`
without `[HAL]HALUI`.)",
            .why =
                R"(LinuxCNC looks for each key by its exact name, in one section, and uses the first value. If there is
none, it uses its default and gives no message. Nor does it mention keys that it never looks for. A line
with the key and no value ends the search: in a list such as `REMAP` or `MDI_COMMAND`, all lines below it
are lost.)",
            .bad = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
RETAIN_G34 = 1
)",
            .good = R"(G21 G90
G0 X10
M2
; file: machine.ini
[RS274NGC]
RETAIN_G43 = 1
)",
            .fix =
                R"(Write the exact name, once, in the section where LinuxCNC looks for it. owlint does not check the names
of keys that only a display, a driver or your own HAL files read.)",
            .level_reason =
                "Warning: LinuxCNC starts, without this value. Error for a section or key that LinuxCNC needs.",
            .interpreter = "",
            .options = "--ini machine.ini",
        },
    .check = nothing_in_programs,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow414
