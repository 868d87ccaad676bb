// Depends on: HAL files are looked for beside the INI, then in LinuxCNC's library; a module refuses options that it does not have
// (measured with LinuxCNC without a screen).
#include "rules/driver/start_files.h"

#include <algorithm>
#include <span>
#include <utility>

#include "rules/driver/ini_values.h"
#include "rules/driver/missing_files.h"
#include "rules/driver/stops.h"

namespace owlint::rules {
namespace {

class StartFiles {
 public:
  StartFiles(const SetupInput& in, Reporter& out) : in_(in), out_(out), text_(in.setup.text) {}

  void run() {
    if (!is_whole_machine(in_)) return;
    beside_ = has_files_beside();
    check_hal_files();
    check_screw_files();
    check_program("DISPLAY", kDisplays);
    check_program("TASK", kTasks);
  }

  /// Whether a line of a HAL file that is here has a text, and begins with a word.
  bool hal_has(std::string_view text, std::string_view first_word) const {
    for (const IniLine* line : lines_of(text_, "HAL")) {
      if (text_.name(*line) != "HALFILE" || line->kind != IniLine::Kind::kKey) continue;
      const std::string path = path_beside(in_, text_.value(*line));
      std::string error;
      const auto source = in_.library.files().is_file(path) ? in_.library.files().read(path, &error) : nullptr;
      if (source == nullptr) continue;
      const std::string_view bytes = source->bytes();
      for (size_t at = bytes.find(text); at != std::string_view::npos; at = bytes.find(text, at + 1)) {
        const size_t feed = bytes.rfind('\n', at);
        const size_t begin = feed == std::string_view::npos ? 0 : feed + 1;
        const std::string_view before = bytes.substr(begin, at - begin);
        const size_t first = before.find_first_not_of(" \t");
        if (first == std::string_view::npos ? first_word.empty()
                                            : before.substr(first).starts_with(first_word) && before[first] != '#')
          return true;
      }
    }
    return false;
  }

  /// A module and its options, each as `name=value`: what else there is the module refuses (measured).
  void check_module(const IniLine& line) {
    const size_t comment = comment_in(text_.value(line));
    const std::string_view value = text_.value(line);
    std::vector<std::string_view> words;
    for (size_t at = value.find_first_not_of(" \t"); at < value.size();) {
      const size_t end = std::min(value.find_first_of(" \t", at), value.size());
      words.push_back(value.substr(at, end - at));
      at = value.find_first_not_of(" \t", end);
    }
    if (words.empty()) return;
    const auto bad = std::find_if(words.begin() + 1, words.end(), [](std::string_view word) {
      return word.find('=') == std::string_view::npos || word.starts_with('=') || word.ends_with('=');
    });
    const bool loads = hal_has("[KINS]KINEMATICS", "loadrt");
    if (bad == words.end() && words[0] == "trivkins") return check_capitals(line, words, loads);
    if (bad != words.end()) {
      const std::string option(bad->substr(0, bad->find('=')));
      Finding& f = add_at(in_, out_, line, line.value,
                          (comment != std::string_view::npos ? "the comment is a part of the value: " : "") +
                              ("`" + std::string(words[0]) + "` has no option `" + std::string(*bad) +
                               (loads ? "`, and LinuxCNC does not start"
                                      : "`: LinuxCNC does not start if a HAL file "
                                        "loads `[KINS]KINEMATICS`")));
      f.help = comment != std::string_view::npos ? "put the comment on a line of its own"
                                                 : "write options as `name=value`, without spaces around the `=`";
      if (comment != std::string_view::npos) f.fixes.push_back(comment_above(text_, line, comment));
      if (loads) refuses_machine(in_, f, "Invalid parameter `" + (option.empty() ? std::string(*bad) : option) + "'");
      return;
    }
    static const std::vector<std::string> kModules{
        "trivkins",       "5axiskins",    "corexykins", "genhexkins", "genserkins",     "lineardeltakins",
        "maxkins",        "pentakins",    "pumakins",   "rosekins",   "rotatekins",     "rotarydeltakins",
        "scarakins",      "scorbot-kins", "tripodkins", "userkins",   "xyzac-trt-kins", "xyzbc-trt-kins",
        "xyzab_tdr_kins", "gantrykins",   "millturn"};
    if (std::ranges::find(kModules, words[0]) != kModules.end()) return;
    const std::string near = nearest(words[0], kModules, 1);
    if (near.empty()) return;  // a module that somebody has made
    Finding& f = add_at(in_, out_, line, span_of(line, words[0]),
                        "LinuxCNC has no kinematics module `" + std::string(words[0]) + "`");
    f.help = "did you mean `" + near + "`?";
    f.unproven = true;  // there may be one that is made for the machine
  }

