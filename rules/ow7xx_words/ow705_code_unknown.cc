// OW705 code-unknown: a G or M code that this version does not have and the machine does not define.
// Depends on: the table of codes; a remap in the INI defines M codes up to M999 and G codes as motions. M100 to M199 are
// programs in PROGRAM_PREFIX or USER_M_PATH, which LinuxCNC looks for when it starts, and says so only when one is executed.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "rules/driver/code_facts.h"
#include "rules/driver/ini_places.h"
#include "rules/driver/machine_rules.h"
#include "rules/driver/remap_rules.h"
#include "rules/driver/words.h"

namespace owlint::rules::ow705 {
namespace {

constexpr int kUserFirst = 100;
constexpr int kUserLast = 199;
constexpr int kRemappedLast = 999;

/// The number of the code, in tenths for a G code; -1 where it is computed.
int number_of(const WordStop& at, std::string_view interpreter) {
  constexpr int kTenths = 10;
  if (at.letter == 'g' && at.value) return static_cast<int>(std::lround(*at.value * kTenths));
  const size_t m = interpreter.rfind('M');
  if (m == std::string_view::npos || m + 1 >= interpreter.size()) return -1;
  int number = 0;
  for (const char c : interpreter.substr(m + 1)) {
    if (c < '0' || c > '9' || number > kRemappedLast) return kRemappedLast + 1;
    number = number * 10 + (c - '0');
  }
  return number;
}

/// A file that LinuxCNC does not take for the program of a code: `M103.sh`, `m103`, or one that may not be executed.
bool has_other_file(const Files& files, const IniFolder& folder, const std::string& name, Finding& f) {
  constexpr size_t kMostNames = 10'000;
  std::string unread;  // then there are none
  size_t count = 0;
  for (const FolderEntry& entry : files.list(folder.path, &unread)) {
    if (++count > kMostNames) return false;
    const std::string path = joined_path(folder.path, entry.name);
    const bool same = entry.name == name;
    if (!same && small_letters(stem_of(entry.name)) != small_letters(name)) continue;
    if (!files.is_file(path)) continue;
    f.message = fmt::format("`{}` runs a program of the machine, but {} ", name, path) +
        (same ? "is not executable" : fmt::format("is not named `{}`", name));
    f.help = same ? fmt::format("make it executable: `chmod +x {}`", path)
                  : fmt::format("rename it to `{}`, in capitals and without an ending, and make it executable", name);
    return true;
  }
  return false;
}

/// M100 to M199: a program of the machine.
void user_code(const Input& in, int number, Finding& f) {
  f.group = "code " + m_name(number);
  f.habit_severity = Severity::kInfo;
  f.message = user_code_text(number, in.profile.setup.get());
  if (in.profile.setup == nullptr) {
    f.group = "user codes without an INI";  // which would answer for all of them
    f.help = "name the machine's INI (`--ini`), so that owlint can look for it";
    f.unproven = true;
    return;
  }
  const std::vector<const IniFolder*> searched = user_code_folders(*in.profile.setup);
  std::string folders;
  for (size_t i = 0; i < searched.size(); ++i) {
    folders += (i == 0 ? "`" : i + 1 == searched.size() ? " or `" : ", `") + searched[i]->text + "`";
    const std::string path = joined_path(searched[i]->path, m_name(number));
    if (f.unproven || !in.profile.setup->search_path->files().is_folder(path)) continue;
    f.message = "`" + m_name(number) + "` runs a program of the machine, but " + path +
        " is a folder: LinuxCNC stops without a message";
    f.help = "put the program there under this name, and give the folder another one";
    f.interpreter.clear();
    f.habit_severity.reset();
    return;
  }
  for (const IniFolder* folder : searched) {
    if (in.profile.setup->user_code(number) != UserCode::kMissing) break;
    if (!has_other_file(in.profile.setup->search_path->files(), *folder, m_name(number), f)) continue;
    relate_user_folders(in.profile, f);
    return;
  }
  if (in.profile.setup->user_code(number) == UserCode::kUnknown) {
    // All of them are the same question to the machine.
    f.message = fmt::format("`{}` runs a program of the machine, whose folders are not here", m_name(number));
    f.group = "codes in " + folders;
    f.help = "check on the machine that this program is in " + folders;
    f.unproven = f.uncertain = true;
    return;
  }
  f.help = folders.empty()
      ? "put an executable file of that name into a folder that `PROGRAM_PREFIX` or `USER_M_PATH` names"
      : "put an executable file of that name into " + folders + ": there LinuxCNC looks for it";
  relate_user_folders(in.profile, f);
}

/// `M98 2000`: LinuxCNC reads the number of the sub as part of the code, as the blank does not count.
std::string sub_without_p(const Input& in, const WordStop& at) {
  std::string_view text = in.program.source->slice(at.span);
  text.remove_prefix(1);
  text.remove_prefix(std::min(text.find_first_not_of(" \t0"), text.size()));
  if (at.letter != 'm' || !text.starts_with("98") || text.size() < 4 || (text[2] != ' ' && text[2] != '\t')) return {};
  text.remove_prefix(std::min(text.find_first_not_of(" \t", 2), text.size()));
  return text.find_first_not_of("0123456789") == std::string_view::npos ? std::string(text) : std::string();
}

/// The INI remaps the code, in a line with which LinuxCNC does not start: OW416.
bool is_refused(const Profile& profile, bool m, int number, Finding& f) {
  if (profile.setup == nullptr) return false;
  const IniText& text = profile.setup->text;
  for (const Remap& remap : remaps_of(text)) {
    if (remap.read.problem == RemapLine::Problem::kNone) continue;
    if ((m ? remap.read.m_number() : remap.read.g_number()) != number) continue;
    f.message = fmt::format("`{}` is not known, as LinuxCNC refuses its `REMAP` line and does not start",
                            m ? m_name(number) : g_name(number));
    f.help = "correct the `REMAP` line first";
    f.weight = Weight::kAside;  // said there
    f.related.push_back({remap.line->span, "this line", text.source(*remap.line)});
    return true;
  }
  return false;
}

/// `M1000`, which the INI remaps: LinuxCNC knows it then, and has nothing to run for it.
bool is_remapped_in_vain(const Profile& profile, const WordStop& at, Finding& f) {
  if (profile.setup == nullptr || f.interpreter.starts_with("M-code")) return false;
  const IniText& text = profile.setup->text;
  for (const Remap& remap : remaps_of(text)) {
    const int number = remap.read.m_number();
    const bool named = f.interpreter.ends_with(fmt::format(": M{}", number)) || at.value == number;
    if (remap.read.problem != RemapLine::Problem::kNone || number <= kRemappedLast || !named) continue;
    f.message = fmt::format("`{}` is remapped by the INI, but LinuxCNC runs no sub for M codes above 999", at.word);
    f.help = "remap a code that is free, such as `M400`, and write that";
    f.related.push_back({remap.line->span, "this line", text.source(*remap.line)});
    return true;
  }
  return false;
}

void unknown(const Input& in, const WordStop& at, int number, Finding& f) {
  if (is_remapped_in_vain(in.profile, at, f)) return;
  const bool m = f.interpreter.find("m code") != std::string::npos || f.interpreter.starts_with("M-code");
  const std::string name = number < 0 || number > kRemappedLast ? at.word : m ? m_name(number) : g_name(number);
  const std::string written = at.value || at.letter == 0 ? at.word : name;
  const CodeAdvice advice = number < 0 ? CodeAdvice{} : advice_for_code(m ? 'm' : 'g', number, release_of(in.profile));
  f.message = "`" + written + "` is not a code of LinuxCNC";
  if (!at.value && number >= 0) f.message = "`" + at.word + "` is " + name + ", which is not a code of LinuxCNC";
  if (!advice.what.empty()) f.message = "`" + written + "` " + advice.what;
  const bool later = !m && number >= 0 && g_code(number, Release::k2_10) != nullptr;
  if (!advice.what.empty() && !later) f.message += "; LinuxCNC does not have it";
  f.help = advice.help.empty() ? "write the code that is meant, or remove it" : advice.help;
  f.group = "code " + name;
  if (const auto& perhaps = in.profile.remapped_perhaps; perhaps != nullptr && perhaps->contains(name)) {
    f.message = "`" + written + "` is not a code of LinuxCNC; one of the machine INIs near this program remaps it";
    f.help = "name the machine's INI (`--ini`), so that owlint knows its codes";
    f.group = "codes that an INI near the program remaps";
    f.unproven = f.uncertain = true;
    return;
  }
  if (number >= 0 && is_refused(in.profile, m, number, f)) return;
  if (number >= 0) relate_unread_remap(in.profile, m ? 'm' : 'g', number, f);
  const bool no_ini = in.profile.setup == nullptr;
  const bool can_be_remapped = number >= 0 && number <= kRemappedLast && !later && (!m || number != code::kM98);
  if (no_ini && can_be_remapped)
    f.message += std::string(advice.what.empty() ? "," : "") + " unless the machine's INI remaps it";
  if (!m || number <= kUserLast) return;
  if (const std::string sub = sub_without_p(in, at); !sub.empty()) {
    f.message = "`M98` lacks the `P` before the number of its sub: LinuxCNC reads `" + at.word + "`";
    f.help = "write `M98 P" + sub + "`";
    return;
  }
  if (!no_ini && number <= kRemappedLast) f.message += ", and the INI does not remap it";
  f.help = number > kRemappedLast ? "M codes end at M199, remapped ones at M999"
      : no_ini                    ? "name the machine's INI (`--ini`), so that owlint knows its codes"
               : fmt::format("define it with `REMAP = {} modalgroup=10 ngc=name` in `[RS274NGC]`", name);
  f.unproven = no_ini && number <= kRemappedLast;
  if (!f.unproven) return;
  f.group = "codes of an INI";  // which is missing for all of them
  f.habit_severity = Severity::kInfo;
}

/// A code that LinuxCNC has, but for a `REMAP` line that it cannot use.
bool is_lost(const Input& in, const WordStop& at, Finding& f) {
  constexpr int kTenths = 10;
  if (!at.value || (at.letter != 'g' && at.letter != 'm')) return false;
  const auto number = static_cast<int>(std::lround(*at.value * (at.letter == 'g' ? kTenths : 1)));
  for (const LostRemap& lost : lost_codes(in.profile)) {
    if (lost.code.letter != at.letter || lost.code.number != number) continue;
    // It is still a program of the machine.
    const bool user = number >= kUserFirst && number <= kUserLast && lost.code.group == MGroup::kUser;
    if (at.letter == 'm' && user) return false;
    f.message = fmt::format("LinuxCNC cannot remap `{}`, and because of its `REMAP` {}", lost.name,
                            lost.crashes ? "it crashes here, or stops" : "the code stops the program");
    blame(in.profile, lost, f);
    f.group = "code " + lost.name;
    return true;
  }
  return false;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& stop) -> Finding* {
    const WordStop at = word_stop(in, stop);
    Finding& f = out.add(at.span, "");
    f.interpreter = stop.interpreter;
    const int number = number_of(at, stop.interpreter);
    const bool m = f.interpreter.find("m code") != std::string::npos;
    if (is_lost(in, at, f)) return &f;
    if (m && number >= kUserFirst && number <= kUserLast) {
      user_code(in, number, f);
    } else if (!sub_without_p(in, at).empty() || !tell_split_code(*in.program.source, at, f)) {
      unknown(in, at, number, f);
    }
    constexpr int kG50 = 500;
    if (std::optional<Habit> habit = !m && number == kG50 ? habit_of(in, stop.statement) : std::nullopt) {
      f.message = std::move(habit->message);
      f.help = std::move(habit->help);
    }
    return &f;
  });
}

