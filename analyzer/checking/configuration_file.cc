#include "analyzer/checking/configuration_file.h"

#include <algorithm>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "analyzer/machine/profile.h"
#include "analyzer/text/paths.h"
#include "rules/driver/stops.h"

namespace owlint::checking {
namespace {

const std::vector<std::string> kKeys = {"ini",     "find-ini", "sub-path",      "feature",  "linuxcnc",
                                        "select",  "ignore",   "extend-select", "severity", "fail-on",
                                        "exclude", "include",  "overrides"};
const std::vector<std::string> kOverrideKeys = {"files", "select", "ignore", "extend-select", "severity"};

using Texts = std::optional<std::vector<std::string>>;

/// Reads a table, and remembers the first mistake in it.
class Reader {
 public:
  void read(const toml::table& table, ConfigurationFile* file) {
    check_keys(table, kKeys);
    read_text(table, "ini", "mill.ini", &file->ini);
    read_text(table, "linuxcnc", "2.9", &file->linuxcnc);
    if (file->linuxcnc && *file->linuxcnc != "all" && !version_from_text(*file->linuxcnc)) {
      wrong(*table.get("linuxcnc"),
            fmt::format("`linuxcnc` must be one of 2.7, 2.8, 2.9, 2.10, all, not `{}`", *file->linuxcnc));
    }
    read_list(table, "sub-path", "folders", &file->sub_path);
    read_list(table, "exclude", "patterns", &file->exclude);
    read_list(table, "include", "patterns", &file->include);
    read_selection(table, &file->base);
    read_feature(table, file);
    if (const toml::node* node = table.get("find-ini")) {
      if (!node->is_boolean()) wrong(*node, "`find-ini` must be true or false");
      file->find_ini = node->value_or(true);
    }
    if (const toml::node* node = table.get("fail-on")) {
      Severity severity{};
      if (!severity_from_text(node->value_or(std::string()), &severity) || severity == Severity::kOff)
        wrong(*node, "`fail-on` is one of info, warning, error");
      file->fail_on = severity;
    }
    read_overrides(table, file);
  }

  /// Empty where nothing is wrong.
  const std::string& problem() const { return problem_; }

 private:
  void wrong(const toml::node& at, const std::string& message) {
    const uint32_t line = at.source().begin.line;
    if (!problem_.empty() && line >= line_) return;
    line_ = line;
    problem_ = fmt::format("line {}: {}", line, message);
  }

  void check_keys(const toml::table& table, const std::vector<std::string>& known) {
    for (const auto& [key, value] : table) {
      const std::string name(key.str());
      if (std::ranges::find(known, name) != known.end()) continue;
      const std::string near = rules::nearest(name, known);
      wrong(value, fmt::format("unknown key `{}`{}", name, near.empty() ? "" : ", did you mean `" + near + "`?"));
    }
  }

  void read_text(const toml::table& table, std::string_view key, std::string_view example,
                 std::optional<std::string>* text) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    *text = node->value_exact<std::string>();
    if (!*text) wrong(*node, fmt::format("`{}` must be text in quotes, such as \"{}\"", key, example));
  }

  /// `what` says for people what the texts of the list are.
  void read_list(const toml::table& table, std::string_view key, std::string_view what, Texts* list) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return;
    list->emplace();
    const toml::array* array = node->as_array();
    for (size_t i = 0; array != nullptr && i < array->size(); ++i) {
      if (auto text = array->get(i)->value_exact<std::string>(); text && !text->empty())
        (*list)->push_back(std::move(*text));
    }
    if (array == nullptr || (*list)->size() != array->size())
      wrong(*node, fmt::format("`{}` must be a list of {}", key, what));
  }

  void read_codes(const toml::table& table, std::string_view key, Texts* codes) {
    read_list(table, key, "codes", codes);
    if (!*codes || table.get(key)->as_array() == nullptr) return;
    std::string error;
    for (size_t i = 0; i < (*codes)->size(); ++i) {
      if (!take_code(&(**codes)[i], &error)) wrong(*table.get(key)->as_array()->get(i), error);
    }
  }

