#include "analyzer/cli/generate.h"

#include <filesystem>
#include <fstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/report/report.h"

namespace owlint::cli {
namespace {

using Commands = std::vector<const CLI::App*>;

/// Options that people see, positional ones left out.
std::vector<const CLI::Option*> options_of(const CLI::App& app) {
  std::vector<const CLI::Option*> out;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_group().empty() && !option->get_positional()) out.push_back(option);
  }
  return out;
}

std::vector<std::string> spellings(const CLI::Option& option) {
  std::vector<std::string> out;
  for (const std::string& name : option.get_snames()) out.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.push_back("--" + name);
  return out;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0 && option.get_type_size() != 0; }

/// The values of an option whose type is a list of them.
std::vector<std::string> values_of(const CLI::Option& option) {
  const std::string type = option.get_type_name().substr(0, option.get_type_name().find(':'));
  return type.find('|') == std::string::npos ? std::vector<std::string>{} : CLI::detail::split(type, '|');
}

std::string value_name(const CLI::Option& option) { return option.get_type_name().substr(0, option.get_type_name().find(':')); }

/// For roff: no line begins with a dot, hyphens are hyphens.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) {
      out += "\\&";
      out += c;
    } else {
      out += c;
    }
  }
  return out;
}

std::string man_options(const CLI::App& app) {
  std::string out = ".SH OPTIONS\n";
  for (const CLI::Option* option : options_of(app)) {
    std::vector<std::string> names;
    for (const std::string& name : spellings(*option)) names.push_back("\\fB" + roff(name) + "\\fR");
    out += fmt::format(".TP\n{}{}\n{}\n", fmt::join(names, ", "), takes_value(*option) ? " \\fI" + roff(value_name(*option)) + "\\fR" : "", roff(option->get_description()));
  }
  return out;
}

constexpr const char* kStatus = R"(.SH EXIT STATUS
.TP
0
nothing at or above \fB\-\-fail\-on\fR
.TP
1
findings
.TP
2
wrong usage or configuration, or a file that cannot be read
.TP
3
a fault of owlint itself
)";

std::string man_page(const CLI::App& app, const std::string& name, const Commands& commands) {
  std::string out = fmt::format(".TH {} 1 \"\" \"owlint {}\" \"owlint\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n", name, kToolVersion, roff(name), roff(app.get_description()));
  std::string positional;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) positional += fmt::format(" \\fI{}\\fR{}", option->get_name(true), option->get_items_expected_max() > 1 ? "..." : "");
  }
  std::string command = name;
  if (const size_t dash = command.find('-'); dash != std::string::npos) command[dash] = ' ';
  out += commands.empty() ? fmt::format(".B {}\n[\\fIoptions\\fR]{}\n", command, positional) : fmt::format(".B {}\n\\fIcommand\\fR [\\fIoptions\\fR]\n", command);
  if (!commands.empty()) {
    out += ".SH DESCRIPTION\nFinds the mistakes in the O\\-words of LinuxCNC programs at which the machine stops, before it moves.\n.SH COMMANDS\n";
    for (const CLI::App* one : commands) out += fmt::format(".TP\n\\fB{}\\fR\n{}; see \\fBowlint\\-{}\\fR(1)\n", roff(one->get_name()), roff(one->get_description()), roff(one->get_name()));
  }
  return out + man_options(app) + kStatus;
}