/// The first line of a program, if it is the kernel's `#!`: which interpreter runs it.
void check_user_program(const SetupInput& in, Reporter& out, const std::string& path, const std::string& name) {
  constexpr uint64_t kMostBytes = 1'000'000;
  const Files& files = in.library.files();
  if (files.info(path).bytes > kMostBytes) return;
  std::string error;
  const auto source = files.read(path, &error);
  if (source == nullptr || !source->bytes().starts_with("#!")) return;
  const std::string_view bytes = source->bytes();
  const size_t end = std::min(bytes.find('\n'), bytes.size());
  const std::string_view line = bytes.substr(0, end);
  const std::string stops = fmt::format(": `{}` stops the program without a message", name);
  if (line.ends_with('\r')) {
    Finding& f = out.add(source, {0, end},
                         fmt::format("`{}` ends with a carriage return, so LinuxCNC cannot run this file{}",
                                     line.substr(0, end - 1), stops));
    f.help = "save the file with Unix line endings (LF)";
    f.stops = true;
    return;
  }
  const size_t first = std::min(line.find_first_not_of(" \t", 2), line.size());
  const std::string interpreter(line.substr(first, std::min(line.find_first_of(" \t", first), line.size()) - first));
  // Where there is no shell, this is not the computer of a machine.
  if (!interpreter.starts_with('/') || files.exists(interpreter) || !files.exists("/bin/sh")) return;
  Finding& f = out.add(source, {first, first + interpreter.size()},
                       fmt::format("there is no `{}` on this computer; if the machine has none{}", interpreter, stops));
  f.message.replace(f.message.rfind(": "), 2, ", ");
  f.help = "name a program that is there, such as `/bin/sh` or `/usr/bin/env python3`";
  f.unproven = true;
}

