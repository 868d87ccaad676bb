// A machine as its INI describes it: the settings that change what programs do, where called files are looked for, its
// tools, and which subs are called from outside any program. Measured with `rs274 -i` (see docs/interpreter.md).
#pragma once

#include <bitset>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/machine/ini.h"
#include "analyzer/machine/ini_text.h"
#include "analyzer/machine/search_path.h"
#include "analyzer/machine/tool_table.h"

namespace owlint {

/// A folder that the INI names, or a part of a list of them.
struct IniFolder {
  std::string text;  ///< as the INI has it
  std::string path;  ///< resolved
  std::string_view key;
  std::shared_ptr<const Source> source;
  Span span;
  bool exists = false;
};

/// O-word code or the name of a sub in the INI.
struct IniCall {
  std::string_view key;  ///< `REMAP`, `NGCGUI_SUBFILE`, `MDI_COMMAND`, `RS274NGC_STARTUP_CODE`, `ON_ABORT_COMMAND`
  std::string code;      ///< a line of G-code; if only a sub is named, a call of it
  std::string name;      ///< the sub, if the INI names it
  std::shared_ptr<const Source> source;
  Span span;
};

/// Whether a machine has the program of a code M100 to M199.
enum class UserCode : uint8_t {
  kThere,
  kMissing,
  kUnknown,  ///< a folder of the INI is not here
};

struct MachineSetup {
  /// Of M100 to M199.
  UserCode user_code(int code) const;

  std::string path;              ///< of the INI
  std::optional<uint32_t> mask;  ///< FEATURE or FEATURES
  const Ini::Entry* mask_entry = nullptr;
  bool warnonly = false;              ///< OWORD_WARNONLY
  bool counts_arguments = false;      ///< OWORD_NARGS: subs have `#<n_args>`
  bool reads_ini = true;              ///< INI_VARS: programs read entries of the INI as `#<_ini[section]entry>`
  bool reads_hal = true;              ///< HAL_PIN_VARS: and pins as `#<_hal[pin]>`
  bool no_fanuc = false;              ///< DISABLE_FANUC_STYLE_SUB
  bool has_remaps = false;            ///< codes on motion lines may run subs
  bool has_python = false;            ///< a called sub may be a Python function
  int32_t spindles = 1;               ///< [TRAJ]SPINDLES, as the interpreter has it: any number
  bool change_keeps_spindle = false;  ///< TOOL_CHANGE_WITH_SPINDLE_ON: M6 does not stop it
  bool change_stays = false;          ///< M6 goes nowhere
  bool retains_offset = false;        ///< RETAIN_G43: each line repeats G43 while an offset is on
  std::vector<IniFolder> folders;     ///< PROGRAM_PREFIX, SUBROUTINE_PATH, NGCGUI_SUBFILE_PATH, USER_M_PATH
  std::bitset<100> user_codes;        ///< from M100 on: those whose file is there and may be executed
  bool user_folders_known = true;     ///< all folders in which such files are looked for are here
  std::vector<IniCall> calls;         ///< subs that the machine calls, without a program
  std::shared_ptr<const SearchPath> search_path;
  std::optional<ToolTable> tools;  ///< none if there is no file of them, or if a program keeps them: DB_PROGRAM
  std::shared_ptr<const Source> tools_source;  ///< the file of `tools`
  Ini ini;
  IniText text;  ///< the same files line by line, with what no reader sees
};

/// Whether there is a file for a sub that the INI calls; ngcgui also looks in NGCGUI_SUBFILE_PATH.
bool has_file(const MachineSetup& setup, const IniCall& call, const std::string& name);

/// Reads a machine's INI; the folders of `sub_path` come after its own in the search path. Returns null and a message if it
/// cannot be read. `files` must outlive the setup, whose search path asks them.
std::shared_ptr<const MachineSetup> read_setup(const Files& files, const std::string& path, std::string* error,
                                               const std::vector<std::string>& sub_path = {});

/// A FEATURE mask in decimal or 0x hexadecimal.
std::optional<uint32_t> parse_mask(std::string_view text);

}  // namespace owlint