  /// Measured: `COORDINATES=XYZ` is an unknown parameter of the module.
  void check_capitals(const IniLine& line, const std::vector<std::string_view>& words, bool loads) {
    for (const std::string_view word : words) {
      const std::string option(word.substr(0, word.find('=')));
      const std::string small = small_letters(option);
      if (option == small || (small != "coordinates" && small != "kinstype")) continue;
      const Span span = span_of(line, word.substr(0, option.size()));
      Finding& f = add_at(in_, out_, line, span,
                          "`trivkins` has no option `" + option +
                              (loads ? "`, and LinuxCNC does not start"
                                     : "`: LinuxCNC does not start if a HAL file loads `[KINS]KINEMATICS`"));
      f.help = "write `" + small + "`; upper and lower case matter";
      f.fixes.push_back({"write `" + small + "`", false, {{span, small}}});
      if (loads) refuses_machine(in_, f, "Unknown parameter `" + std::string(word) + "'");
      return;
    }
  }

  /// Measured: LinuxCNC takes the name as it is, and starts without the file.
  void check_file(const IniLine& line) {
    if (line.continued) return;
    const std::string value(text_.value(line));
    const bool tools = text_.name(line) == "TOOL_TABLE";
    if (tools && in_.setup.ini.find("EMCIO", "DB_PROGRAM") != nullptr) return;
    const std::string effect = tools ? "it starts without tools" : "it starts with all parameters at 0";
    const bool quoted = value.size() > 2 && (value[0] == '"' || value[0] == '\'') && value.back() == value[0];
    if (reads_strictly(in_)) return;
    if (quoted) {
      Finding& f = add_at(in_, out_, line, line.value,
                          "the quotes are a part of the name: LinuxCNC looks for a file `" + value + "`" +
                              (is_beside(value) ? "" : ", and " + effect));
      f.help = "remove the quotes";
      f.fixes.push_back(write_value(line, value.substr(1, value.size() - 2), false));
    } else if (value.starts_with("~/")) {
      Finding& f = add_at(in_, out_, line, line.value,
                          "`~` is not the home folder here: LinuxCNC looks for a folder `~` beside the INI" +
                              (is_beside(value) ? "" : ", and " + effect));
      f.help = "write the whole path, such as `/home/NAME" + value.substr(1) + "`, or one from the INI's folder";
    } else if (tools && !value.starts_with('/') && !is_beside(value) && has_files_beside()) {
      check_missing_tools(line, value);
    }
  }

  bool is_beside(std::string_view value) const {
    return in_.library.files().is_file(normal_path(joined_path(folder_of(in_.setup.path), value)));
  }

  /// An info, as LinuxCNC itself changes the file, and many keep it out of what they share.
  void check_missing_tools(const IniLine& line, const std::string& value) {
    const std::string path = normal_path(joined_path(folder_of(in_.setup.path), value));
    std::vector<std::string> names;
    std::string unread;  // then there are none
    const std::string folder(folder_of(path));
    for (const FolderEntry& entry : in_.library.files().list(folder.empty() ? "." : folder, &unread)) {
      if (ending_of(entry.name) == ending_of(path) && names.size() < kMostNames) names.push_back(entry.name);
    }
    const std::string near = nearest(name_of(path), names, 2);
    Finding& f = add_at(in_, out_, line, line.value,
                        "there is no tool table `" + value + "`: LinuxCNC starts without tools, and `T1` stops");
    f.help = near.empty() ? "put the file there, or correct the name" : "did you mean `" + near + "`?";
    f.interpreter = "can't load tool table.";
    f.missing = value;
    if (near.empty()) f.weight = Weight::kAside;
  }

