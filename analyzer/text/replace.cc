#include "analyzer/text/replace.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "analyzer/text/files.h"

namespace owlint {
namespace {

bool write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(fd, text.data(), text.size());
    if (written <= 0) return false;
    text.remove_prefix(static_cast<size_t>(written));
  }
  return true;
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

bool make_folder(const std::string& path, std::string* error) {
  std::error_code problem;
  std::filesystem::create_directories(path, problem);
  if (problem) *error = problem.message();
  return !problem;
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
  const auto now = disk().read(path, error);
  if (now == nullptr) return false;
  if (now->bytes() == text) return true;  // by another name of the file
  if (now->bytes() != old) {
    *error = "it has changed in the meantime, so it is not replaced";
    return false;
  }
  return replace_file(path, text, error);
}

}  // namespace owlint
