// The store of an audit: one SQLite file. Only one process at a time can write it; others can read it meanwhile.
#pragma once

#include <memory>
#include <string>

#include <SQLiteCpp/SQLiteCpp.h>

namespace owlint::audit {

/// An error in a store; the message is for people and names the store.
class StoreProblem : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Store {
 public:
  enum class For : uint8_t { kReading, kWriting };

  /// Opens a store for writing and updates its tables to this owlint; a second writer gets an error, or waits.
  /// Throws StoreProblem.
  static Store open(const std::string& path, For use, bool wait = false);

  SQLite::Database& db() { return *db_; }
  const std::string& path() const { return path_; }

  /// The number of the last complete run; 0 if there is none.
  int64_t last_complete();

 private:
  /// A lock on a store while it is written; the system releases it when the process ends, however it ends.
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
  std::unique_ptr<Hold> hold_;  // before the database: it is released after the database is closed
  std::unique_ptr<SQLite::Database> db_;
};

/// The bytes of a column.
std::string blob_of(const SQLite::Column& column);

/// The message for people about an SQLite error in this store.
std::string words_of(const SQLite::Exception& problem, const std::string& path);

}  // namespace owlint::audit
