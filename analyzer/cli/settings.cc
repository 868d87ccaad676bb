#include "analyzer/cli/settings.h"

#include <fnmatch.h>

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "rules/stops.h"

namespace owlint::cli {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kKeys = {"ini", "find-ini", "sub-path", "feature", "linuxcnc", "select", "ignore", "extend-select", "severity", "overrides"};
const std::vector<std::string> kOverrideKeys = {"files", "select", "ignore", "extend-select", "severity"};

/// The part of a configuration that `[[overrides]]` may change.
struct Selection {
  std::optional<std::vector<std::string>> select, ignore, extend_select;
  std::map<std::string, Severity, std::less<>> severity;
};

bool check_keys(const toml::table& table, const std::vector<std::string>& known, std::string* error) {
  for (const auto& [key, value] : table) {
    const std::string name(key.str());
    if (std::ranges::find(known, name) != known.end()) continue;
    const std::string near = rules::nearest(name, known);
    *error = fmt::format("line {}: unknown key `{}`{}", value.source().begin.line, name, near.empty() ? "" : ", did you mean `" + near + "`?");
    return false;
  }
  return true;
}

/// A list of texts; `what` says of what, for people.
bool read_list(const toml::table& table, std::string_view key, std::string_view what, std::optional<std::vector<std::string>>* list, std::string* error) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return true;
  const toml::array* array = node->as_array();
  list->emplace();
  for (size_t i = 0; array != nullptr && i < array->size(); ++i) {
    if (const auto text = array->get(i)->value<std::string>(); text && !text->empty()) (*list)->push_back(*text);
  }
  if (array != nullptr && (*list)->size() == array->size()) return true;
  *error = fmt::format("line {}: `{}` is a list of {}", node->source().begin.line, key, what);
  return false;
}

bool check_code(const std::string& code, std::string* error) {
  if (known_prefix(code)) return true;
  const std::string_view near = nearest_rule(code);
  *error = fmt::format("`{}` is not a code of owlint{}", code, near.empty() ? "" : fmt::format(", did you mean `{}`?", near));
  return false;
}

bool read_codes(const toml::table& table, std::string_view key, std::optional<std::vector<std::string>>* codes, std::string* error) {
  if (!read_list(table, key, "codes", codes, error)) return false;
  return !*codes || std::ranges::all_of(**codes, [&](const std::string& code) { return check_code(code, error); });
}

bool read_selection(const toml::table& table, Selection* selection, std::string* error) {
  if (!read_codes(table, "select", &selection->select, error) || !read_codes(table, "ignore", &selection->ignore, error) ||
      !read_codes(table, "extend-select", &selection->extend_select, error)) {
    return false;
  }
  const toml::node* node = table.get("severity");
  if (node == nullptr) return true;
  const toml::table* levels = node->as_table();
  if (levels == nullptr) {
    *error = fmt::format("line {}: `severity` is a table of codes and levels", node->source().begin.line);
    return false;
  }
  for (const auto& [key, value] : *levels) {
    const std::string code(key.str());
    Severity severity{};
    if (!check_code(code, error)) return false;
    if (!severity_from_text(value.value_or(std::string()), &severity)) {
      *error = fmt::format("line {}: the severity of `{}` is one of off, info, warning, error", value.source().begin.line, code);
      return false;
    }
    selection->severity[code] = severity;
  }
  return true;
}

/// `select` replaces what was selected before; the others add to it.
void apply(const Selection& selection, LintOptions* options) {
  const auto add = [](const std::optional<std::vector<std::string>>& codes, std::vector<std::string>* to) {
    if (codes) to->insert(to->end(), codes->begin(), codes->end());
  };
  if (selection.select) options->select = *selection.select;
  add(selection.ignore, &options->ignore);
  add(selection.extend_select, &options->extend_select);
  for (const auto& [code, severity] : selection.severity) options->severity[code] = severity;
}

}  // namespace

struct Configuration::File {
  std::string path;
  std::string folder;
  std::map<std::string, uint32_t, std::less<>> lines;  // of the keys
  std::optional<std::string> ini, linuxcnc;
  std::optional<std::vector<std::string>> sub_path;
  bool find_ini = true;
  std::optional<uint32_t> feature;
  Selection base;
  struct Override {
    std::vector<std::string> patterns;
    Selection selection;
    uint32_t line;
  };
  std::vector<Override> overrides;
};

