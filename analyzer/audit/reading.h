// Reads a store, for the commands that show it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyzer/audit/store.h"
#include "analyzer/findings/file_report.h"

namespace owlint::audit {

struct RunRow {
  int64_t id = 0;
  std::string started, state, version, options, roots, shard;
  double seconds = 0;
  size_t files = 0, analysed = 0, errors = 0, warnings = 0, infos = 0, fresh = 0, gone = 0;
};

struct ProgramRow {
  std::string path;
  std::string hash;
  uint64_t bytes = 0;
  uint32_t lines = 0;
  std::string problem;
};

/// All runs, the oldest first.
std::vector<RunRow> runs_of(Store& store);
/// The complete run for `7`, `last`, `last-1`, or nothing.
std::optional<int64_t> find_run(Store& store, const std::string& text);
/// The complete run before another one; 0 if there is none.
int64_t run_before(Store& store, int64_t run);
/// The programs of a run, by path.
std::vector<ProgramRow> programs_of(Store& store, int64_t run);
/// The findings of a run, by file and position; with `all` also the files that have none.
std::vector<FileReport> reports_of(Store& store, int64_t run, bool all);
/// Single findings, in their order.
std::vector<FileReport> reports_of(Store& store, const std::vector<int64_t>& findings);

}  // namespace owlint::audit
