// Settings for one file: the request (of a command line, an editor, a caller of the API) overrides the nearest owlint.toml,
// which overrides the defaults.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "analyzer/checking/configuration_file.h"
#include "analyzer/checking/walk.h"
#include "analyzer/machine/profile.h"
#include "rules/driver/lint.h"

namespace owlint::checking {

/// What is to be checked, and with which settings. Unset: a configuration file or the default decides.
struct CheckRequest {
  std::vector<std::string> paths;
  WalkOptions walk;
  std::optional<std::string> ini, feature, linuxcnc, config;
  std::vector<std::string> sub_path;  ///< folders in which called files are looked for as well
  std::vector<std::string> select, extend_select, ignore;
  std::vector<std::string> severity;   ///< CODE=LEVEL
  std::optional<std::string> fail_on;  ///< a severity
  unsigned jobs = 0;                   ///< 0: one per core
  bool isolated = false;               ///< no configuration file is read
  bool absolute = false;  ///< paths in findings are absolute, so that they do not depend on the current folder
  bool coarse = false;    ///< for tests: analyse every program like a very large one
  bool find_ini = true;   ///< look for a machine INI above the programs
};

/// One setting and where it comes from.
struct Origin {
  std::string key;
  std::string value;
  std::string from;  ///< `owlint.toml:3`, `command line`, `found above the program`
};

struct Settings {
  Profile profile;
  LintOptions options;
  std::vector<Origin> origins;  ///< in their order; only for `owlint config`
  bool of_ini = false;          ///< the file is the machine's INI, and no program
};

/// Finds and reads configuration files and machine INIs, each once. Not thread-safe.
class Configuration {
 public:
  /// Both must outlive this, and `files` the settings as well.
  Configuration(const Files& files, const CheckRequest& request) : files_(files), request_(request) {}

  /// Folders that are known to have no *.ini, by their file_key: they are not read again. Must outlive this.
  void know_without_ini(const std::unordered_set<std::string>& folders) { without_ini_ = &folders; }
  /// From now on, settings_for() notes where settings come from.
  void tell_origins() { tells_origins_ = true; }
  /// The settings for a file; returns false and a message if a configuration, INI or option is wrong.
  bool settings_for(const std::string& path, Settings* settings, std::string* error);

  /// The same, shared by all files of a folder if there are no overrides; returns null and a message for an error.
  std::shared_ptr<const Settings> shared_settings(const std::string& path, std::string* error);

  /// From which severity on findings in a file make owlint fail.
  Severity fail_on(const std::string& path);

  /// What the configuration that holds in a folder says of files; null if it says nothing.
  std::shared_ptr<const FilePatterns> patterns_in(const std::string& folder);

  /// Messages for users about the settings that were found. However many INIs there are, they take two notes at most.
  std::vector<std::string> notes() const;

 private:
  /// The configuration file that holds for a program; null where there is none, and with a message where it is wrong.
  std::shared_ptr<const ConfigurationFile> file_for(const std::string& program, std::string* error);
  std::shared_ptr<const ConfigurationFile> load(const std::string& path, std::string* error);
  /// Whether a file is a machine's INI for this request, and no program.
  bool is_taken_ini(const std::string& path) const;
  std::string nearest(const std::string& program);
  bool read_machine_ini(const std::string& path, Profile* profile, std::string* error);
  /// The folders of `--sub-path`, then those of the configuration file.
  bool find_sub_path(const ConfigurationFile* file, const std::string& program, Settings* settings,
                     std::string* error) const;
  std::vector<std::string> machine_inis(const std::string& folder) const;
  std::string ini_above(const std::string& program);
  /// The codes that the INIs in the nearest folder above remap, if there are several; null if they remap none.
  std::shared_ptr<const std::set<std::string>> codes_of_several(const std::string& program) const;
  /// A path for findings and messages about a program: as short as the program's own, and absolute if that is.
  std::string shown_path(const std::string& path, const std::string& program) const;

  const Files& files_;
  const CheckRequest& request_;
  const std::unordered_set<std::string>* without_ini_ = nullptr;
  bool tells_origins_ = false;
  std::string last_folder_;
  std::shared_ptr<const Settings> last_shared_;
  std::map<std::string, std::shared_ptr<const ConfigurationFile>> loaded_;
  std::map<std::string, std::string> nearest_;  // folder -> configuration file, "" for none
  std::map<std::pair<std::string, std::vector<std::string>>, std::shared_ptr<const MachineSetup>>
      inis_;                                       // by path and sub-path
  std::map<std::string, std::string> inis_above_;  // folder -> INI, "" for none
  std::map<std::string, std::shared_ptr<const std::set<std::string>>>
      codes_above_;                     // folder -> what its several INIs remap
  std::vector<std::string> used_inis_;  // found above programs
  std::vector<std::string> undecided_;  // folders with several INIs
  size_t first_undecided_ = 0;          // how many the first of them has
  std::vector<std::string> notes_;      // what else there is to say
};

}  // namespace owlint::checking