  Span span_of(const IniLine& line, std::string_view part) const {
    const uint64_t from = line.value.begin + static_cast<uint64_t>(part.data() - text_.value(line).data());
    return {from, from + part.size()};
  }

 private:
  /// Whether a file is here that the INI names: else this is only a part of the configuration.
  bool has_files_beside() const {
    constexpr std::pair<std::string_view, std::string_view> kKeys[] = {
        {"HAL", "HALFILE"},     {"HAL", "POSTGUI_HALFILE"}, {"EMCIO", "TOOL_TABLE"}, {"RS274NGC", "PARAMETER_FILE"},
        {"PYTHON", "TOPLEVEL"}, {"DISPLAY", "DISPLAY"}};
    return std::ranges::any_of(kKeys, [&](const auto& key) {
      return std::ranges::any_of(lines_of(text_, key.first), [&](const IniLine* line) {
        return text_.name(*line) == key.second && line->kind == IniLine::Kind::kKey &&
            in_.library.files().is_file(path_beside(in_, text_.value(*line)));
      });
    });
  }

  /// HAL files are beside the INI, or in LinuxCNC's library.
  void check_hal_files() {
    if (!beside_) return;
    static constexpr std::string_view kLibrary[] = {"axis_manualtoolchange.hal",
                                                    "basic_sim.tcl",
                                                    "check_config.tcl",
                                                    "check_xyz_constraints.hal",
                                                    "core_servo.hal",
                                                    "core_sim.hal",
                                                    "core_sim9.hal",
                                                    "core_stepper.hal",
                                                    "gantrysim.hal",
                                                    "hal_procs_lib.tcl",
                                                    "halcheck.tcl",
                                                    "hookup_moveoff.tcl",
                                                    "lathe.hal",
                                                    "locking_indexer.hal",
                                                    "moveoff_external.hal",
                                                    "plasmac.tcl",
                                                    "qtplasmac_comp.hal",
                                                    "servo_sim.hal",
                                                    "sim_ldelta.hal",
                                                    "sim_lib.tcl",
                                                    "sim_rdelta.hal",
                                                    "sim_spindle_encoder.hal",
                                                    "simulated-gantry-home.hal",
                                                    "simulated_home.hal",
                                                    "simulated_limits.hal",
                                                    "tripodsim.hal",
                                                    "util_lib.tcl",
                                                    "var_show.tcl",
                                                    "wheeljogpins.tcl",
                                                    "xhc-hb04.tcl"};
    for (const IniLine* line : lines_of(text_, "HAL")) {
      if (text_.name(*line) != "HALFILE" || line->kind != IniLine::Kind::kKey || line->continued) continue;
      const std::string_view value = text_.value(*line);
      const std::string name(value.substr(0, value.find_first_of(" \t")));
      if (name.empty() || name.find_first_of("$~:") != std::string::npos || name.starts_with('/') ||
          name.starts_with("..") || std::ranges::find(kLibrary, name) != std::end(kLibrary))
        continue;
      if (in_.library.files().exists(path_beside(in_, name))) continue;
      Finding& f =
          add_at(in_, out_, *line, span_of(*line, value.substr(0, name.size())),
                 "there is no file `" + name + "` beside this INI, nor in LinuxCNC's library: LinuxCNC does not start");
      f.help = "put the file there, or correct the name";
      f.missing = name;
      refuses_machine(in_, f, "CANNOT FIND FILE FOR:" + name);
      f.unproven = name.find('/') == std::string::npos;  // another version's library may have it
    }
  }

