#include "analyzer/checking/settings.h"

#include <fnmatch.h>

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/machine/ini_hidden.h"
#include "analyzer/machine/remap_line.h"
#include "analyzer/text/paths.h"

namespace owlint::checking {
namespace {

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

/// The codes that INIs remap, in capitals; null if they remap none.
std::shared_ptr<const std::set<std::string>> remapped_in(const Files& files, const std::vector<std::string>& inis) {
  auto codes = std::make_shared<std::set<std::string>>();
  for (const std::string& path : inis) {
    Ini ini;
    std::string error;  // then it remaps nothing
    if (!ini.read(files, path, &error)) continue;
    for (const Ini::Entry* remap : ini.all("RS274NGC", "REMAP")) {
      std::string code(read_remap(remap->value, 0).code);
      std::ranges::transform(code, code.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
      codes->insert(std::move(code));
    }
  }
  return codes->empty() ? nullptr : codes;
}

}  // namespace

std::shared_ptr<const ConfigurationFile> Configuration::load(const std::string& path, std::string* error) {
  if (const auto known = loaded_.find(path); known != loaded_.end()) return known->second;
  auto file = read_configuration_file(files_, path, error);
  if (file != nullptr) loaded_.emplace(path, file);
  return file;
}

std::string Configuration::nearest(const std::string& program) {
  const std::string key(folder_of(file_key(program)));
  if (const auto known = nearest_.find(key); known != nearest_.end()) return known->second;
  std::string found;
  for (std::string folder = key; found.empty(); folder = folder_of(folder)) {
    for (const char* name : {"owlint.toml", ".owlint.toml"}) {
      std::string path = joined_path(folder, name);
      if (found.empty() && files_.is_file(path)) found = std::move(path);
    }
    if (folder == "/") break;
  }
  return nearest_[key] = found;
}

std::shared_ptr<const ConfigurationFile> Configuration::file_for(const std::string& program, std::string* error) {
  error->clear();
  if (request_.config) return load(*request_.config, error);
  const std::string path = request_.isolated ? std::string() : nearest(program);
  return path.empty() ? nullptr : load(path, error);
}

Severity Configuration::fail_on(const std::string& path) {
  Severity severity = Severity::kError;
  if (request_.fail_on) {
    severity_from_text(*request_.fail_on, &severity);
    return severity;
  }
  std::string error;  // reported with the program
  const auto file = file_for(path, &error);
  return file == nullptr ? severity : file->fail_on.value_or(severity);
}

std::shared_ptr<const FilePatterns> Configuration::patterns_in(const std::string& folder) {
  std::string error;  // reported with the programs in the folder
  const auto file = file_for(folder + "/program.ngc", &error);
  return file == nullptr ? nullptr : file->patterns;
}

bool Configuration::read_machine_ini(const std::string& path, Profile* profile, std::string* error) {
  const std::pair key(path, profile->sub_path);
  auto known = inis_.find(key);
  if (known == inis_.end()) {
    auto setup = read_setup(files_, path, error, profile->sub_path);
    if (setup == nullptr) {
      *error = fmt::format("cannot read the INI {}: {}", path, *error);
      return false;
    }
    // A byte order mark hides the section behind it, other forms of text hide all of them: a finding says so.
    const std::string_view bytes = setup->ini.source()->bytes();
    if (!setup->ini.has_sections() && !bytes.starts_with("\xEF\xBB\xBF[") && how_hidden(bytes) == IniHidden::kNone) {
      *error = fmt::format("{} is not a machine INI: it has no [SECTION]", path);
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

/// The INIs of machines in a folder, sorted.
std::vector<std::string> Configuration::machine_inis(const std::string& folder) const {
  std::vector<std::string> out;
  if (without_ini_ != nullptr && without_ini_->contains(folder)) return out;
  std::string unread;  // then there are none
  for (const FolderEntry& entry : files_.list(folder, &unread)) {
    std::string path = joined_path(folder, entry.name);
    if (ending_of(entry.name) == ".ini" && is_machine_ini(files_, path)) out.push_back(std::move(path));
  }
  std::ranges::sort(out);
  return out;
}

/// The one machine INI in the nearest folder above a program that has any.
std::string Configuration::ini_above(const std::string& program) {
  const auto near = [this](const std::string& path) {  // seen from the working folder where it is below it
    const std::string seen = files_.seen_from_here(path);
    return seen.starts_with("..") || seen == "." ? path : seen;
  };
  std::vector<std::string> passed;
  std::string found;
  std::shared_ptr<const std::set<std::string>> codes;
  for (std::string folder(folder_of(file_key(program)));; folder = folder_of(folder)) {
    if (const auto known = inis_above_.find(folder); known != inis_above_.end()) {
      found = known->second;
      if (const auto several = codes_above_.find(folder); several != codes_above_.end()) codes = several->second;
      break;
    }
    passed.push_back(folder);
    const std::vector<std::string> candidates = machine_inis(folder);
    if (candidates.size() == 1) {
      found = candidates[0];
      used_inis_.push_back(near(found));
    } else if (candidates.size() > 1) {
      if (undecided_.empty()) first_undecided_ = candidates.size();
      undecided_.push_back(near(folder));
      codes = remapped_in(files_, candidates);
    }
    if (!candidates.empty() || folder == "/") break;
  }
  for (const std::string& folder : passed) {
    inis_above_[folder] = found;
    if (codes != nullptr) codes_above_[folder] = codes;
  }
  return found;
}

std::shared_ptr<const std::set<std::string>> Configuration::codes_of_several(const std::string& program) const {
  const auto found = codes_above_.find(std::string(folder_of(file_key(program))));
  return found == codes_above_.end() ? nullptr : found->second;
}

std::vector<std::string> Configuration::notes() const {
  const auto some = [](const std::vector<std::string>& names) {
    const size_t most = 3;
    const std::string text = fmt::format(
        "{}",
        fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), most)), ", "));
    return names.size() > most ? fmt::format("{} and {} more", text, names.size() - most) : text;
  };
  std::vector<std::string> notes = notes_;
  if (used_inis_.size() == 1) {
    notes.push_back(fmt::format("using the machine INI {} (--no-find-ini turns this off)", used_inis_[0]));
  } else if (used_inis_.size() > 1) {
    notes.push_back(fmt::format(
        "using {} machine INIs, each for the programs in and below its folder: {} (--no-find-ini turns this off)",
        used_inis_.size(), some(used_inis_)));
  }
  if (undecided_.size() == 1) {
    notes.push_back(
        fmt::format("{} machine INIs in {}, none is used: choose one with --ini", first_undecided_, undecided_[0]));
  } else if (undecided_.size() > 1) {
    notes.push_back(
        fmt::format("{} folders have several machine INIs each, so none of them is used: {}; choose one with --ini, or "
                    "with `ini` in an owlint.toml there",
                    undecided_.size(), some(undecided_)));
  }
  return notes;
}

std::string Configuration::shown_path(const std::string& path, const std::string& program) const {
  return request_.absolute || program.starts_with('/') ? file_key(path) : files_.seen_from_here(path);
}

bool Configuration::find_sub_path(const ConfigurationFile* file, const std::string& program, Settings* settings,
                                  std::string* error) const {
  std::vector<std::string>& folders = settings->profile.sub_path;
  const auto add = [&](const std::string& path, const std::string& from) {
    if (!files_.is_folder(path)) {
      *error = fmt::format("{}: there is no folder {}", from, path);
      return false;
    }
    folders.push_back(path);
    if (tells_origins_) settings->origins.push_back({"sub-path", path, from});
    return true;
  };
  for (const std::string& folder : request_.sub_path) {
    if (!add(request_.absolute ? file_key(folder) : folder, "--sub-path")) return false;
  }
  for (const std::string& folder : file != nullptr && file->sub_path ? *file->sub_path : std::vector<std::string>()) {
    const std::string path = joined_path(file->folder, expand_home(folder));
    if (!add(shown_path(path, program), file->place_of("sub-path"))) return false;
  }
  return true;
}

bool Configuration::is_taken_ini(const std::string& path) const {
  return request_.walk.takes_inis && small_letters(ending_of(path)) == ".ini";
}

std::shared_ptr<const Settings> Configuration::shared_settings(const std::string& path, std::string* error) {
  const std::string folder = path.substr(0, path.rfind('/') + 1);
  if (last_shared_ != nullptr && folder == last_folder_ && !is_taken_ini(path)) return last_shared_;
  auto settings = std::make_shared<Settings>();
  if (!settings_for(path, settings.get(), error)) return nullptr;
  if (settings->of_ini) return settings;
  const auto file = file_for(path, error);
  last_folder_ = folder;
  last_shared_ = file == nullptr || file->overrides.empty() ? settings : nullptr;
  return settings;
}

bool Configuration::settings_for(const std::string& path, Settings* settings, std::string* error) {
  const auto file = file_for(path, error);
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
    for (const auto& [code, level] : selection.severity)
      note("severity." + code, std::string(severity_text(level)), where("severity"));
  };
  const auto line_of = [&](std::string_view key) { return file->place_of(key); };
  std::optional<std::string> ini = request_.ini;
  if (ini && request_.absolute) ini = file_key(*ini);
  settings->of_ini = is_taken_ini(path);
  if (settings->of_ini) {
    ini = path;
  } else if (ini) {
    note("ini", *ini, "command line");
  }
  std::optional<std::string> version = request_.linuxcnc;
  Profile& profile = settings->profile;
  LintOptions& options = settings->options;
  if (file != nullptr) {
    if (!ini && file->ini) {
      ini = shown_path(joined_path(file->folder, *file->ini), path);
      note("ini", *ini, line_of("ini"));
    }
    if (!version && file->linuxcnc) {
      version = file->linuxcnc;
      note("linuxcnc", *version, line_of("linuxcnc"));
    }
    if (file->feature) note("feature", fmt::format("{:#x}", *file->feature), line_of("feature"));
    if (!file->find_ini) note("find-ini", "false", line_of("find-ini"));
    note_selection(file->base, line_of);
    if (file->fail_on) note("fail-on", std::string(severity_text(*file->fail_on)), line_of("fail-on"));
    if (file->exclude) note("exclude", fmt::format("{}", fmt::join(*file->exclude, " ")), line_of("exclude"));
    if (file->include) note("include", fmt::format("{}", fmt::join(*file->include, " ")), line_of("include"));
    profile.feature = file->feature;
    apply(file->base, &options);
    const std::string relative = relative_path(file_key(path), file->folder);
    for (const ConfigurationFile::Override& entry : file->overrides) {
      if (std::ranges::any_of(entry.files,
                              [&](const std::string& p) { return ::fnmatch(p.c_str(), relative.c_str(), 0) == 0; })) {
        apply(entry.selection, &options);
        note_selection(entry.selection,
                       [&](const char*) { return fmt::format("{}:{} [[overrides]]", file->path, entry.line); });
      }
    }
  }
  if (request_.coarse) options.detail = Detail::kCoarse;
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
  if (request_.feature) {
    profile.feature = parse_mask(*request_.feature);
    if (!profile.feature) {
      *error = fmt::format("--feature: `{}` is not a number such as 32 or 0x20", *request_.feature);
      return false;
    }
  }
  if (!find_sub_path(file.get(), path, settings, error)) return false;
  if (!ini && request_.find_ini && (file == nullptr || file->find_ini)) {
    if (const std::string above = ini_above(path); !above.empty()) {
      ini = shown_path(above, path);
      note("ini", *ini, "found above the program");
    } else {
      profile.remapped_perhaps = codes_of_several(path);
    }
  }
  if (ini && !read_machine_ini(*ini, &profile, error)) return false;

