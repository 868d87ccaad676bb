// `owlint config`: which settings a program is checked with, and where each of them comes from.
#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include "analyzer/checking/walk.h"
#include "analyzer/cli/commands.h"
#include "analyzer/text/files.h"

namespace owlint::cli {
namespace {

/// For a folder, a program in it.
std::string program_in(const std::string& path) { return disk().is_folder(path) ? path + "/program.ngc" : path; }

int check_files(const std::vector<std::string>& paths) {
  int status = kClean;
  for (const std::string& path : paths) {
    std::string file = path;
    for (const char* name : {"/owlint.toml", "/.owlint.toml"}) {
      if (disk().is_folder(path) && disk().is_file(path + name)) file = path + name;
    }
    std::string error;
    if (disk().is_folder(file)) {
      complain(fmt::format("no owlint.toml in {}", path));
      status = kUsage;
    } else if (read_configuration_file(disk(), file, &error) == nullptr) {
      complain(error);
      status = kUsage;
    } else {
      std::cout << file << " is valid\n";
    }
  }
  return status;
}

}  // namespace

int config_command(const CommandLine& line, bool check) {
  const std::vector<std::string> paths = line.paths.empty() ? std::vector<std::string>{"."} : line.paths;
  if (check) return check_files(paths);
  Configuration configuration(disk(), line);
  configuration.tell_origins();
  int status = kClean;
  for (const std::string& path : paths) {
    Settings settings;
    std::string error;
    if (!disk().exists(path)) {
      complain(fmt::format("there is no {}", path));
      status = kUsage;
      continue;
    }
    if (!configuration.settings_for(program_in(path), &settings, &error)) {
      complain(error);
      status = kUsage;
      continue;
    }
    std::vector<Origin>& origins = settings.origins;
    const auto given = [&](std::string_view key) {
      return std::ranges::find(origins, key, &Origin::key) != origins.end();
    };
    const Profile& profile = settings.profile;
    if (!given("ini")) origins.push_back({"ini", "none", "default"});
    if (!given("fail-on")) origins.push_back({"fail-on", "error", "default"});
    if (!given("linuxcnc")) origins.push_back({"linuxcnc", std::string(version_text(profile.version)), "default"});
    origins.push_back({"FEATURE 0x20", profile.warn_only() ? "in effect" : "not in effect",
                       given("feature")               ? "feature"
                           : profile.setup != nullptr ? "INI"
                                                      : "default"});
    const auto rules =
        std::ranges::count_if(catalogue(), [&](const Rule* rule) { return selected(*rule, settings.options); });
    origins.push_back({"rules", fmt::format("{} of {}", rules, catalogue().size()), "select, extend-select, ignore"});
    std::cout << path << '\n';
    for (const Origin& o : origins) std::cout << fmt::format("  {:<16} {:<24} # {}\n", o.key, o.value, o.from);
  }
  return status;
}

}  // namespace owlint::cli
