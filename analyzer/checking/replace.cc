#include "analyzer/checking/replace.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <dtl/dtl.hpp>

#include "analyzer/text/source.h"

namespace owlint::checking {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const size_t feed = text.find('\n');
    if (feed == std::string_view::npos) {
      lines.push_back(std::string(text) + "\n\\ No newline at end of file");
      break;
    }
    lines.emplace_back(text.substr(0, feed));
    text.remove_prefix(feed + 1);
  }
  return lines;
}

bool write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(fd, text.data(), text.size());
    if (written <= 0) return false;
    text.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

/// Where the line begins that lies `lines` above the one of `at`.
size_t lines_up(std::string_view text, size_t at, int lines) {
  for (;; --lines) {
    const size_t feed = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    if (feed == std::string_view::npos) return 0;
    if (lines == 0) return feed + 1;
    at = feed;
  }
}

}  // namespace

bool replace_file(const std::string& path, std::string_view text, std::string* error) {
  std::error_code problem;
  const std::string target = std::filesystem::canonical(path, problem).string();
  if (problem) {
    *error = problem.message();
    return false;
  }
  // Who may write in its folder could replace a program that is write-protected, and shall not.
  struct stat info {};
  if (::stat(target.c_str(), &info) != 0 || ::access(target.c_str(), W_OK) != 0) {
    *error = std::strerror(errno);
    return false;
  }
  std::string fresh = target + ".owlint-XXXXXX";
  const int fd = ::mkstemp(fresh.data());
  if (fd < 0) {
    *error = fmt::format("no file can be made in its folder: {}", std::strerror(errno));
    return false;
  }
  // Its owner stays where that is allowed.
  [[maybe_unused]] const int owned = ::fchown(fd, info.st_uid, info.st_gid);
  const bool good = ::fchmod(fd, info.st_mode & 07777) == 0 && write_all(fd, text) && ::fsync(fd) == 0 &&
      std::rename(fresh.c_str(), target.c_str()) == 0;
  if (!good) {
    *error = std::strerror(errno);
    ::unlink(fresh.c_str());
  }
  ::close(fd);
  return good;
}

bool write_text_file(const std::string& path, std::string_view text, std::string* error) {
  std::error_code problem;
  if (std::filesystem::is_regular_file(path, problem)) return replace_file(path, text, error);
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) *error = std::strerror(errno);
  return static_cast<bool>(file);
}

bool replace_unchanged(const std::string& path, std::string_view old, std::string_view text, std::string* error) {
  const auto now = Source::map(path, error);
  if (now == nullptr) return false;
  if (now->bytes() == text) return true;  // by another name of the file
  if (now->bytes() != old) {
    *error = "it has changed in the meantime, so it is not replaced";
    return false;
  }
  return replace_file(path, text, error);
}

std::string unified_diff(const std::string& path, std::string_view before, std::string_view after) {
  // Only what lies between the parts that are alike is compared line by line: a program may have a gigabyte.
  constexpr int kContext = 3;
  const size_t shorter = std::min(before.size(), after.size());
  size_t head = static_cast<size_t>(std::ranges::mismatch(before, after).in1 - before.begin());
  head = lines_up(before, head, kContext);
  size_t tail = 0;
  while (tail < shorter - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
  const auto end_of = [&](std::string_view text) {
    size_t end = text.size() - tail;
    for (int lines = 0; lines <= kContext && end < text.size(); ++lines)
      end = std::min(text.find('\n', end), text.size() - 1) + 1;
    return end;
  };
  const size_t skipped = static_cast<size_t>(std::ranges::count(before.substr(0, head), '\n'));
  const std::vector<std::string> old_lines = lines_of(before.substr(head, end_of(before) - head));
  const std::vector<std::string> new_lines = lines_of(after.substr(head, end_of(after) - head));
  dtl::Diff<std::string> diff(old_lines, new_lines);
  diff.compose();
  diff.composeUnifiedHunks();
  std::ostringstream out;
  out << fmt::format("--- {}\n+++ {}\n", path, path);
  for (auto hunk : diff.getUniHunks()) {
    out << fmt::format("@@ -{},{} +{},{} @@\n", hunk.a + static_cast<long long>(skipped), hunk.b,
                       hunk.c + static_cast<long long>(skipped), hunk.d);
    const auto write = [&out](const auto& lines) {
      for (const auto& [line, info] : lines)
        out << (info.type == dtl::SES_ADD ? '+' : info.type == dtl::SES_DELETE ? '-' : ' ') << line << '\n';
    };
    write(hunk.common[0]);
    write(hunk.change);
    write(hunk.common[1]);
  }
  return out.str();
}

}  // namespace owlint::checking
