#include "analyzer/cli/generate.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/cli/completion.h"
#include "analyzer/cli/values.h"
#include "analyzer/report/report.h"

namespace owlint::cli {
namespace {

/// As a part of a manual page's name.
std::string dashed(std::string path) { return CLI::detail::find_and_replace(std::move(path), " ", "-"); }

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
    out += fmt::format(".TP\n{}{}\n{}\n", fmt::join(names, ", "),
                       takes_value(*option) ? " \\fI" + roff(value_name(*option)) + "\\fR" : "",
                       roff(description_of(*option)));
  }
  return out;
}

constexpr const char* kStatus = R"(.SH EXIT STATUS
.TP
0
no finding at or above \fB\-\-fail\-on\fR
.TP
1
findings
.TP
2
wrong usage or configuration, or a file that cannot be read
.TP
3
a bug in owlint
)";

std::string man_page(const CLI::App& app, const std::string& name, const Commands& commands) {
  std::string out = fmt::format(".TH {} 1 \"\" \"owlint {}\" \"owlint\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n", name,
                                kToolVersion, roff(name), roff(app.get_description()));
  std::string positional;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional())
      positional +=
          fmt::format(" \\fI{}\\fR{}", option->get_name(true), option->get_items_expected_max() > 1 ? "..." : "");
  }
  const std::string command = CLI::detail::find_and_replace(name, "-", " ");
  if (commands.empty() || !positional.empty()) out += fmt::format(".B {}\n[\\fIoptions\\fR]{}\n", command, positional);
  if (!commands.empty())
    out += fmt::format("{}.B {}\n\\fIcommand\\fR [\\fIoptions\\fR]\n", positional.empty() ? "" : ".br\n", command);
  if (name == "owlint")
    out +=
        ".SH DESCRIPTION\nFinds mistakes in the O\\-words of LinuxCNC programs that stop the machine, before it "
        "moves.\n";
  if (!commands.empty()) out += ".SH COMMANDS\n";
  for (const Command& one : commands)
    out += fmt::format(".TP\n\\fB{}\\fR\n{}; see \\fBowlint\\-{}\\fR(1)\n", roff(one.app->get_name()),
                       roff(one.app->get_description()), roff(dashed(one.path)));
  return out + man_options(app) + kStatus;
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
  bool good = write("man1/owlint.1", man_page(app, "owlint", commands_of(app))) &&
      write("bash/owlint", bash_completion(app)) && write("zsh/_owlint", zsh_completion(app)) &&
      write("fish/owlint.fish", fish_completion(app));
  for (const Command& one : commands) {
    const std::string name = "owlint-" + dashed(one.path);
    good = good && write(fmt::format("man1/{}.1", name), man_page(*one.app, name, commands_of(*one.app, one.path)));
  }
  return good;
}

}  // namespace owlint::cli
