// `owlint fmt`: indents programs, or says what it would change. `owlint lsp`: starts the server.
#include <csignal>
#include <cstdio>
#include <iostream>
#include <iterator>

#include "analyzer/checking/diff.h"
#include "analyzer/checking/walk.h"
#include "analyzer/cli/commands.h"
#include "analyzer/findings/edits.h"
#include "analyzer/format/indent.h"
#include "analyzer/lsp/server.h"
#include "analyzer/text/files.h"
#include "analyzer/text/replace.h"

namespace owlint::cli {

int format_command(const CommandLine& line, bool check, bool diff) {
  Configuration configuration(disk(), line);
  const Walk found =
      walk(disk(), line.paths, line.walk, [&](const std::string& folder) { return configuration.patterns_in(folder); });
  int status = kClean;
  const auto trouble = [&](const std::string& message) {
    complain(message);
    status = kUsage;
  };
  for (const std::string& problem : found.problems) trouble(problem);
  size_t changed = 0;
  for (const auto& [path, stamp, bytes] : found.files) {
    std::string error;
    const bool standard = path == "-";
    const auto source = standard ? Source::own("<stdin>", std::string{std::istreambuf_iterator<char>(std::cin), {}})
                                 : disk().read(path, &error);
    if (source == nullptr) {
      trouble("cannot read " + path + ": " + error);
      continue;
    }
    const std::vector<Edit> edits = indentation(*build_program(source), {});
    if (!edits.empty()) ++changed;
    if (diff) {
      if (!edits.empty()) std::cout << unified_diff(path, source->bytes(), apply_edits(source->bytes(), edits));
    } else if (check) {
      if (!edits.empty()) std::cout << "would indent " << path << '\n';
    } else if (standard) {
      std::cout << apply_edits(source->bytes(), edits);
    } else if (!edits.empty() && !replace_file(path, apply_edits(source->bytes(), edits), &error)) {
      trouble("cannot write " + path + ": " + error);
    } else if (!edits.empty()) {
      std::cerr << "indented " << path << '\n';
    }
  }
  std::cout.flush();
  if (status != kClean) return status;
  return (check || diff) && changed > 0 ? kFindings : kClean;
}

int lsp_command() {
  std::signal(SIGPIPE, SIG_IGN);  // a failed write tells that the client has gone
  return lsp::Server(stdin, stdout).run();
}

}  // namespace owlint::cli
