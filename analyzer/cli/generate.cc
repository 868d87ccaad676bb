#include "analyzer/cli/generate.h"

#include <filesystem>
#include <fstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/report/report.h"

namespace owlint::cli {
namespace {

/// A command, or one of a command's own: `audit`, `audit list`.
struct Command {
  std::string path;
  const CLI::App* app;
};
using Commands = std::vector<Command>;

/// The commands of a command that people see.
Commands commands_of(const CLI::App& app, const std::string& path = {}) {
  Commands out;
  for (const CLI::App* one : app.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); })) out.push_back({path + (path.empty() ? "" : " ") + one->get_name(), one});
  return out;
}

/// All of them, a command's own behind it.
Commands all_commands(const CLI::App& app) {
  Commands out;
  for (const Command& command : commands_of(app)) {
    out.push_back(command);
    for (const Command& own : commands_of(*command.app, command.path)) out.push_back(own);
  }
  return out;
}

/// As a part of a manual page's name.
std::string dashed(std::string path) { return CLI::detail::find_and_replace(std::move(path), " ", "-"); }

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
  const std::string command = CLI::detail::find_and_replace(name, "-", " ");
  if (commands.empty() || !positional.empty()) out += fmt::format(".B {}\n[\\fIoptions\\fR]{}\n", command, positional);
  if (!commands.empty()) out += fmt::format("{}.B {}\n\\fIcommand\\fR [\\fIoptions\\fR]\n", positional.empty() ? "" : ".br\n", command);
  if (name == "owlint") out += ".SH DESCRIPTION\nFinds the mistakes in the O\\-words of LinuxCNC programs at which the machine stops, before it moves.\n";
  if (!commands.empty()) out += ".SH COMMANDS\n";
  for (const Command& one : commands) out += fmt::format(".TP\n\\fB{}\\fR\n{}; see \\fBowlint\\-{}\\fR(1)\n", roff(one.app->get_name()), roff(one.app->get_description()), roff(dashed(one.path)));
  return out + man_options(app) + kStatus;
}

std::string bash(const CLI::App& app, const Commands& commands) {
  std::string out = "# bash completion for owlint; made by `owlint generate`\n_owlint() {\n  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} words=\n";
  out += "  case \"$command ${COMP_WORDS[2]}\" in\n";
  for (const Command& one : commands) {
    if (one.path.find(' ') != std::string::npos) out += fmt::format("    '{0}') command='{0}' ;;\n", one.path);
  }
  out += "  esac\n";
  std::map<std::string, std::string> values;  // by command and option
  for (const Command& one : commands) {
    for (const CLI::Option* option : options_of(*one.app)) {
      if (values_of(*option).empty()) continue;
      values[fmt::format("'{}:{}'", one.path, spellings(*option).back())] = fmt::format("{}", fmt::join(values_of(*option), " "));
    }
  }
  out += "  case \"$command:$previous\" in\n";
  for (const auto& [key, words] : values) out += fmt::format("    {}) words='{}' ;;\n", key, words);
  out += "  esac\n  if [[ -n $words ]]; then\n    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n    return\n  fi\n";
  std::vector<std::string> names;
  std::map<std::string, std::vector<std::string>> own;  // by command
  for (const Command& one : commands) {
    const size_t blank = one.path.find(' ');
    blank == std::string::npos ? names.push_back(one.path) : own[one.path.substr(0, blank)].push_back(one.path.substr(blank + 1));
  }
  out += fmt::format("  if [[ $COMP_CWORD -eq 1 && $current != -* ]]; then\n    mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$current\"; compgen -f -- \"$current\")\n    return\n  fi\n", fmt::join(names, " "));
  for (const auto& [command, its] : own) {
    out += fmt::format("  if [[ $COMP_CWORD -eq 2 && $command == {} && $current != -* ]]; then\n    mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$current\"; compgen -f -- \"$current\")\n    return\n  fi\n", command, fmt::join(its, " "));
  }
  out += "  case $command in\n";
  const auto flags = [](const CLI::App& one) {
    std::vector<std::string> all;
    for (const CLI::Option* option : options_of(one)) {
      for (const std::string& name : spellings(*option)) all.push_back(name);
    }
    return fmt::format("{}", fmt::join(all, " "));
  };
  for (const Command& one : commands) out += fmt::format("    '{}') words='{}' ;;\n", one.path, flags(*one.app));
  out += fmt::format("    *) words='{}' ;;\n  esac\n  if [[ $current == -* ]]; then\n    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n  else\n    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n  fi\n}}\ncomplete -o filenames -F _owlint owlint\n", flags(app));
  return out;
}

