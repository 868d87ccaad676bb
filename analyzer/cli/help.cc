#include "analyzer/cli/help.h"

#include <unistd.h>

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/cli/values.h"
#include "analyzer/text/terminal.h"
#include "analyzer/text/width.h"

namespace owlint::cli {
namespace {

constexpr size_t kLeft = 28;  // columns of what is described

class Page {
 public:
  explicit Page(size_t width) : width_(width) {}

  void paragraph(const std::string& text) { out_ += wrapped(text, width_, "  ") + '\n'; }
  void blank() { out_ += '\n'; }
  void heading(const std::string& text) { out_ += fmt::format("\n{}:\n", text); }
  void row(const std::string& what, const std::string& description) {
    const std::string indent(kLeft, ' ');
    std::string left = "  " + what;
    left += left.size() + 2 > kLeft ? "\n" + indent : std::string(kLeft - left.size(), ' ');
    out_ += left + wrapped(description, width_, indent, kLeft) + '\n';
  }
  const std::string& text() const { return out_; }

 private:
  size_t width_;
  std::string out_;
};

/// `PATH...`, `[RUN]`.
std::string positional_text(const CLI::Option& option) {
  const std::string name = option.get_name(true) + (option.get_items_expected_max() > 1 ? "..." : "");
  return option.get_required() ? name : "[" + name + "]";
}

std::string option_text(const CLI::Option& option) {
  std::string text = fmt::format("{}", fmt::join(spellings(option), ", "));
  if (takes_value(option)) text += " " + value_name(option);
  return text;
}

}  // namespace

std::string Help::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const {
  constexpr size_t kWidest = 100;
  const size_t terminal = columns_of(STDOUT_FILENO);
  Page page(terminal == 0 ? kWidest : std::clamp<size_t>(terminal, kLeft + 20, kWidest));
  page.paragraph(app->get_description());
  std::string usage = name;
  const auto commands = commands_of(*app);
  const auto positionals = positionals_of(*app);
  if (!commands.empty() && positionals.empty()) usage += " COMMAND";
  usage += " [OPTIONS]";
  for (const CLI::Option* one : positionals) usage += " " + positional_text(*one);
  page.blank();
  page.paragraph("Usage: " + usage);
  if (!commands.empty() && !positionals.empty()) page.paragraph("       " + name + " COMMAND [OPTIONS]");
  if (!positionals.empty()) page.blank();
  for (const CLI::Option* one : positionals) page.row(one->get_name(true), description_of(*one));

  std::vector<std::string> groups;
  const auto options = options_of(*app);
  for (const CLI::Option* one : options) {
    if (std::ranges::find(groups, one->get_group()) == groups.end()) groups.push_back(one->get_group());
  }
  for (const std::string& group : groups) {
    page.heading(group);
    for (const CLI::Option* one : options) {
      if (one->get_group() == group) page.row(option_text(*one), description_of(*one));
    }
  }
  if (!commands.empty()) page.heading("Commands");
  for (const Command& one : commands) page.row(one.path, one.app->get_description());
  std::istringstream footer(app->get_footer());
  if (!app->get_footer().empty()) page.blank();
  for (std::string line; std::getline(footer, line);) page.paragraph(line);
  return page.text();
}

}  // namespace owlint::cli
