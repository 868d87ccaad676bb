#include "analyzer/report/pages.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

namespace owlint {

namespace fs = std::filesystem;

std::string rule_page(const Rule& rule) {
  const Page& page = rule.page;
  std::string out = fmt::format("# {} {}\n\n{}.\n\n{}\n\n{}\n", rule.code, rule.name, rule.summary, page.what, page.why);
  if (!page.interpreter.empty()) out += fmt::format("\nLinuxCNC says: `{}`\n", page.interpreter);
  out += fmt::format("\n## Found here{}\n\n```\n{}```\n\n## Use instead\n\n```\n{}```\n\n{}\n",
                     page.options.empty() ? "" : fmt::format(" with `{}`", page.options), page.bad, page.good, page.fix);
  out += fmt::format("\nTo silence it: `(owlint: ignore {} -- reason)` on the line before.\n", rule.code);
  return out;
}

bool write_rule_pages(const std::string& folder, std::string* error) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  for (const Rule* rule : catalogue()) {
    const fs::path path = fs::path(folder) / (std::string(rule->code) + ".md");
    std::ofstream file(path, std::ios::binary);
    file << rule_page(*rule);
    if (file.flush()) continue;
    *error = "cannot write " + path.string();
    return false;
  }
  return true;
}

std::string installed_rule_page(std::string_view code) {
  static const fs::path folder = [] {
    std::error_code problem;
    const fs::path program = fs::read_symlink("/proc/self/exe", problem);
    return program.parent_path().parent_path() / "share" / "doc" / "owlint" / "rules";
  }();
  std::error_code problem;
  const fs::path page = folder / (std::string(code) + ".md");
  return fs::exists(page, problem) ? page.string() : std::string();
}

}  // namespace owlint
