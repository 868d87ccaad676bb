#include "analyzer/audit/store.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "analyzer/audit/schema.h"

namespace owlint::audit {
namespace {

constexpr int kPatienceMs = 10'000;  // readers and writers wait for each other that long
constexpr char kMagic[] = "SQLite format 3";

/// Whether a file can only be something else: SQLite would say so only later.
bool is_other_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  char begin[sizeof(kMagic)] = {};
  file.read(begin, sizeof(begin));
  return file.gcount() > 0 && std::memcmp(begin, kMagic, static_cast<size_t>(file.gcount())) != 0;
}

}  // namespace

std::string blob_of(const SQLite::Column& column) {
  return {static_cast<const char*>(column.getBlob()), static_cast<size_t>(column.getBytes())};
}

std::string words_of(const SQLite::Exception& problem, const std::string& path) {
  switch (problem.getErrorCode()) {
    case SQLITE_FULL:
      return fmt::format("cannot write the store {}: no space left; what was committed before is safe", path);
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB: return fmt::format("{} is not an owlint store, or is damaged: {}", path, problem.what());
    case SQLITE_BUSY:
    case SQLITE_LOCKED: return fmt::format("the store {} is in use", path);
    case SQLITE_READONLY: return fmt::format("the store {} cannot be written: it, or its folder, is read-only", path);
    case SQLITE_CANTOPEN: return fmt::format("cannot open the store {}", path);
    default: return fmt::format("the store {}: {}", path, problem.what());
  }
}

/// A lock on a byte that SQLite's own locks never touch. Of the open file, not of the process: closing another
/// descriptor of the same file leaves it alone.
Store::Hold::Hold(const std::string& path, bool wait) : fd_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (fd_ < 0) throw StoreProblem(fmt::format("cannot open the store {}: {}", path, std::strerror(errno)));
  struct flock byte {};
  byte.l_type = F_WRLCK;
  byte.l_whence = SEEK_SET;
  byte.l_start = int64_t{1} << 62;
  byte.l_len = 1;
  int got = ::fcntl(fd_, wait ? F_OFD_SETLKW : F_OFD_SETLK, &byte);
  while (wait && got != 0 && errno == EINTR) got = ::fcntl(fd_, F_OFD_SETLKW, &byte);
  if (got == 0) return;
  const bool held = errno == EAGAIN || errno == EACCES;
  const std::string why = std::strerror(errno);
  ::close(fd_);
  throw StoreProblem(
      held ? fmt::format("another audit is using the store {}: wait until it has finished, or use --wait", path)
           : fmt::format("cannot lock the store {}: {}", path, why));
}

Store::Hold::~Hold() { ::close(fd_); }

Store Store::open(const std::string& path, For use, bool wait) {
  Store store;
  store.path_ = path;
  std::error_code problem;
  const bool writing = use == For::kWriting;
  if (!writing && !std::filesystem::exists(path, problem))
    throw StoreProblem(fmt::format("there is no store {}: `owlint audit PATH… --store FILE` makes one", path));
  const auto kind = std::filesystem::status(path, problem).type();
  using Type = std::filesystem::file_type;
  if (kind != Type::regular && kind != Type::directory && kind != Type::not_found && kind != Type::none)
    throw StoreProblem(fmt::format("{} is not an owlint store: it is not a file", path));
  if (is_other_file(path)) throw StoreProblem(fmt::format("{} is not an owlint store", path));
  if (writing) store.hold_ = std::make_unique<Hold>(path, wait);
  try {
    // A reader that may write as well takes SQLite's files beside the store away when it is the last to close it.
    const bool writable = writing || ::access(path.c_str(), W_OK) == 0;
    store.db_ = std::make_unique<SQLite::Database>(
        path, writable ? SQLite::OPEN_READWRITE | (writing ? SQLite::OPEN_CREATE : 0) : SQLite::OPEN_READONLY,
        kPatienceMs);
    if (!writing) store.db_->exec("PRAGMA query_only = 1");
    store.migrate(writing);
  } catch (const SQLite::Exception& e) {
    throw StoreProblem(words_of(e, path));
  }
  return store;
}

void Store::migrate(bool writing) {
  const int version = db_->execAndGet("PRAGMA user_version").getInt();
  const int application = db_->execAndGet("PRAGMA application_id").getInt();
  const bool fresh = db_->execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
  if (!fresh && application != kApplicationId)
    throw StoreProblem(fmt::format("{} is a database, but not an owlint store", path_));
  const auto wanted = static_cast<int>(kSteps.size());
  if (version > wanted) throw StoreProblem(fmt::format("the store {} was written by a newer owlint", path_));
  if (!writing) {
    if (version < wanted)
      throw StoreProblem(
          fmt::format("the store {} was written by an older owlint: the next `owlint audit` updates it", path_));
    return;
  }
  // A network file system may refuse WAL; then SQLite keeps its old way, which is as safe.
  db_->exec("PRAGMA journal_mode = WAL");
  db_->exec("PRAGMA synchronous = NORMAL");
  for (int step = version; step < wanted; ++step) {
    SQLite::Transaction transaction(*db_, SQLite::TransactionBehavior::IMMEDIATE);
    db_->exec(kSteps[static_cast<size_t>(step)]);
    db_->exec(fmt::format("PRAGMA user_version = {}", step + 1));
    db_->exec(fmt::format("PRAGMA application_id = {}", kApplicationId));
    transaction.commit();
  }
}

int64_t Store::last_complete() {
  return db_->execAndGet("SELECT coalesce(max(id), 0) FROM run WHERE state = 'complete'").getInt64();
}

}  // namespace owlint::audit
