// What changes from run to run: a row says since which run something is so, and until which it was. What is the same in a
// later run is not written again.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/audit/checking.h"
#include "analyzer/audit/store.h"

namespace owlint::audit {

/// How many findings a run has, and how many of them the run before had not, and the other way round.
struct Changes {
  size_t fresh = 0;
  size_t gone = 0;
};

/// Writes what the programs are in this run, and which of the former ones are no longer there.
void write_contents(Store& store, int64_t run, const std::vector<Item>& items);

/// Writes the findings of this run. One is the same as before where file and fingerprint are; it may have moved to another
/// line, or with its program to another folder.
Changes write_findings(Store& store, int64_t run, const std::vector<FileReport>& reports);

/// A finding as it stands in the store.
struct StoredFinding {
  int64_t id = 0;
  std::string path;
  std::string fingerprint;
};

/// Which findings run `b` has that run `a` has not, and the other way round.
struct Difference {
  std::vector<StoredFinding> fresh;
  std::vector<StoredFinding> gone;
};
Difference difference(Store& a, int64_t run_a, Store& b, int64_t run_b);

}  // namespace owlint::audit
