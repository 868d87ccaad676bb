#include "analyzer/cli/completion.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/cli/values.h"
#include "rules/driver/rule.h"

namespace owlint::cli {
namespace {

/// What comes behind an option, or stands in a place.
enum class Kind { kNothing, kWords, kCodes, kCodeLevels, kFiles, kFolders, kAny };

Kind kind_of(const CLI::Option& option) {
  const std::string name = value_name(option);
  if (!takes_value(option)) return Kind::kNothing;
  if (!words_of(option).empty()) return Kind::kWords;
  if (name == "CODES" || name == "CODE") return Kind::kCodes;
  if (name == "CODE=LEVEL") return Kind::kCodeLevels;
  if (name == "FILE") return Kind::kFiles;
  return name == "DIR" ? Kind::kFolders : Kind::kAny;
}

/// Whether a command takes codes of rules in place of paths.
bool takes_codes(const CLI::App& command) {
  const auto positionals = positionals_of(command);
  return !positionals.empty() && kind_of(*positionals.front()) == Kind::kCodes;
}

/// Codes, their beginnings, and names of rules, each with what it stands for.
std::vector<std::pair<std::string, std::string>> codes() {
  std::vector<std::pair<std::string, std::string>> out;
  std::string group;
  for (const Rule* rule : catalogue()) {
    if (rule->code.substr(0, 3) != group) out.emplace_back(group = rule->code.substr(0, 3), group_title(rule->group));
    out.emplace_back(rule->code, rule->name);
  }
  for (const Rule* rule : catalogue()) out.emplace_back(rule->name, rule->code);
  return out;
}

std::string code_words() {
  std::vector<std::string> words;
  for (const auto& [code, what] : codes()) words.push_back(code);
  return fmt::format("{}", fmt::join(words, " "));
}

constexpr const char* kLevels = "off info warning error";

std::string quoted(const std::string& text) { return "'" + CLI::detail::find_and_replace(text, "'", "'\\''") + "'"; }

std::string all_spellings(const CLI::App& command) {
  std::vector<std::string> all;
  for (const CLI::Option* option : options_of(command)) {
    for (const std::string& spelling : spellings(*option)) all.push_back(spelling);
  }
  return fmt::format("{}", fmt::join(all, " "));
}

// What is the same in every script: the words that are being written, whatever their options mean.
constexpr const char* kBashHead = R"bash(# bash completion for owlint; made by `owlint generate`
_owlint() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} words= kind=files before=
  # bash takes `--option=value` and CODE=LEVEL for three words
  if [[ $current == '=' ]]; then
    current=
  elif [[ $previous == '=' ]]; then
    previous=${COMP_WORDS[COMP_CWORD-2]}
  fi
)bash";
constexpr const char* kBashTail = R"bash(  case $kind in
    codes)
      words=$codes
      if [[ $current == *,* ]]; then
        before=${current%,*},
        current=${current##*,}
      fi
      [[ $current == ow* ]] && current=OW${current#ow} ;;
    folders)
      mapfile -t COMPREPLY < <(compgen -d -- "$current")
      return ;;
    any)
      COMPREPLY=()
      return ;;
    files)
      if [[ $current == -* ]]; then
        words=$options
      else
        mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current"; compgen -f -- "$current")
        return
      fi ;;
  esac
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$words" -- "$current")
}
complete -o filenames -F _owlint owlint
)bash";

}  // namespace

