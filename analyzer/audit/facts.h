// What analyses depend on besides a program's own bytes: the answers of search paths, and the bytes of other files. Each
// fact is stored once, even if many programs depend on it. A run checks the facts again, and analyses the programs for
// which one of them is no longer true.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "analyzer/audit/store.h"
#include "rules/driver/lint.h"

namespace owlint::audit {

struct Fact {
  static constexpr int kBytes = 4;  ///< all others are an Answer::Question
  int kind = kBytes;
  std::string subject;  ///< the searched folders, one on each line, then `//` and the tree; or a file's key
  std::string name;
  std::string answer;
  uint64_t stamp = 0;  ///< of a file
};

/// What a report depends on. `bytes_of`: the hash of a file that was read.
std::vector<Fact> facts_of(const Inputs& inputs, const std::function<std::string(const Source&)>& bytes_of);

class Facts {
 public:
  explicit Facts(SQLite::Database& db);

  /// The numbers of the facts that are no longer true. `walked`: the hash of a file if it is already known, else empty.
  std::vector<int64_t> untrue(const std::function<std::string(const std::string& key)>& walked);
  /// Stores that a file depends on these facts, and on nothing else.
  void rest(int64_t file, const std::vector<Fact>& facts);
  /// Forgets facts that nothing depends on.
  static void sweep(SQLite::Database& db);

 private:
  struct Stored {
    int64_t id;
    Fact fact;
  };
  bool holds(const Fact& fact, const SearchPath* path, const std::function<std::string(const std::string&)>& walked,
             uint64_t* stamp) const;
  static std::string key_of(const Fact& fact);

  SQLite::Database& db_;
  SQLite::Statement insert_, forget_, rest_;
  std::vector<Stored> stored_;
  std::unordered_map<std::string, int64_t> ids_;
};

}  // namespace owlint::audit
