// One run of an audit: finds the programs, analyses those that are not known from an earlier run, and writes the results to
// the store. Everything that people see is made from the store.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "analyzer/audit/store.h"
#include "analyzer/checking/settings.h"

namespace owlint::audit {

/// One part of a job that several machines share: the `index`th of `count`, from 1.
struct Shard {
  uint32_t index = 1;
  uint32_t count = 1;

  std::string text() const;
  /// Whether a file belongs to this part. Only its path decides, so that machines agree without asking each other.
  bool has(const std::string& path) const;
};

struct Job {
  const checking::CheckRequest& line;
  Shard shard;
  /// Called with the number of programs that are done, of `total` to analyse; `total` does not change.
  std::function<void(size_t done, size_t total)> progress;
  /// Set from outside to stop early; finished work is kept.
  const std::atomic<bool>* stop = nullptr;
};

struct Outcome {
  int64_t run = 0;       ///< 0: none was made, as there are only problems
  int64_t previous = 0;  ///< the last complete run before; 0 if there is none
  bool interrupted = false;
  bool unchanged = false;  ///< everything is as in the previous run
  size_t files = 0, analysed = 0, folders_without = 0;
  size_t errors = 0, warnings = 0, infos = 0, fresh = 0,
         gone = 0;  ///< findings; new and gone compared with the previous run
  double seconds = 0;
  std::vector<std::string> problems;  ///< files that cannot be read, and errors in the configuration
  std::vector<std::string> notes;
};

/// Throws StoreProblem and SQLite::Exception.
Outcome run_audit(const Job& job, Store& store);

}  // namespace owlint::audit