const Configuration::File* Configuration::load(const std::string& path, std::string* error) {
  if (const auto known = files_.find(path); known != files_.end()) return known->second.get();
  auto file = std::make_shared<File>();
  std::error_code ignored;
  file->folder = fs::absolute(path, ignored).parent_path().string();
  toml::table table;
  try {
    table = toml::parse_file(path);
  } catch (const toml::parse_error& problem) {
    *error = fmt::format("{}: line {}: {}", path, problem.source().begin.line, problem.description());
    return nullptr;
  }
  std::error_code outside;
  file->path = fs::proximate(path, outside).string();
  for (const auto& [key, value] : table) file->lines.emplace(key.str(), value.source().begin.line);
  const auto text = [&](std::string_view key, std::optional<std::string>* value) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return true;
    *value = node->value<std::string>();
    if (!*value) *error = fmt::format("line {}: `{}` is a text in quotes", node->source().begin.line, key);
    return value->has_value();
  };
  bool good = check_keys(table, kKeys, error) && text("ini", &file->ini) && text("linuxcnc", &file->linuxcnc) &&
              read_list(table, "sub-path", "folders", &file->sub_path, error) && read_selection(table, &file->base, error);
  if (const toml::node* node = table.get("find-ini"); good && node != nullptr) {
    good = node->is_boolean();
    if (!good) *error = fmt::format("line {}: `find-ini` is true or false", node->source().begin.line);
    file->find_ini = node->value_or(true);
  }
  if (const toml::node* node = table.get("feature"); good && node != nullptr) {
    if (const auto number = node->value<int64_t>(); number && *number >= 0) {
      file->feature = static_cast<uint32_t>(*number);
    } else {
      file->feature = parse_mask(node->value_or(std::string()));
    }
    if (!file->feature) {
      *error = fmt::format("line {}: `feature` is a number, as 32 or 0x20", node->source().begin.line);
      good = false;
    }
  }
  if (const toml::node* node = table.get("overrides"); good && node != nullptr) {
    const toml::array* list = node->as_array();
    good = list != nullptr && list->is_array_of_tables();
    if (!good) *error = fmt::format("line {}: `overrides` is a list of tables, written `[[overrides]]`", node->source().begin.line);
    for (size_t i = 0; good && i < list->size(); ++i) {
      const toml::table& entry = *list->get(i)->as_table();
      std::vector<std::string> patterns;
      if (const toml::array* files = entry["files"].as_array()) {
        for (const toml::node& pattern : *files) patterns.push_back(pattern.value_or(std::string()));
      }
      Selection selection;
      good = check_keys(entry, kOverrideKeys, error) && read_selection(entry, &selection, error);
      if (good && (patterns.empty() || std::ranges::find(patterns, "") != patterns.end())) {
        *error = fmt::format("line {}: an override needs `files`, a list of patterns", entry.source().begin.line);
        good = false;
      }
      file->overrides.push_back({std::move(patterns), std::move(selection), entry.source().begin.line});
    }
  }
  if (good && file->linuxcnc && *file->linuxcnc != "all" && !version_from_text(*file->linuxcnc)) {
    *error = fmt::format("`linuxcnc` is one of 2.7, 2.8, 2.9, 2.10, all, not `{}`", *file->linuxcnc);
    good = false;
  }
  if (!good) {
    *error = path + ": " + *error;
    return nullptr;
  }
  return files_.emplace(path, std::move(file)).first->second.get();
}

const Configuration::File* Configuration::nearest(const std::string& program, std::string* error) {
  std::error_code ignored;
  fs::path folder = fs::absolute(program, ignored).parent_path();
  const std::string key = folder.string();
  if (const auto known = nearest_.find(key); known != nearest_.end()) {
    return known->second.empty() ? nullptr : load(known->second, error);
  }
  std::string found;
  for (;; folder = folder.parent_path()) {
    for (const char* name : {"owlint.toml", ".owlint.toml"}) {
      if (fs::is_regular_file(folder / name, ignored)) found = (folder / name).string();
      if (!found.empty()) break;
    }
    if (!found.empty() || folder == folder.parent_path()) break;
  }
  nearest_[key] = found;
  return found.empty() ? nullptr : load(found, error);
}

bool Configuration::read_machine_ini(const std::string& path, Profile* profile, std::string* error) {
  const std::pair key(path, profile->sub_path);
  auto known = inis_.find(key);
  if (known == inis_.end()) {
    auto setup = read_setup(path, error, profile->sub_path);
    if (setup == nullptr) {
      *error = fmt::format("cannot read the INI {}: {}", path, *error);
      return false;
    }
    for (const Ini::Entry& missing : setup->ini.missing_includes()) {
      notes_.push_back(fmt::format("{}: line {}: cannot read the file of `#INCLUDE {}`", path,
                                   missing.source->position(missing.span.begin).line, missing.value));
    }
    known = inis_.emplace(key, std::move(setup)).first;
  }
  profile->setup = known->second;
  return true;
}

