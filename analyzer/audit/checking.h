// Analyses programs on all cores and stores each result at once: finished work is never lost, whatever happens to the
// rest.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "analyzer/audit/facts.h"
#include "analyzer/audit/store.h"
#include "analyzer/checking/run.h"
#include "analyzer/checking/walk.h"
#include "analyzer/text/files.h"

namespace owlint::audit {

/// A program of this run.
struct Item {
  std::string key;  ///< its path, absolute
  uint64_t stamp = 0;
  int64_t file = 0;                                    ///< its number in the store; 0: new
  std::string hash;                                    ///< of its bytes, if known
  std::shared_ptr<const checking::Settings> settings;  ///< null: they are wrong, and the program is not checked
  int64_t settings_id = 0;
  bool by_machine = false;
  bool analyse = false;
  std::string problem;  ///< why it cannot be read
};

class Checking {
 public:
  Checking(Store& store, Facts& facts, int64_t run) : store_(store), facts_(facts), run_(run) {}

  /// Analyses the items that need it; returns how many were done before `stop` was set.
  size_t run(std::vector<Item>& items, const std::function<void(size_t done, size_t total)>& progress,
             const std::atomic<bool>* stop);

  Library& library() { return library_; }

 private:
  struct Done {
    Item* item = nullptr;
    std::string record;
    std::vector<Fact> facts;
    double seconds = 0;
    uint64_t bytes = 0;
    uint32_t lines = 0;
  };
  Done check(Item& item);
  std::string bytes_of(const Source& source);
  void put_away(std::vector<Done>& batch);

  Store& store_;
  Facts& facts_;
  int64_t run_;
  Library library_{disk()};
  std::mutex hashing_;
  std::map<std::string, std::string> hashes_;  // of called files
};

/// The number of a path in the store; adds the path if it has none.
int64_t file_number(SQLite::Database& db, const std::string& key);

}  // namespace owlint::audit
