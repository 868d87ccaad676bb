// `owlint explain`, `owlint rules`, `owlint graph`: what the catalogue and a program's structure say.
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analyzer/cli/commands.h"
#include "analyzer/report/graph.h"
#include "analyzer/report/markdown.h"
#include "analyzer/report/pages.h"
#include "analyzer/text/files.h"
#include "analyzer/text/printable.h"
#include "analyzer/text/terminal.h"
#include "analyzer/text/width.h"
#include "rules/driver/rule.h"

namespace owlint::cli {
namespace {

/// How wide text for people is; lines that go on for ever are hard to read.
size_t text_width() {
  constexpr size_t kWidest = 100;
  const size_t terminal = columns_of(STDOUT_FILENO);
  return terminal == 0 ? kWidest : std::min(terminal, kWidest);
}

/// A rule as one line of a list.
void print_row(const Rule& rule) {
  const std::string row = fmt::format("  {}  {:<25} {:<8} ", rule.code, rule.name, severity_text(rule.level));
  const size_t width = columns_of(STDOUT_FILENO);
  const std::string indent(width < 2 * row.size() ? 9 : row.size(),
                           ' ');  // below the name, where there is no room beside it
  std::cout << row << (indent.size() < row.size() && width > 0 ? "\n" + indent : "")
            << wrapped(rule.summary, width, indent, indent.size()) << '\n';
}

/// The rules whose codes begin like this, or whose names have this word: `OW1`, `arc`.
std::vector<const Rule*> rules_about(const std::string& text) {
  const std::string prefix = code_meant(text);
  const std::string word = "-" + text + "-";
  std::vector<const Rule*> found;
  std::ranges::copy_if(catalogue(), std::back_inserter(found), [&](const Rule* rule) {
    const std::string name = "-" + std::string(rule->name) + "-";
    return prefix.empty() ? name.find(word) != std::string::npos : rule->code.starts_with(prefix);
  });
  return found;
}

}  // namespace

std::shared_ptr<const Source> read_program(const CommandLine& line, checking::Settings* settings) {
  const std::string& path = line.paths.front();
  std::string error;
  Configuration configuration(disk(), line);
  if (!configuration.settings_for(path, settings, &error)) {
    complain(error);
    return nullptr;
  }
  auto source = disk().read(path, &error);
  if (source == nullptr) complain("cannot read " + path + ": " + error);
  return source;
}

void complain(const std::string& message) {
  std::cerr << "owlint: " << printable_text(message) << '\n';
}  // names of files may steer terminals

int explain_command(const std::string& code_or_name, const std::string& color) {
  const Rule* rule = find_rule(code_or_name);
  if (rule == nullptr) {
    const std::vector<const Rule*> several = rules_about(code_or_name);
    for (const Rule* each : several) print_row(*each);
    if (!several.empty()) return kClean;
    complain(unknown_rule(code_or_name));
    return kUsage;
  }
  std::cout << render_markdown(rule_page(*rule), use_color(color, STDOUT_FILENO), text_width());
  return kClean;
}

int rule_pages_command(const std::string& folder) {
  std::string error;
  if (write_rule_pages(folder, &error)) return kClean;
  complain(error);
  return kUsage;
}

int rules_command(const std::string& format) {
  if (format == "json") {
    auto list = nlohmann::ordered_json::array();
    for (const Rule* rule : catalogue()) {
      list.push_back({{"code", rule->code},
                      {"name", rule->name},
                      {"summary", rule->summary},
                      {"group", group_title(rule->group)},
                      {"severity", severity_text(rule->level)},
                      {"default", rule->level != Severity::kInfo},
                      {"what", rule->page.what},
                      {"why", rule->page.why},
                      {"bad", rule->page.bad},
                      {"good", rule->page.good},
                      {"fix", rule->page.fix},
                      {"level_reason", rule->page.level_reason},
                      {"options", rule->page.options},
                      {"interpreter", rule->page.interpreter},
                      {"moves", rule->page.moves},
                      {"moves_good", rule->page.moves_good}});
    }
    std::cout << list.dump(2) << '\n';
    return kClean;
  }
  const bool markdown = format == "markdown";
  std::string_view group;
  for (const Rule* rule : catalogue()) {
    if (group_title(rule->group) != group) {
      const bool first = group.empty();
      group = group_title(rule->group);
      std::cout << (first ? "" : "\n");
      if (markdown) {
        std::cout << fmt::format("## OW{}xx {}\n\n| code | name | severity | finds |\n|---|---|---|---|\n",
                                 rule->code.substr(2, 1), group);
      } else {
        std::cout << fmt::format("{}\n", group);
      }
    }
    if (markdown) {
      std::cout << fmt::format("| {} | {} | {} | {} |\n", rule->code, rule->name, severity_text(rule->level),
                               rule->summary);
    } else {
      print_row(*rule);
    }
  }
  return kClean;
}

int graph_command(const CommandLine& line, const std::string& format) {
  Settings settings;
  const auto source = read_program(line, &settings);
  if (source == nullptr) return kUsage;
  Library library(disk());
  const auto program = library.load(source, settings.profile);
  const Linked linked(program, settings.profile, library);
  const bool marks = format == "svg" || format == "dot";
  const std::vector<Finding> findings =
      marks ? lint(program, settings.profile, settings.options, library).own.findings : std::vector<Finding>();
  if (format == "json") {
    write_graph_json(std::cout, linked);
  } else if (format == "mermaid") {
    write_graph_mermaid(std::cout, linked);
  } else if (format == "svg") {
    if (const std::string problem = write_graph_svg(std::cout, linked, findings); !problem.empty()) {
      complain(problem);
      return kUsage;
    }
  } else {
    write_graph_dot(std::cout, linked, findings);
  }
  return kClean;
}

}  // namespace owlint::cli