  /// Measured: a joint whose `COMP_FILE` cannot be opened ends task.
  void check_screw_files() {
    if (!beside_) return;
    for (const IniText::Section& section : text_.sections()) {
      if (!section.first || !section.name.starts_with("JOINT_") || !reads_section(text_, section.name)) continue;
      const IniLine* const line = find_line(text_, section.name, "COMP_FILE");
      if (line == nullptr || line->continued) continue;
      const std::string name(text_.value(*line));
      if (name.find_first_of("$~") != std::string::npos || name.starts_with('/') || name.starts_with("..") ||
          comment_in(name) != std::string::npos || in_.library.files().exists(path_beside(in_, name)))
        continue;
      Finding& f = add_at(in_, out_, *line, line->value, "there is no file `" + name + "`: LinuxCNC does not start");
      f.help = "put the file there, or correct the name";
      f.missing = name;
      refuses_machine(in_, f, "can't open compensation file " + name);
    }
  }

  static constexpr std::string_view kDisplays[] = {
      "axis",       "gmoccapy",    "gscreen",   "touchy", "qtvcp",    "mini",        "keystick",
      "tklinuxcnc", "linuxcncrsh", "xlinuxcnc", "dummy",  "halui",    "probe_basic", "qtdragon",
      "qtplasmac",  "taxis",       "qtaxis",    "gaxis",  "schedrmt", "linuxcnclcd", "axis-remote"};
  static constexpr std::string_view kTasks[] = {"milltask", "milltask-mk"};

  /// The program of `[DISPLAY]DISPLAY` or `[TASK]TASK`: of a name without a folder only a slip of the pen is seen.
  void check_program(std::string_view key, std::span<const std::string_view> known) {
    const IniLine* line = find_line(text_, key, key);
    if (line == nullptr || line->continued) return;
    const std::string_view value = text_.value(*line);
    const std::string name(value.substr(0, value.find_first_of(" \t")));
    if (name.empty() || name.find_first_of("$~") != std::string::npos || name.starts_with('/') ||
        name.starts_with(".."))
      return;
    const std::string message = "Can't execute " + std::string(key) + " program " + name;
    if (name.find('/') != std::string::npos) {
      if (!beside_) return;
      if (in_.library.files().exists(path_beside(in_, name))) return;
      Finding& f = add_at(in_, out_, *line, span_of(*line, value.substr(0, name.size())),
                          "there is no program `" + name + "`: LinuxCNC does not start");
      f.help = "put the program there, or correct the name";
      f.missing = name;
      refuses_machine(in_, f, message);
      return;
    }
    if (std::ranges::find(known, name) != known.end()) return;
    const std::string near = nearest(name, {known.begin(), known.end()}, 1);
    if (near.empty()) return;
    Finding& f = add_at(in_, out_, *line, span_of(*line, value.substr(0, name.size())),
                        "LinuxCNC has no program `" + name + "`, and does not start without it");
    f.help = "did you mean `" + near + "`?";
    refuses_machine(in_, f, message);
    f.unproven = true;  // there may be one on the machine
  }

  static constexpr size_t kMostNames = 1000;

  const SetupInput& in_;
  Reporter& out_;
  const IniText& text_;
  bool beside_ = false;
};

}  // namespace

void check_start_files(const SetupInput& in, Reporter& out) { StartFiles(in, out).run(); }

void check_kinematics(const SetupInput& in, Reporter& out, const IniLine& line) {
  StartFiles(in, out).check_module(line);
}

void check_machine_file(const SetupInput& in, Reporter& out, const IniLine& line) {
  StartFiles(in, out).check_file(line);
}

bool hal_files_have(const SetupInput& in, std::string_view text) {
  std::vector<Finding> unused;
  Reporter none(*catalogue().front(), unused);
  return StartFiles(in, none).hal_has(text, "");
}

}  // namespace owlint::rules
