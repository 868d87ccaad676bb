#include "analyzer/cli/changed.h"

#include <fmt/format.h>

#include "analyzer/text/paths.h"
#include "analyzer/text/process.h"
#include "analyzer/text/source.h"

namespace owlint::cli {

bool changed_since(const std::string& revision, std::set<std::string>* files, std::string* error) {
  const auto git = [&](std::vector<std::string> arguments, std::string* out) {
    arguments.insert(arguments.begin(), "git");
    Ran ran = run_program(std::move(arguments), "", true);
    *out = std::move(ran.out);
    if (!ran.started) *error = "--since needs `git`, which cannot be started";
    return ran.started && ran.status == 0;
  };
  std::string top;
  std::string changed;
  std::string fresh;
  // The revision is one argument, and cannot be taken for an option.
  if (!git({"rev-parse", "--show-toplevel"}, &top) ||
      !git({"diff", "--name-only", "-z", "--diff-filter=d", "--end-of-options", revision, "--"}, &changed) ||
      !git({"ls-files", "--others", "--exclude-standard", "--full-name", "-z", ":/"}, &fresh)) {
    if (error->empty())
      *error = fmt::format("--since {}: git failed; is this a git repository, and does the revision exist?", revision);
    return false;
  }
  if (top.ends_with('\n')) top.pop_back();
  const std::string names = changed + fresh;
  for (size_t at = 0; at < names.size();) {
    const size_t end = names.find('\0', at);
    files->insert(file_key(top + "/" + names.substr(at, end - at)));
    at = end + 1;
  }
  return true;
}

}  // namespace owlint::cli
