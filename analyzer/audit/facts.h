// What analyses rest on besides a program's own bytes: what search paths answered, and what bytes other files have. Each
// is stored once, however many programs rest on it; a run asks them again, and analyses the programs anew for which one
// of them is no longer true.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "analyzer/audit/store.h"
#include "rules/lint.h"

namespace owlint::audit {

struct Fact {
  static constexpr int kBytes = 4;  ///< lower ones are an Answer::Question
  int kind = kBytes;
  std::string subject;  ///< the folders that are searched, one a line, then `//` and the tree; or a file's key
  std::string name;
  std::string answer;
  uint64_t stamp = 0;  ///< of a file
};

/// What a report rests on. `bytes_of`: the hash of a file that was read.
std::vector<Fact> facts_of(const Inputs& inputs, const std::function<std::string(const Source&)>& bytes_of);

class Facts {
 public:
  explicit Facts(SQLite::Database& db);

  /// The numbers of those that are not true any more. `walked`: the hash of a file where it is known already, else empty.
  std::vector<int64_t> untrue(const std::function<std::string(const std::string& key)>& walked);
  /// Stores that a file rests on these, and on nothing else.
  void rest(int64_t file, const std::vector<Fact>& facts);
  /// Forgets those that nothing rests on.
  static void sweep(SQLite::Database& db);

 private:
  struct Stored {
    int64_t id;
    Fact fact;
  };
  bool holds(const Fact& fact, const SearchPath* path, const std::function<std::string(const std::string&)>& walked, uint64_t* stamp) const;
  static std::string key_of(const Fact& fact);

  SQLite::Database& db_;
  SQLite::Statement insert_, forget_, rest_;
  std::vector<Stored> stored_;
  std::unordered_map<std::string, int64_t> ids_;
};

}  // namespace owlint::audit