namespace {

/// Whether a file is the INI of a LinuxCNC machine, and not another program's.
bool is_machine_ini(const fs::path& path) {
  std::string error;
  Ini ini;
  return ini.read(path.string(), &error) && (ini.has_section("RS274NGC") || ini.has_section("EMC"));
}

}  // namespace

/// The INIs of machines in a folder, sorted.
std::vector<std::string> Configuration::machine_inis(const std::string& folder) const {
  std::vector<std::string> out;
  if (without_ini_ != nullptr && without_ini_->contains(folder)) return out;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored); !ignored && entry != fs::directory_iterator(); entry.increment(ignored)) {
    if (entry->path().extension() == ".ini" && is_machine_ini(entry->path())) out.push_back(entry->path().string());
  }
  std::ranges::sort(out);
  return out;
}

/// The one machine INI in the nearest folder above a program that has any.
std::string Configuration::ini_above(const std::string& program) {
  std::vector<std::string> passed;
  std::string found;
  for (std::string folder(folder_of(file_key(program)));; folder = folder_of(folder)) {
    if (const auto known = inis_above_.find(folder); known != inis_above_.end()) {
      found = known->second;
      break;
    }
    passed.push_back(folder);
    const std::vector<std::string> candidates = machine_inis(folder);
    if (candidates.size() == 1) {
      found = candidates[0];
      std::error_code ignored;
      const std::string near = fs::proximate(found, ignored).string();
      notes_.push_back(fmt::format("using the machine INI {} (--no-find-ini turns this off)", near.starts_with("../") ? found : near));
    } else if (candidates.size() > 1) {
      notes_.push_back(fmt::format("{} machine INIs in {}, none is used: choose one with --ini", candidates.size(), folder));
    }
    if (!candidates.empty() || folder == "/") break;
  }
  for (const std::string& folder : passed) inis_above_[folder] = found;
  return found;
}

std::string Configuration::shown_path(const std::string& path, const std::string& program) const {
  std::error_code ignored;
  return line_.absolute || program.starts_with('/') ? file_key(path) : fs::proximate(path, ignored).string();
}

bool Configuration::find_sub_path(const File* file, const std::string& program, Settings* settings, std::string* error) const {
  std::vector<std::string>& folders = settings->profile.sub_path;
  const auto add = [&](const std::string& path, const std::string& from) {
    std::error_code problem;
    if (!fs::is_directory(path, problem)) {
      *error = fmt::format("{}: there is no folder {}", from, path);
      return false;
    }
    folders.push_back(path);
    if (tells_origins_) settings->origins.push_back({"sub-path", path, from});
    return true;
  };
  for (const std::string& folder : line_.sub_path) {
    if (!add(line_.absolute ? file_key(folder) : folder, "--sub-path")) return false;
  }
  for (const std::string& folder : file != nullptr && file->sub_path ? *file->sub_path : std::vector<std::string>()) {
    const std::string path = (fs::path(file->folder) / expand_home(folder)).string();
    if (!add(shown_path(path, program), fmt::format("{}:{}", file->path, file->lines.find("sub-path")->second))) return false;
  }
  return true;
}

std::shared_ptr<const Settings> Configuration::shared_settings(const std::string& path, std::string* error) {
  const std::string folder = path.substr(0, path.rfind('/') + 1);
  if (last_shared_ != nullptr && folder == last_folder_) return last_shared_;
  auto settings = std::make_shared<Settings>();
  if (!settings_for(path, settings.get(), error)) return nullptr;
  const File* file = line_.config ? load(*line_.config, error) : line_.isolated ? nullptr : nearest(path, error);
  last_folder_ = folder;
  last_shared_ = file == nullptr || file->overrides.empty() ? settings : nullptr;
  return settings;
}

