#include <dirent.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "analyzer/text/files.h"
#include "analyzer/text/paths.h"

namespace owlint {
namespace {

namespace fs = std::filesystem;

FileKind kind_of(mode_t mode) {
  return S_ISREG(mode) ? FileKind::kFile
      : S_ISDIR(mode)  ? FileKind::kFolder
      : S_ISLNK(mode)  ? FileKind::kLink
                       : FileKind::kOther;
}

/// Times are kept coarsely, by some file systems in steps of two seconds: what was changed just now may be changed again
/// and look the same.
uint64_t stamp_of(const struct stat& info) {
  constexpr time_t kCoarse = 2;
  const time_t now = ::time(nullptr);
  if (info.st_mtim.tv_sec + kCoarse >= now || info.st_ctim.tv_sec + kCoarse >= now) return 0;
  const std::array<int64_t, 6> all = {info.st_size,        static_cast<int64_t>(info.st_ino),
                                      info.st_mtim.tv_sec, info.st_mtim.tv_nsec,
                                      info.st_ctim.tv_sec, info.st_ctim.tv_nsec};
  return XXH3_64bits(all.data(), sizeof(all)) | 1;
}

/// Closes a file at the end.
struct Opened {
  int fd;
  explicit Opened(int file) : fd(file) {}
  ~Opened() {
    if (fd >= 0) ::close(fd);
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
};

std::shared_ptr<const Source> failed(std::string* error) {
  *error = std::strerror(errno);
  return nullptr;
}

class Disk : public Files {
 public:
  std::shared_ptr<const Source> read(const std::string& path, std::string* error) const override {
    // O_NONBLOCK: opening a FIFO that nobody writes to must not hang; fstat then refuses it.
    const Opened file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.fd < 0) return failed(error);
    struct stat info {};
    if (::fstat(file.fd, &info) != 0) return failed(error);
    if (!S_ISREG(info.st_mode)) {
      *error = S_ISDIR(info.st_mode) ? "is a directory" : "is not a regular file";
      return nullptr;
    }
    const auto size = static_cast<size_t>(info.st_size);
    constexpr size_t kSmall = 64 << 10;  // up to here reading costs less than mapping
    if (size > kSmall) {
      void* memory = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.fd, 0);
      return memory == MAP_FAILED ? failed(error) : Source::adopt(path, memory, size);
    }
    std::string bytes(size, '\0');
    size_t have = 0;
    while (have < size) {
      const ssize_t got = ::read(file.fd, bytes.data() + have, size - have);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return failed(error);
      if (got == 0) break;  // it has become shorter
      have += static_cast<size_t>(got);
    }
    bytes.resize(have);
    return Source::own(path, std::move(bytes));
  }

  FileInfo info(const std::string& path) const override {
    struct stat info {};
    if (::stat(path.c_str(), &info) != 0) return {};
    return {kind_of(info.st_mode), static_cast<uint64_t>(info.st_size), (info.st_mode & S_IXUSR) != 0, stamp_of(info)};
  }

  bool readable(const std::string& path) const override { return ::access(path.c_str(), R_OK) == 0; }

  std::vector<FolderEntry> list(const std::string& folder, std::string* error) const override {
    DIR* const open = ::opendir(folder.c_str());
    if (open == nullptr) {
      *error = std::strerror(errno);
      return {};
    }
    std::vector<FolderEntry> entries;
    while (const dirent* entry = ::readdir(open)) {
      const char* const name = static_cast<const char*>(entry->d_name);
      if (std::strcmp(name, ".") != 0 && std::strcmp(name, "..") != 0)
        entries.push_back({name, kind_of_entry(::dirfd(open), *entry)});
    }
    ::closedir(open);
    return entries;
  }

  std::string real_path(const std::string& path) const override {
    std::error_code problem;
    const std::string real = fs::weakly_canonical(fs::absolute(path, problem), problem).string();
    return problem ? file_key(path) : real;
  }

 private:
  static FileKind kind_of_entry(int folder, const dirent& entry) {
    switch (entry.d_type) {
      case DT_REG: return FileKind::kFile;
      case DT_DIR: return FileKind::kFolder;
      case DT_LNK: return FileKind::kLink;
      case DT_UNKNOWN: break;  // some file systems do not say
      default: return FileKind::kOther;
    }
    struct stat info {};
    return ::fstatat(folder, entry.d_name, &info, AT_SYMLINK_NOFOLLOW) == 0 ? kind_of(info.st_mode) : FileKind::kOther;
  }
};

}  // namespace

std::string Files::seen_from_here(const std::string& path) const {
  return relative_path(real_path(path), real_path("."));
}

const Files& disk() {
  static const Disk files;
  return files;
}

}  // namespace owlint