/// Measured with LinuxCNC: a program that the system cannot run stops the G-code without a word.
void check_setup(const SetupInput& in, Reporter& out) {
  for (int number = kUserFirst; number <= kUserLast; ++number) {
    if (in.setup.user_code(number) != UserCode::kThere) continue;
    for (const IniFolder* folder : user_code_folders(in.setup)) {
      const std::string path = joined_path(folder->path, m_name(number));
      const FileInfo info = in.library.files().info(path);
      if (info.kind != FileKind::kFile || !info.executable) continue;
      check_user_program(in, out, path, m_name(number));
      break;
    }
  }
}

}  // namespace

extern const Rule kRule{
    .code = "OW705",
    .name = "code-unknown",
    .summary = "a G or M code that LinuxCNC does not have and the machine does not define",
    .group = Group::kWords,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A G or M code that is not in LinuxCNC's table, such as `M17`, `G12` or `G65`. Of codes that other
controllers have, owlint says what LinuxCNC has instead; of others, which codes are typed nearly the
same. docs/codes.md lists all codes.

An INI can add codes with `REMAP`, and M100 to M199 are programs that the machine's owner adds. With the
machine's INI (`--ini`) owlint knows them. Without it, M100 and above are warnings: nobody writes them who has
no such machine. `M13`, `G37` and the like are errors, as they mostly come from another controller or are typed
wrong; the message says where an INI could define the code.
With the INI, owlint also looks at the first line of these programs: LinuxCNC cannot run one whose `#!` line
ends with a carriage return, or names an interpreter that does not exist.

A `REMAP` of a code that LinuxCNC cannot remap takes the code's own meaning away (OW417). Where the code then stops
the program, the finding is at the line that uses it.)",
            .why =
                R"(LinuxCNC stops when it reads the line, with `Unknown g code used`, `Unknown m code used: M17` or `M-code
greater than 199: M428`. Nothing of the line is executed. M100 to M199 are read without an error, and
`Unknown m code used: M110` comes when the line is executed and there is no such program.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
M13 S1000
G1 Z-2 F80
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
M3 M8 S1000
G1 Z-2 F80
G0 Z5
M2
)",
            .fix =
                R"(Write the code that LinuxCNC has for it. If the machine has a remap or a program for the code, name its
INI.)",
            .level_reason = "Error: the program stops. Warning for M100 and above without an INI: the machine may have "
                            "them. Warning if it stops at an earlier line first.",
            .interpreter = "Unknown m code used: M13",
            .options = "",
        },
    .check = check,
    .check_setup = check_setup,
};

}  // namespace owlint::rules::ow705
