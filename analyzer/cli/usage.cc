#include "analyzer/cli/usage.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "analyzer/cli/values.h"
#include "rules/driver/stops.h"

namespace owlint::cli {
namespace {

/// The command that was meant, with its own command: `owlint audit list`.
struct Meant {
  const CLI::App* app;
  std::string name;
};

Meant meant_command(const CLI::App& app) {
  Meant meant{&app, app.get_name()};
  while (true) {
    const auto parsed = meant.app->get_subcommands();
    if (parsed.empty()) return meant;
    meant.app = parsed.front();
    meant.name += " " + meant.app->get_name();
  }
}

void add_spellings(const CLI::App& command, std::vector<std::string>& names) {
  for (const CLI::Option* option : options_of(command)) {
    for (const std::string& spelling : spellings(*option)) names.push_back(spelling);
  }
}

std::string unknown_option(const CLI::App& app, const Meant& meant, const std::string& text) {
  std::vector<std::string> names;
  add_spellings(*meant.app, names);
  const size_t of_command = names.size();
  add_spellings(app, names);     // such as `--version`, which no command has
  constexpr size_t kLetter = 2;  // of `-x` each other letter would be as near
  const std::string near =
      text.size() <= kLetter ? std::string() : rules::nearest(text.substr(0, text.find('=')), names);
  if (near.empty())
    return fmt::format("unknown option `{}`; `--help` lists all, and what comes after `--` is a path", text);
  const bool without_command =
      std::ranges::find(names, near) - names.begin() >= static_cast<std::ptrdiff_t>(of_command);
  return fmt::format("unknown option `{}`, did you mean `{}{}`?", text, without_command ? "owlint " : "", near);
}

/// An option that got too many values or too few.
std::string wrong_count(const CLI::Option& option, const std::string& name) {
  if (!takes_value(option)) return fmt::format("{} takes no value", name);
  if (option.results().size() > 1) return fmt::format("{} is given more than once", name);
  return fmt::format("{} needs a value: {}", name, value_name(option));
}

/// Whether one of CLI11's messages is about an option; it leaves the dashes of flags out.
bool is_about(std::string_view message, std::string_view option) {
  message.remove_prefix(std::min(message.find_first_not_of('-'), message.size()));
  option.remove_prefix(option.find_first_not_of('-'));
  return message.starts_with(option) && message.substr(option.size()).find_first_of(": ") == 0;
}

}  // namespace

std::string usage_problem(const CLI::App& app, const CLI::ParseError& problem) {
  const Meant meant = meant_command(app);
  // Said first: PATH may be missing only because an unknown option took its place.
  const std::vector<std::string> left = app.remaining(true);
  for (const std::string& text : left) {
    if (text.starts_with('-')) return unknown_option(app, meant, text);
  }
  const std::string text = problem.what();
  for (const CLI::Option* option : meant.app->get_options()) {
    if (dynamic_cast<const CLI::RequiredError*>(&problem) != nullptr && option->get_required() &&
        option->count() == 0) {
      return fmt::format("`{}` needs {}: {}", meant.name,
                         option->get_positional() ? option->get_name(true) : option->get_name(),
                         description_of(*option));
    }
    for (const std::string& name : spellings(*option)) {
      if (dynamic_cast<const CLI::ArgumentMismatch*>(&problem) != nullptr && is_about(text, name))
        return wrong_count(*option, name);
    }
  }
  if (!left.empty())
    return fmt::format("`{}` does not take `{}`; see `{} --help`", meant.name, left.front(), meant.name);
  return text;
}

std::string misspelt_command(const CLI::App& app, const std::string& argument) {
  std::error_code problem;
  if (argument.starts_with('-') || std::filesystem::exists(argument, problem)) return {};
  std::vector<std::string> known;
  for (const Command& command : commands_of(app)) known.push_back(command.path);
  std::string near = rules::nearest(argument, known);
  // A short form, or one that ends as in another language.
  constexpr size_t kTelling = 3;
  const bool word = argument.size() >= kTelling && argument.find_first_of("./") == std::string::npos;
  for (const std::string& name : known) {
    if (near.empty() && word && name.starts_with(argument.substr(0, kTelling))) near = name;
  }
  if (argument == "fix") return "there is no command and no file `fix`; `owlint --fix PATH` makes the safe fixes";
  // What other programs call them.
  if (argument == "lint") near = "check";
  if (argument == "format") near = "fmt";
  return near.empty() ? near
                      : fmt::format("there is no command and no file `{}`, did you mean `owlint {}`?", argument, near);
}

}  // namespace owlint::cli
