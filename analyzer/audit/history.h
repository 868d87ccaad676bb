// What changes from run to run: a row says from which run until which run something was true. What stays the same is not
// written again.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/audit/checking.h"
#include "analyzer/audit/store.h"

namespace owlint::audit {

/// How many findings a run has, how many are new, and how many of the run before are gone.
struct Changes {
  size_t fresh = 0;
  size_t gone = 0;
};

/// Writes the programs of this run, and which earlier ones no longer exist.
void write_contents(Store& store, int64_t run, const std::vector<Item>& items);

/// Writes the findings of this run. A finding is the same as before if its file and fingerprint are; it may have moved to
/// another line, or with its program to another folder.
Changes write_findings(Store& store, int64_t run, const std::vector<FileReport>& reports);

/// A finding in the store.
struct StoredFinding {
  int64_t id = 0;
  std::string path;
  std::string fingerprint;
};

/// The findings that only run `b` has, and those that only run `a` has.
struct Difference {
  std::vector<StoredFinding> fresh;
  std::vector<StoredFinding> gone;
};
Difference difference(Store& a, int64_t run_a, Store& b, int64_t run_b);

}  // namespace owlint::audit
