#include "analyzer/report/pages.h"

#include <algorithm>

#include <fmt/format.h>

#include "analyzer/text/files.h"
#include "analyzer/text/paths.h"
#include "analyzer/text/process.h"
#include "analyzer/text/replace.h"

namespace owlint {

std::string rule_page(const Rule& rule) {
  const Page& page = rule.page;
  std::string out = fmt::format("# {} {}\n\n{}.\n\n{} · {}{}\n\n{}\n\n{}\n", rule.code, rule.name, rule.summary,
                                group_title(rule.group), severity_text(rule.level),
                                rule.level == Severity::kInfo ? ", off unless you select it" : "", page.what, page.why);
  if (!page.interpreter.empty()) out += fmt::format("\nLinuxCNC says: `{}`\n", page.interpreter);
  const auto goes = [](std::string_view to) {
    return to.empty() ? std::string() : fmt::format("\nThe last rapid move goes to **{}**.\n", to);
  };
  out += fmt::format("\n## Found here{}\n\n```\n{}```\n{}\n## Use instead\n\n```\n{}```\n{}\n{}\n",
                     page.options.empty() ? "" : fmt::format(" with `{}`", page.options), page.bad, goes(page.moves),
                     page.good, goes(page.moves_good), page.fix);
  out += fmt::format("\nTo suppress this finding, write `(owlint: ignore {} because ...)` on the line before.\n",
                     rule.code);
  out += fmt::format("\n## Level\n\n{}\n", page.level_reason);
  return out;
}

std::string rule_index() {
  std::string out =
      "# Rules\n\nGenerated from owlint's own list of rules. `owlint explain OW104` shows the same page on the command "
      "line.\n";
  std::string_view group;
  for (const Rule* rule : catalogue()) {
    if (group_title(rule->group) != group) {
      group = group_title(rule->group);
      out += fmt::format("\n## OW{}xx {}\n\n| code | name | severity | finds |\n|---|---|---|---|\n",
                         rule->code.substr(2, 1), group);
    }
    out += fmt::format("| [{0}]({0}.md) | {1} | {2} | {3} |\n", rule->code, rule->name, severity_text(rule->level),
                       rule->summary);
  }
  return out;
}

bool write_rule_pages(const std::string& folder, std::string* error) {
  const auto write = [&](std::string_view name, const std::string& text) {
    const std::string path = joined_path(folder, fmt::format("{}.md", name));
    if (write_text_file(path, text, error)) return true;
    *error = fmt::format("cannot write {}: {}", path, *error);
    return false;
  };
  return make_folder(folder, error) && write("README", rule_index()) &&
      std::ranges::all_of(catalogue(), [&](const Rule* rule) { return write(rule->code, rule_page(*rule)); });
}

std::string installed_rule_page(std::string_view code) {
  static const std::string folder = joined_path(folder_of(folder_of(own_program())), "share/doc/owlint/rules");
  std::string page = joined_path(folder, fmt::format("{}.md", code));
  return disk().exists(page) ? page : std::string();
}

}  // namespace owlint
