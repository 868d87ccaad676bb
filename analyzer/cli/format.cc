// `owlint fmt`: indents programs, or says what it would change. `owlint lsp`: starts the server.
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include <fmt/format.h>

#include "analyzer/cli/commands.h"
#include "analyzer/cli/walk.h"
#include "analyzer/format/indent.h"
#include "analyzer/lsp/server.h"

namespace owlint::cli {
namespace {

std::string apply(std::string_view text, const std::vector<Edit>& edits) {
  std::string out;
  out.reserve(text.size());
  size_t at = 0;
  for (const Edit& edit : edits) {
    out += text.substr(at, edit.span.begin - at);
    out += edit.text;
    at = edit.span.end;
  }
  out += text.substr(at);
  return out;
}

/// As `diff -u` without lines around: every edit changes one line.
void print_diff(const Source& source, const std::vector<Edit>& edits) {
  std::cout << fmt::format("--- {}\n+++ {}\n", source.path(), source.path());
  for (const Edit& edit : edits) {
    const uint32_t number = source.position(edit.span.begin).line;
    const Span line = source.line(number);
    const std::string_view rest = source.slice({edit.span.end, line.end});
    std::cout << fmt::format("@@ -{0} +{0} @@\n-{1}\n+{2}{3}\n", number, source.slice(line), edit.text, rest);
  }
}

/// In the place of the old file at once, with its permissions: whoever reads it sees the old text or the new one.
bool replace_file(const std::string& path, const std::string& text, std::string* error) {
  std::error_code problem;
  const std::string target = std::filesystem::canonical(path, problem).string();
  if (problem) {
    *error = problem.message();
    return false;
  }
  std::string fresh = target + ".owlint-XXXXXX";
  const int fd = ::mkstemp(fresh.data());
  struct stat info {};
  bool good = fd >= 0 && ::stat(target.c_str(), &info) == 0 && ::fchmod(fd, info.st_mode & 07777) == 0;
  for (size_t at = 0; good && at < text.size();) {
    const ssize_t written = ::write(fd, text.data() + at, text.size() - at);
    good = written > 0;
    if (good) at += static_cast<size_t>(written);
  }
  good = good && ::fsync(fd) == 0;
  if (fd >= 0) ::close(fd);
  good = good && std::rename(fresh.c_str(), target.c_str()) == 0;
  if (!good) {
    *error = std::strerror(errno);
    if (fd >= 0) ::unlink(fresh.c_str());
  }
  return good;
}

}  // namespace

int format_command(const CommandLine& line, bool check, bool diff) {
  const Walk found = walk(line.paths);
  int status = kClean;
  const auto trouble = [&](const std::string& message) {
    complain(message);
    status = kUsage;
  };
  for (const std::string& problem : found.problems) trouble(problem);
  size_t changed = 0;
  for (const std::string& path : found.files) {
    std::string error;
    const bool standard = path == "-";
    const auto source = standard ? Source::own("<stdin>", std::string{std::istreambuf_iterator<char>(std::cin), {}}) : Source::map(path, &error);
    if (source == nullptr) {
      trouble("cannot read " + path + ": " + error);
      continue;
    }
    const std::vector<Edit> edits = indentation(*build_program(source), {});
    if (!edits.empty()) ++changed;
    if (diff) {
      if (!edits.empty()) print_diff(*source, edits);
    } else if (check) {
      if (!edits.empty()) std::cout << "would indent " << path << '\n';
    } else if (standard) {
      std::cout << apply(source->bytes(), edits);
    } else if (!edits.empty() && !replace_file(path, apply(source->bytes(), edits), &error)) {
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
  std::signal(SIGPIPE, SIG_IGN);  // that the client has gone is told by writing
  return lsp::Server(stdin, stdout).run();
}

}  // namespace owlint::cli
