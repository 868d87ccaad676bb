// Settings for one file: the command line over the nearest owlint.toml over the defaults.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "analyzer/cli/walk.h"
#include "analyzer/machine/profile.h"
#include "rules/lint.h"

namespace owlint::cli {

/// What the command line says; unset where it is silent.
struct CommandLine {
  std::vector<std::string> paths;
  WalkOptions walk;
  std::optional<std::string> ini, feature, linuxcnc, config;
  std::vector<std::string> sub_path;  ///< folders in which called files are looked for as well
  std::vector<std::string> select, extend_select, ignore;
  std::vector<std::string> severity;  ///< CODE=LEVEL
  std::string fail_on = "error";
  std::string format = "text";
  std::string output;
  std::string color = "auto";
  std::string stdin_filename = "<stdin>";
  unsigned jobs = 0;  ///< 0: as many as there are cores
  bool isolated = false;
  bool statistics = false;
  bool quiet = false;
  bool fix = false, unsafe = false, diff = false, fix_only = false;
  std::string baseline, since, reason;  ///< empty where not given
  bool update_baseline = false, add_suppressions = false;
  bool absolute = false;  ///< paths that findings name are absolute: they stay right wherever owlint is started
  bool coarse = false;   ///< for tests: analyse every program like a very large one
  bool find_ini = true;  ///< look for a machine INI above the programs
};

/// One setting as it was made.
struct Origin {
  std::string key;
  std::string value;
  std::string from;  ///< `owlint.toml:3`, `command line`, `found above the program`
};

struct Settings {
  Profile profile;
  LintOptions options;
  std::vector<Origin> origins;  ///< in the order in which they were made; only for `owlint config`
};

/// Finds and reads configuration files and machine INIs, each once. Not for several threads at a time.
class Configuration {
 public:
  explicit Configuration(const CommandLine& line) : line_(line) {}

  /// Folders that are known to have no *.ini, by their file_key: they are not read again. Must outlive this.
  void know_without_ini(const std::unordered_set<std::string>& folders) { without_ini_ = &folders; }
  /// From now on, settings_for() tells where settings come from.
  void tell_origins() { tells_origins_ = true; }
  /// Reads one configuration file; false and a message where it is wrong.
  bool check_file(const std::string& path, std::string* error) { return load(path, error) != nullptr; }

  /// The settings for a file; false and a message when a configuration, INI or option is wrong.
  bool settings_for(const std::string& path, Settings* settings, std::string* error);

  /// The same, shared by the files of a folder where no override tells them apart; null and a message for an error.
  std::shared_ptr<const Settings> shared_settings(const std::string& path, std::string* error);

  /// What users should know of the settings that were found, each reported once.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct File;
  const File* load(const std::string& path, std::string* error);
  const File* nearest(const std::string& program, std::string* error);
  bool read_machine_ini(const std::string& path, Profile* profile, std::string* error);
  /// The folders of `--sub-path`, then those of the configuration file.
  bool find_sub_path(const File* file, const std::string& program, Settings* settings, std::string* error) const;
  std::vector<std::string> machine_inis(const std::string& folder) const;
  std::string ini_above(const std::string& program);
  /// A path for findings and messages about a program: as short as the program's own, and absolute if that is.
  std::string shown_path(const std::string& path, const std::string& program) const;

  const CommandLine& line_;
  const std::unordered_set<std::string>* without_ini_ = nullptr;
  bool tells_origins_ = false;
  std::string last_folder_;
  std::shared_ptr<const Settings> last_shared_;
  std::map<std::string, std::shared_ptr<File>> files_;
  std::map<std::string, std::string> nearest_;  // folder -> configuration file, "" for none
  std::map<std::pair<std::string, std::vector<std::string>>, std::shared_ptr<const MachineSetup>> inis_;  // by path and sub-path
  std::map<std::string, std::string> inis_above_;  // folder -> INI, "" for none
  std::vector<std::string> notes_;
};

}  // namespace owlint::cli
