// One owlint.toml: reads it, and says what is wrong with it. docs/configuration.md says what each key means.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/checking/walk.h"
#include "analyzer/findings/finding.h"

namespace owlint::checking {

/// Which rules are wanted and how bad their findings are: what `[[overrides]]` may change.
struct Selection {
  std::optional<std::vector<std::string>> select, ignore, extend_select;  ///< codes or their beginnings
  std::map<std::string, Severity, std::less<>> severity;
};

struct ConfigurationFile {
  std::string path;                                    ///< as seen from the working folder
  std::string folder;                                  ///< absolute; everything that the file names is seen from here
  std::map<std::string, uint32_t, std::less<>> lines;  ///< of its keys
  std::optional<std::string> ini, linuxcnc;
  std::optional<std::vector<std::string>> sub_path, exclude, include;
  std::shared_ptr<const FilePatterns> patterns;  ///< of `exclude` and `include`; null without these
  std::optional<uint32_t> feature;
  std::optional<Severity> fail_on;
  bool find_ini = true;
  Selection base;
  struct Override {
    std::vector<std::string> files;  ///< patterns
    Selection selection;
    uint32_t line;
  };
  std::vector<Override> overrides;

  /// The place of a key, for people.
  std::string place_of(std::string_view key) const;
};

/// Null and a message, with the file and the line, where something is wrong.
std::shared_ptr<const ConfigurationFile> read_configuration_file(const Files& files, const std::string& path,
                                                                 std::string* error);

/// Makes the codes that a text means of it: `OW104` of `ow104` and of `if-label-reused`, `OW3` of `ow3`. False and a message
/// where there is no such rule.
bool take_code(std::string* code, std::string* error);

}  // namespace owlint::checking
