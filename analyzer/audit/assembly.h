// The beginning and the end of a run in the store: its row, and the state after it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "analyzer/audit/audit.h"
#include "analyzer/audit/checking.h"
#include "analyzer/audit/store.h"

namespace owlint::audit {

/// What a run should do.
struct Asked {
  std::string options;  ///< JSON, see options.h
  std::string roots;    ///< JSON
  std::string shard;
  std::string tool;
};

/// Writes the row of a run that begins; runs that were killed are marked as interrupted.
void begin_run(Store& store, const Asked& asked, Outcome& outcome);
/// `state`: complete, interrupted.
void end_run(Store& store, const Outcome& outcome, const char* state);

/// Combines what is known about each program, and writes what has changed since the run before. `machines`: records of
/// findings in INIs.
void assemble(Store& store, std::vector<Item>& items, const std::set<std::string>& machines, Outcome& outcome);
/// The run has the same results as the run before.
void take_over(Store& store, Outcome& outcome);

std::set<std::string> machine_records(Store& store);

}  // namespace owlint::audit