std::string bash_completion(const CLI::App& app) {
  const Commands commands = all_commands(app);
  std::string out = kBashHead;
  std::vector<std::string> names;
  for (const Command& command : commands_of(app)) names.push_back(command.path);
  out += fmt::format("  local options= commands= codes='{}'\n", code_words());
  out += fmt::format(
      "  [[ ' {} ' == *\" $command \"* ]] || command=check  # it may be left out\n  case \"$command "
      "${{COMP_WORDS[2]}}\" in\n",
      fmt::join(names, " "));
  for (const Command& one : commands) {
    if (one.path.find(' ') != std::string::npos) out += fmt::format("    '{0}') command='{0}' ;;\n", one.path);
  }
  out += "  esac\n  case $command in\n";
  for (const Command& one : commands) {
    std::vector<std::string> own;
    for (const Command& sub : commands_of(*one.app)) own.push_back(sub.path);
    const std::string offered =
        own.empty() ? "" : fmt::format(" ; [[ $COMP_CWORD -eq 2 ]] && commands='{}'", fmt::join(own, " "));
    out += fmt::format("    '{}') options='{}'{}{} ;;\n", one.path, all_spellings(*one.app),
                       takes_codes(*one.app) ? " ; [[ $current != -* ]] && kind=codes" : "", offered);
  }
  out += fmt::format("  esac\n  [[ $COMP_CWORD -eq 1 ]] && commands='{}' options+=' {}'\n", fmt::join(names, " "),
                     all_spellings(app));
  std::map<std::string, std::string> values;  // by command and option
  for (const Command& one : commands) {
    for (const CLI::Option* option : options_of(*one.app)) {
      const std::string key = fmt::format("'{}:{}'", one.path, spellings(*option).back());
      switch (kind_of(*option)) {
        case Kind::kWords: values[key] = fmt::format("kind=words words='{}'", fmt::join(words_of(*option), " ")); break;
        case Kind::kCodes: values[key] = "kind=codes"; break;
        // Behind a code and `=` the option is two words further away than behind its own.
        case Kind::kCodeLevels:
          values[key] = "kind=codes";
          values["*:OW*"] = fmt::format(
              "[[ ${{COMP_WORDS[COMP_CWORD]}} == = || ${{COMP_WORDS[COMP_CWORD-1]}} == = ]] && kind=words words='{}'",
              kLevels);
          break;
        case Kind::kFolders: values[key] = "kind=folders"; break;
        case Kind::kAny: values[key] = "kind=any"; break;
        case Kind::kFiles: values[key] = "kind=files commands="; break;
        case Kind::kNothing: break;
      }
    }
  }
  out += "  case \"$command:$previous\" in\n";
  for (const auto& [key, what] : values) out += fmt::format("    {}) {} ;;\n", key, what);
  return out + "  esac\n" + kBashTail;
}

std::string zsh_completion(const CLI::App& app) {
  const Commands commands = all_commands(app);
  const auto is_own = [](const Command& one) { return one.path.find(' ') != std::string::npos; };
  const auto plain = [](std::string text) {
    for (const char* special : {"[", "]", ":"})
      text = CLI::detail::find_and_replace(text, special, std::string("\\") + special);
    return text;
  };
  std::string out = "#compdef owlint\n# made by `owlint generate`\n_owlint_codes() {\n  local -a codes\n  codes=(\n";
  for (const auto& [code, what] : codes()) out += fmt::format("    {}\n", quoted(code + ":" + what));
  out += "  )\n  compset -P '*,'\n  _describe -t codes 'rule' codes -M 'm:{a-z}={A-Z}' \"$@\"\n}\n";
  out += fmt::format(
      "_owlint_levels() {{\n  if compset -P '*='; then\n    compadd {}\n  else\n    _owlint_codes -S =\n  fi\n}}\n",
      kLevels);
  out += "_owlint() {\n  local -a commands\n  commands=(\n";
  for (const Command& one : commands) {
    if (!is_own(one)) out += fmt::format("    {}\n", quoted(one.path + ":" + one.app->get_description()));
  }
  out +=
      "  )\n  if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then\n    _describe command commands\n    _files\n    "
      "return\n  fi\n  local command=$words[2]\n  if [[ -z ${(M)commands:#$command:*} ]]; then\n    words=($words[1] "
      "check ${words[2,-1]}); (( CURRENT++ )); command=check  # it may be left out\n  fi\n  case \"$words[2] "
      "$words[3]\" in\n";
  for (const Command& one : commands) {
    if (is_own(one))
      out += fmt::format("    '{}') command='{}'; shift words; (( CURRENT-- )) ;;\n", one.path, one.path);
  }
  out += "  esac\n  case $command in\n";
  for (const Command& one : commands) {
    out += fmt::format("    '{}')\n      shift words; (( CURRENT-- ))\n      _arguments \\\n", one.path);
    for (const CLI::Option* option : options_of(*one.app)) {
      const std::string title = ":" + plain(value_name(*option)) + ":";
      std::string value;
      switch (kind_of(*option)) {
        case Kind::kNothing: break;
        case Kind::kWords: value = fmt::format("{}({})", title, fmt::join(words_of(*option), " ")); break;
        case Kind::kCodes: value = title + "_owlint_codes"; break;
        case Kind::kCodeLevels: value = title + "_owlint_levels"; break;
        case Kind::kFiles: value = title + "_files"; break;
        case Kind::kFolders: value = title + "_files -/"; break;
        case Kind::kAny: value = title + " "; break;
      }
      const std::string again = option->get_items_expected_max() > 1 ? "*" : "";
      for (const std::string& name : spellings(*option))
        out +=
            fmt::format("        {} \\\n", quoted(again + name + "[" + plain(option->get_description()) + "]" + value));
    }
    std::string own;
    for (const Command& sub : commands_of(*one.app)) own += " " + sub.path;
    if (!own.empty()) out += fmt::format("        '1:command or folder:{{compadd --{}; _files}}' ", own);
    out += takes_codes(*one.app) ? "        '*:rule:_owlint_codes'\n      ;;\n" : "        '*:file:_files'\n      ;;\n";
  }
  return out + "    *) _files ;;\n  esac\n}\n_owlint \"$@\"\n";
}