std::string bash(const CLI::App& app, const Commands& commands) {
  std::string out = "# bash completion for owlint; made by `owlint generate`\n_owlint() {\n  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} words=\n";
  std::map<std::string, std::string> values;  // by command and option
  for (const CLI::App* one : commands) {
    for (const CLI::Option* option : options_of(*one)) {
      if (values_of(*option).empty()) continue;
      values[fmt::format("{}:{}", one->get_name(), spellings(*option).back())] = fmt::format("{}", fmt::join(values_of(*option), " "));
    }
  }
  out += "  case $command:$previous in\n";
  for (const auto& [key, words] : values) out += fmt::format("    {}) words='{}' ;;\n", key, words);
  out += "  esac\n  if [[ -n $words ]]; then\n    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n    return\n  fi\n";
  std::vector<std::string> names;
  for (const CLI::App* one : commands) names.push_back(one->get_name());
  out += fmt::format("  if [[ $COMP_CWORD -eq 1 && $current != -* ]]; then\n    mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$current\"; compgen -f -- \"$current\")\n    return\n  fi\n  case $command in\n", fmt::join(names, " "));
  const auto flags = [](const CLI::App& one) {
    std::vector<std::string> all;
    for (const CLI::Option* option : options_of(one)) {
      for (const std::string& name : spellings(*option)) all.push_back(name);
    }
    return fmt::format("{}", fmt::join(all, " "));
  };
  for (const CLI::App* one : commands) out += fmt::format("    {}) words='{}' ;;\n", one->get_name(), flags(*one));
  out += fmt::format("    *) words='{}' ;;\n  esac\n  if [[ $current == -* ]]; then\n    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n  else\n    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n  fi\n}}\ncomplete -o filenames -F _owlint owlint\n", flags(app));
  return out;
}

std::string quoted(const std::string& text) { return "'" + CLI::detail::find_and_replace(text, "'", "'\\''") + "'"; }

std::string zsh(const Commands& commands) {
  std::string out = "#compdef owlint\n# made by `owlint generate`\n_owlint() {\n  local -a commands\n  commands=(\n";
  for (const CLI::App* one : commands) out += fmt::format("    {}\n", quoted(one->get_name() + ":" + one->get_description()));
  out += "  )\n  if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then\n    _describe command commands\n    _files\n    return\n  fi\n  case $words[2] in\n";
  const auto plain = [](std::string text) {
    for (const char* special : {"[", "]", ":"}) text = CLI::detail::find_and_replace(text, special, std::string("\\") + special);
    return text;
  };
  for (const CLI::App* one : commands) {
    out += fmt::format("    {})\n      shift words; (( CURRENT-- ))\n      _arguments \\\n", one->get_name());
    for (const CLI::Option* option : options_of(*one)) {
      for (const std::string& name : spellings(*option)) {
        std::string value;
        if (takes_value(*option)) value = values_of(*option).empty() ? ":" + plain(value_name(*option)) + ":_files" : fmt::format(":value:({})", fmt::join(values_of(*option), " "));
        out += fmt::format("        {} \\\n", quoted(name + "[" + plain(option->get_description()) + "]" + value));
      }
    }
    out += "        '*:file:_files'\n      ;;\n";
  }
  return out + "    *) _files ;;\n  esac\n}\n_owlint \"$@\"\n";
}

std::string fish(const Commands& commands) {
  std::string out = "# fish completion for owlint; made by `owlint generate`\n";
  for (const CLI::App* one : commands) out += fmt::format("complete -c owlint -n __fish_use_subcommand -a {} -d {}\n", one->get_name(), quoted(one->get_description()));
  for (const CLI::App* one : commands) {
    for (const CLI::Option* option : options_of(*one)) {
      out += fmt::format("complete -c owlint -n '__fish_seen_subcommand_from {}'", one->get_name());
      for (const std::string& name : option->get_snames()) out += " -s " + name;
      for (const std::string& name : option->get_lnames()) out += " -l " + name;
      if (takes_value(*option)) out += values_of(*option).empty() ? " -r" : fmt::format(" -x -a '{}'", fmt::join(values_of(*option), " "));
      out += " -d " + quoted(option->get_description()) + "\n";
    }
  }
  return out;
}

}  // namespace

bool generate(const CLI::App& app, const std::string& folder, std::string* error) {
  const auto write = [&](const std::string& name, const std::string& text) {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    std::error_code problem;
    std::filesystem::create_directories(path.parent_path(), problem);
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << text;
    file.close();
    if (!file) *error = "cannot write " + path.string();
    return static_cast<bool>(file);
  };
  const Commands commands = app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
  bool good = write("man1/owlint.1", man_page(app, "owlint", commands)) && write("bash/owlint", bash(app, commands)) && write("zsh/_owlint", zsh(commands)) &&
              write("fish/owlint.fish", fish(commands));
  for (const CLI::App* one : commands) good = good && write(fmt::format("man1/owlint-{}.1", one->get_name()), man_page(*one, "owlint-" + one->get_name(), {}));
  return good;
}

}  // namespace owlint::cli
