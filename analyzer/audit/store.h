// The store of an audit: one SQLite file. Whoever writes holds it alone; people and programs can read it meanwhile.
#pragma once

#include <memory>
#include <string>

#include <SQLiteCpp/SQLiteCpp.h>

namespace owlint::audit {

/// What is wrong with a store, for people: its message names the store.
class StoreProblem : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Store {
 public:
  enum class For : uint8_t { kReading, kWriting };

  /// Opens a store, brings it to this owlint's tables, and takes it for writing: a second writer is refused, or waits.
  /// Throws StoreProblem.
  static Store open(const std::string& path, For use, bool wait = false);

  SQLite::Database& db() { return *db_; }
  const std::string& path() const { return path_; }

  /// The number of the last complete run; 0 if there is none.
  int64_t last_complete();

 private:
  /// Held while a store is written; the system takes it back when the process ends in whatever way.
  class Hold {
   public:
    Hold(const std::string& path, bool wait);
    ~Hold();
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

   private:
    int fd_;
  };
  void migrate(bool writing);

  std::string path_;
  std::unique_ptr<Hold> hold_;  // before the database: it is let go after that is closed
  std::unique_ptr<SQLite::Database> db_;
};

/// The bytes of a column.
std::string blob_of(const SQLite::Column& column);

/// What to tell people of an error of SQLite's with this store.
std::string words_of(const SQLite::Exception& problem, const std::string& path);

}  // namespace owlint::audit