bool Configuration::settings_for(const std::string& path, Settings* settings, std::string* error) {
  const File* file = nullptr;
  error->clear();
  if (line_.config) {
    file = load(*line_.config, error);
  } else if (!line_.isolated) {
    file = nearest(path, error);
  }
  if (!error->empty()) return false;

  const auto note = [&](std::string_view key, const std::string& value, const std::string& from) {
    if (tells_origins_) settings->origins.push_back({std::string(key), value, from});
  };
  const auto note_selection = [&](const Selection& selection, const auto& where) {
    if (!tells_origins_) return;
    const auto codes = [&](const char* key, const auto& list) {
      if (list) note(key, fmt::format("{}", fmt::join(*list, " ")), where(key));
    };
    codes("select", selection.select);
    codes("extend-select", selection.extend_select);
    codes("ignore", selection.ignore);
    for (const auto& [code, level] : selection.severity) note("severity." + code, std::string(severity_text(level)), where("severity"));
  };
  const auto line_of = [&](std::string_view key) { return fmt::format("{}:{}", file->path, file->lines.find(key)->second); };
  std::optional<std::string> ini = line_.ini;
  if (ini && line_.absolute) ini = file_key(*ini);
  if (ini) note("ini", *ini, "command line");
  std::optional<std::string> version = line_.linuxcnc;
  Profile& profile = settings->profile;
  LintOptions& options = settings->options;
  if (file != nullptr) {
    if (!ini && file->ini) {
      ini = shown_path((fs::path(file->folder) / *file->ini).string(), path);
      note("ini", *ini, line_of("ini"));
    }
    if (!version && file->linuxcnc) {
      version = file->linuxcnc;
      note("linuxcnc", *version, line_of("linuxcnc"));
    }
    if (file->feature) note("feature", fmt::format("{:#x}", *file->feature), line_of("feature"));
    if (!file->find_ini) note("find-ini", "false", line_of("find-ini"));
    note_selection(file->base, line_of);
    profile.feature = file->feature;
    apply(file->base, &options);
    std::error_code ignored;
    const std::string relative = fs::absolute(path, ignored).lexically_relative(file->folder).string();
    for (const File::Override& entry : file->overrides) {
      if (std::ranges::any_of(entry.patterns, [&](const std::string& p) { return ::fnmatch(p.c_str(), relative.c_str(), 0) == 0; })) {
        apply(entry.selection, &options);
        note_selection(entry.selection, [&](const char*) { return fmt::format("{}:{} [[overrides]]", file->path, entry.line); });
      }
    }
  }
  if (line_.coarse) options.detail = Detail::kCoarse;
  if (version && *version == "all") {
    options.all_versions = true;
  } else if (version) {
    const auto parsed = version_from_text(*version);
    if (!parsed) {
      *error = fmt::format("unknown LinuxCNC version `{}`: one of 2.7, 2.8, 2.9, 2.10, all", *version);
      return false;
    }
    profile.version = *parsed;
    profile.version_given = true;
  }
  if (line_.feature) {
    profile.feature = parse_mask(*line_.feature);
    if (!profile.feature) {
      *error = fmt::format("`--feature {}` is not a number, as 32 or 0x20", *line_.feature);
      return false;
    }
  }
  if (!find_sub_path(file, path, settings, error)) return false;
  if (!ini && line_.find_ini && (file == nullptr || file->find_ini)) {
    if (const std::string above = ini_above(path); !above.empty()) {
      ini = shown_path(above, path);
      note("ini", *ini, "found above the program");
    }
  }
  if (ini && !read_machine_ini(*ini, &profile, error)) return false;

  for (const auto* codes : {&line_.select, &line_.extend_select, &line_.ignore}) {
    for (const std::string& code : *codes) {
      if (!check_code(code, error)) return false;
    }
  }
  const Selection given{line_.select.empty() ? std::nullopt : std::optional(line_.select), line_.ignore.empty() ? std::nullopt : std::optional(line_.ignore),
                        line_.extend_select.empty() ? std::nullopt : std::optional(line_.extend_select), {}};
  note_selection(given, [](const char*) { return "command line"; });
  if (line_.linuxcnc) note("linuxcnc", *line_.linuxcnc, "command line");
  if (line_.feature) note("feature", *line_.feature, "command line");
  if (!line_.select.empty()) options.select = line_.select;
  for (const std::string& code : line_.extend_select) options.extend_select.push_back(code);
  for (const std::string& code : line_.ignore) options.ignore.push_back(code);
  for (const std::string& text : line_.severity) {
    const size_t equals = text.find('=');
    Severity severity{};
    if (equals == std::string::npos || !severity_from_text(text.substr(equals + 1), &severity)) {
      *error = fmt::format("`--severity {}`: write CODE=LEVEL, with a level of off, info, warning, error", text);
      return false;
    }
    if (!check_code(text.substr(0, equals), error)) return false;
    options.severity[text.substr(0, equals)] = severity;
    // Giving an info rule a severity asks for it.
    if (severity != Severity::kOff) options.extend_select.push_back(text.substr(0, equals));
  }
  return true;
}

}  // namespace owlint::cli