  Selection given;
  const auto take = [&](std::vector<std::string> codes, std::optional<std::vector<std::string>>* into) {
    if (codes.empty()) return true;
    for (std::string& code : codes) {
      if (!take_code(&code, error)) return false;
    }
    *into = std::move(codes);
    return true;
  };
  if (!take(request_.select, &given.select) || !take(request_.extend_select, &given.extend_select) ||
      !take(request_.ignore, &given.ignore))
    return false;
  note_selection(given, [](const char*) { return "command line"; });
  if (request_.linuxcnc) note("linuxcnc", *request_.linuxcnc, "command line");
  if (request_.feature) note("feature", *request_.feature, "command line");
  if (request_.fail_on) note("fail-on", *request_.fail_on, "command line");
  apply(given, &options);
  for (const std::string& text : request_.severity) {
    const size_t equals = text.find('=');
    Severity severity{};
    if (equals == std::string::npos || !severity_from_text(text.substr(equals + 1), &severity)) {
      *error = fmt::format("--severity: `{}` is not CODE=LEVEL with a level of off, info, warning or error", text);
      return false;
    }
    std::string code = text.substr(0, equals);
    if (!take_code(&code, error)) return false;
    options.severity[code] = severity;
    // Giving an info rule a severity asks for it.
    if (severity != Severity::kOff) options.extend_select.push_back(code);
  }
  return true;
}

}  // namespace owlint::checking
