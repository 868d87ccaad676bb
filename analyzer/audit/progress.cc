#include "analyzer/audit/progress.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <iostream>
#include <string>

#include <fmt/format.h>

#include "analyzer/text/terminal.h"

extern char** environ;

namespace owlint::audit {

Progress::Progress(bool quiet) : quiet_(quiet), last_(std::chrono::steady_clock::now()) {}

Progress::~Progress() { finish(); }

/// pv reads a line for each program that is done.
void Progress::start_bar(size_t total) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_adddup2(&files, ends[0], STDIN_FILENO);
  ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  const std::string size = std::to_string(total);
  std::array<const char*, 12> arguments = {"pv",     "--line-mode", "--size", size.c_str(), "--progress", "--eta",
                                           "--rate", "--bytes",     "--name", "programs",   nullptr,      nullptr};
  pid_t pid = -1;
  const int problem = ::posix_spawnp(&pid, "pv", &files, nullptr, const_cast<char**>(arguments.data()), environ);
  ::posix_spawn_file_actions_destroy(&files);
  ::close(ends[0]);
  if (problem != 0) {
    ::close(ends[1]);
    return;
  }
  ::signal(SIGPIPE, SIG_IGN);  // pv may be ended by the same Ctrl-C
  process_ = pid;
  bar_ = ends[1];
}

void Progress::tell(size_t done, size_t total) {
  constexpr size_t kWorth = 200;  // fewer are done before one has looked
  constexpr auto kSeldom = std::chrono::seconds(10);
  if (quiet_ || total < kWorth) return;
  if (!started_) {
    started_ = true;
    if (is_terminal(STDERR_FILENO)) start_bar(total);
  }
  if (bar_ >= 0) {
    const std::string lines(done - reported_, '\n');
    if (done - reported_ < 16 && done < total) return;
    if (::write(bar_, lines.data(), lines.size()) > 0) reported_ = done;
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < kSeldom) return;
  last_ = now;
  std::cerr << fmt::format("{} of {} programs\n", done, total);
}

void Progress::finish() {
  if (bar_ < 0) return;
  ::close(bar_);
  bar_ = -1;
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace owlint::audit
