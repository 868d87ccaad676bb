#include "analyzer/cli/values.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/checking/configuration_file.h"
#include "analyzer/machine/setup.h"
#include "rules/driver/stops.h"

namespace owlint::cli {

using namespace checking;

namespace {

/// The word that was meant: a misspelt one, one that is cut short (`warn`), or one with too much behind it (`2.9.4`).
std::string near_word(const std::string& value, const std::vector<std::string>& words) {
  constexpr size_t kTelling = 3;
  std::string near = rules::nearest(value, words);
  for (const std::string& word : words) {
    const bool shortened = value.size() >= kTelling && word.starts_with(value);
    if (near.empty() && (shortened || value.starts_with(word + "."))) near = word;
  }
  return near;
}

void trim(std::string& value) {
  value.erase(0, value.find_first_not_of(" \t"));
  value.erase(value.find_last_not_of(" \t") + 1);
}

}  // namespace

// Of all validators only this one has a description: CLI11 puts it behind the name of the value, where words_of() finds it.
CLI::Validator one_of(std::vector<std::string> words) {
  const std::string description = fmt::format("{}", fmt::join(words, "|"));
  const auto check = [words = std::move(words)](std::string& value) {
    if (std::ranges::find(words, value) != words.end()) return std::string();
    const std::string small = small_letters(value);
    if (std::ranges::find(words, small) != words.end()) {
      value = small;
      return std::string();
    }
    const std::string near = near_word(small, words);
    return fmt::format("`{}` is none of {}{}", value, fmt::join(words, ", "),
                       near.empty() ? "" : "; did you mean `" + near + "`?");
  };
  return CLI::Validator(check, description);
}

CLI::Validator rule_code() {
  const auto check = [](std::string& value) {
    trim(value);  // `OW104, OW105`
    std::string code = value;
    std::string error;
    take_code(&code, &error);
    return error;
  };
  return CLI::Validator(check, "");
}

CLI::Validator code_level() {
  const auto check = [](std::string& value) {
    trim(value);
    const size_t equals = value.find('=');
    Severity severity{};
    std::string code = value.substr(0, equals);
    std::string error;
    if (equals == std::string::npos || !severity_from_text(value.substr(equals + 1), &severity)) {
      const std::string near = equals == std::string::npos
          ? std::string()
          : near_word(small_letters(value.substr(equals + 1)), {"off", "info", "warning", "error"});
      error = fmt::format("`{}` is not CODE=LEVEL with a level of off, info, warning or error{}", value,
                          near.empty() ? "" : "; did you mean `" + value.substr(0, equals + 1) + near + "`?");
    } else {
      take_code(&code, &error);
    }
    return error;
  };
  return CLI::Validator(check, "");
}

CLI::Validator count() {
  const auto check = [](std::string& value) {
    unsigned number = 0;
    const auto [end, problem] = std::from_chars(value.data(), value.data() + value.size(), number);
    return problem == std::errc() && end == value.data() + value.size() && number > 0
        ? std::string()
        : fmt::format("`{}` is not a number such as 4", value);
  };
  return CLI::Validator(check, "");
}

CLI::Validator mask() {
  const auto check = [](std::string& value) {
    return parse_mask(value) ? std::string() : fmt::format("`{}` is not a number such as 32 or 0x20", value);
  };
  return CLI::Validator(check, "");
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0 && option.get_type_size() != 0;
}

std::string value_name(const CLI::Option& option) {
  const std::string type = option.get_type_name();  // behind it the validators
  return type.substr(0, type.find(':'));
}

std::vector<std::string> words_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const size_t colon = type.find(':');
  return colon == std::string::npos || colon + 1 == type.size() ? std::vector<std::string>()
                                                                : CLI::detail::split(type.substr(colon + 1), '|');
}

std::vector<std::string> spellings(const CLI::Option& option) {
  std::vector<std::string> out;
  for (const std::string& name : option.get_snames()) out.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.push_back("--" + name);
  return out;
}

std::string description_of(const CLI::Option& option) {
  std::string text = option.get_description();
  if (const auto words = words_of(option); !words.empty()) text += fmt::format(": {}", fmt::join(words, ", "));
  if (const std::string given = option.get_default_str(); !given.empty()) text += fmt::format(" (default: {})", given);
  return text;
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  std::vector<const CLI::Option*> out;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_group().empty() && !option->get_positional()) out.push_back(option);
  }
  return out;
}

std::vector<const CLI::Option*> positionals_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

Commands commands_of(const CLI::App& app, const std::string& path) {
  Commands out;
  for (const CLI::App* one :
       app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); })) {
    out.push_back({path + (path.empty() ? "" : " ") + one->get_name(), one});
  }
  return out;
}

Commands all_commands(const CLI::App& app) {
  Commands out;
  for (const Command& command : commands_of(app)) {
    out.push_back(command);
    for (const Command& own : commands_of(*command.app, command.path)) out.push_back(own);
  }
  return out;
}

}  // namespace owlint::cli