std::string fish_completion(const CLI::App& app) {
  const Commands commands = all_commands(app);
  std::string out =
      "# fish completion for owlint; made by `owlint generate`\nfunction __owlint_codes\n"
      "    set -l before (string match -r '^.*,' -- (commandline -ct | string replace -r '^--[^=]*=' ''))\n    printf "
      "\"$before%s\\n\"";
  for (const auto& [code, what] : codes()) out += fmt::format(" \\\n        {}\\t{}", code, quoted(what));
  out += "\nend\n";
  out += fmt::format(
      "function __owlint_levels\n    for code in (__owlint_codes | string replace -r '\\t.*' '')\n        printf "
      "'%s\\n' $code={{{}}}\n    end\nend\n",
      CLI::detail::find_and_replace(kLevels, " ", ","));
  for (const Command& one : commands) {
    const size_t blank = one.path.find(' ');
    const std::string when = blank == std::string::npos ? "__fish_use_subcommand"
                                                        : "__fish_seen_subcommand_from " + one.path.substr(0, blank);
    out += fmt::format("complete -c owlint -n '{}' -a {} -d {}\n", when, one.app->get_name(),
                       quoted(one.app->get_description()));
  }
  std::string others;
  for (const Command& one : commands_of(app)) others += one.path == "check" ? "" : " " + one.path;
  for (const Command& one : commands) {
    std::string when;
    for (const std::string& word : CLI::detail::split(one.path, ' '))
      when += (when.empty() ? "" : "; and ") + std::string("__fish_seen_subcommand_from ") + word;
    if (one.path == "check") when = "not __fish_seen_subcommand_from" + others;  // it may be left out
    if (takes_codes(*one.app)) out += fmt::format("complete -c owlint -n '{}' -f -a '(__owlint_codes)'\n", when);
    for (const CLI::Option* option : options_of(*one.app)) {
      out += fmt::format("complete -c owlint -n '{}'", when);
      for (const std::string& name : option->get_snames()) out += " -s " + name;
      for (const std::string& name : option->get_lnames()) out += " -l " + name;
      switch (kind_of(*option)) {
        case Kind::kNothing: break;
        case Kind::kWords: out += fmt::format(" -x -a '{}'", fmt::join(words_of(*option), " ")); break;
        case Kind::kCodes: out += " -x -a '(__owlint_codes)'"; break;
        case Kind::kCodeLevels: out += " -x -a '(__owlint_levels)'"; break;
        case Kind::kFiles: out += " -r"; break;
        case Kind::kFolders: out += " -x -a '(__fish_complete_directories)'"; break;
        case Kind::kAny: out += " -x"; break;
      }
      out += " -d " + quoted(option->get_description()) + "\n";
    }
  }
  return out;
}

}  // namespace owlint::cli