  void read_selection(const toml::table& table, Selection* selection) {
    read_codes(table, "select", &selection->select);
    read_codes(table, "ignore", &selection->ignore);
    read_codes(table, "extend-select", &selection->extend_select);
    const toml::node* node = table.get("severity");
    if (node == nullptr) return;
    const toml::table* levels = node->as_table();
    if (levels == nullptr) return wrong(*node, "`severity` is a table of codes and levels");
    for (const auto& [key, value] : *levels) {
      std::string code(key.str());
      std::string error;
      Severity severity{};
      if (!take_code(&code, &error)) wrong(value, error);
      if (!severity_from_text(value.value_or(std::string()), &severity))
        wrong(value, fmt::format("the severity of `{}` must be one of off, info, warning, error", code));
      selection->severity[code] = severity;
    }
  }

  void read_feature(const toml::table& table, ConfigurationFile* file) {
    const toml::node* node = table.get("feature");
    if (node == nullptr) return;
    const auto number = node->value_exact<int64_t>();
    file->feature = number && *number >= 0 ? std::optional(static_cast<uint32_t>(*number))
                                           : parse_mask(node->value_or(std::string()));
    if (!file->feature) wrong(*node, "`feature` is a number, as 32 or 0x20");
  }

  void read_overrides(const toml::table& table, ConfigurationFile* file) {
    const toml::node* node = table.get("overrides");
    if (node == nullptr) return;
    const toml::array* list = node->as_array();
    if (list == nullptr || !list->is_array_of_tables())
      return wrong(*node, "`overrides` must be a list of tables, written `[[overrides]]`");
    for (size_t i = 0; i < list->size(); ++i) {
      const toml::table& entry = *list->get(i)->as_table();
      check_keys(entry, kOverrideKeys);
      Texts files;
      read_list(entry, "files", "patterns", &files);
      if ((!files || files->empty()) && problem_.empty()) wrong(entry, "an override needs `files`, a list of patterns");
      ConfigurationFile::Override& override = file->overrides.emplace_back(
          ConfigurationFile::Override{files.value_or(std::vector<std::string>()), {}, entry.source().begin.line});
      read_selection(entry, &override.selection);
    }
  }

  std::string problem_;
  uint32_t line_ = 0;
};

IgnorePatterns patterns_of(const Texts& list) {
  IgnorePatterns patterns;
  for (const std::string& pattern : list.value_or(std::vector<std::string>())) patterns.add(pattern);
  return patterns;
}

}  // namespace

std::string ConfigurationFile::place_of(std::string_view key) const {
  return fmt::format("{}:{}", path, lines.find(key)->second);
}

std::shared_ptr<const ConfigurationFile> read_configuration_file(const Files& files, const std::string& path,
                                                                 std::string* error) {
  const auto source = files.read(path, error);
  if (source == nullptr) {
    *error = fmt::format("cannot read {}: {}", path, *error);
    return nullptr;
  }
  toml::table table;
  try {
    table = toml::parse(source->bytes());
  } catch (const toml::parse_error& problem) {
    *error = fmt::format("{}: line {}: not TOML: {}", path, problem.source().begin.line, problem.description());
    return nullptr;
  }
  auto file = std::make_shared<ConfigurationFile>();
  file->path = files.seen_from_here(path);
  file->folder = std::string(folder_of(file_key(path)));
  for (const auto& [key, value] : table) file->lines.emplace(key.str(), value.source().begin.line);
  Reader reader;
  reader.read(table, file.get());
  if (!reader.problem().empty()) {
    *error = path + ": " + reader.problem();
    return nullptr;
  }
  if (file->exclude || file->include)
    file->patterns = std::make_shared<FilePatterns>(
        FilePatterns{file->folder, patterns_of(file->exclude), patterns_of(file->include)});
  return file;
}

bool take_code(std::string* code, std::string* error) {
  std::string meant = code_meant(*code);
  if (meant.empty()) {
    *error = unknown_rule(*code);
    return false;
  }
  *code = std::move(meant);
  return true;
}

}  // namespace owlint::checking