std::string quoted(const std::string& text) { return "'" + CLI::detail::find_and_replace(text, "'", "'\\''") + "'"; }

std::string zsh(const Commands& commands) {
  std::string out = "#compdef owlint\n# made by `owlint generate`\n_owlint() {\n  local -a commands\n  commands=(\n";
  const auto own_of = [](const Command& one) { return one.path.find(' ') != std::string::npos; };
  for (const Command& one : commands) {
    if (!own_of(one)) out += fmt::format("    {}\n", quoted(one.path + ":" + one.app->get_description()));
  }
  out += "  )\n  if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then\n    _describe command commands\n    _files\n    return\n  fi\n  local command=$words[2]\n  case \"$words[2] $words[3]\" in\n";
  for (const Command& one : commands) {
    if (own_of(one)) out += fmt::format("    '{}') command='{}'; shift words; (( CURRENT-- )) ;;\n", one.path, one.path);
  }
  out += "  esac\n  case $command in\n";
  const auto plain = [](std::string text) {
    for (const char* special : {"[", "]", ":"}) text = CLI::detail::find_and_replace(text, special, std::string("\\") + special);
    return text;
  };
  for (const Command& one : commands) {
    out += fmt::format("    '{}')\n      shift words; (( CURRENT-- ))\n      _arguments \\\n", one.path);
    for (const CLI::Option* option : options_of(*one.app)) {
      for (const std::string& name : spellings(*option)) {
        std::string value;
        if (takes_value(*option)) value = values_of(*option).empty() ? ":" + plain(value_name(*option)) + ":_files" : fmt::format(":value:({})", fmt::join(values_of(*option), " "));
        out += fmt::format("        {} \\\n", quoted(name + "[" + plain(option->get_description()) + "]" + value));
      }
    }
    std::string its;
    for (const Command& own : commands_of(*one.app, one.path)) its += " " + own.app->get_name();
    out += its.empty() ? "        '*:file:_files'\n      ;;\n" : fmt::format("        '1:command or folder:{{compadd --{}; _files}}' '*:file:_files'\n      ;;\n", its);
  }
  return out + "    *) _files ;;\n  esac\n}\n_owlint \"$@\"\n";
}

std::string fish(const Commands& commands) {
  std::string out = "# fish completion for owlint; made by `owlint generate`\n";
  for (const Command& one : commands) {
    const size_t blank = one.path.find(' ');
    const std::string when = blank == std::string::npos ? "__fish_use_subcommand" : "__fish_seen_subcommand_from " + one.path.substr(0, blank);
    out += fmt::format("complete -c owlint -n '{}' -a {} -d {}\n", when, one.app->get_name(), quoted(one.app->get_description()));
  }
  for (const Command& one : commands) {
    for (const CLI::Option* option : options_of(*one.app)) {
      std::string when;
      for (const std::string& word : CLI::detail::split(one.path, ' ')) when += (when.empty() ? "" : "; and ") + std::string("__fish_seen_subcommand_from ") + word;
      out += fmt::format("complete -c owlint -n '{}'", when);
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
  const Commands commands = all_commands(app);
  bool good = write("man1/owlint.1", man_page(app, "owlint", commands_of(app))) && write("bash/owlint", bash(app, commands)) && write("zsh/_owlint", zsh(commands)) &&
              write("fish/owlint.fish", fish(commands));
  for (const Command& one : commands) {
    const std::string name = "owlint-" + dashed(one.path);
    good = good && write(fmt::format("man1/{}.1", name), man_page(*one.app, name, commands_of(*one.app, one.path)));
  }
  return good;
}

}  // namespace owlint::cli
