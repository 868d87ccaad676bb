// The result of a check for one file: what front ends and formats are given.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "analyzer/findings/finding.h"

namespace owlint {

/// How much work the flow analysis of a file was, with the files that it calls.
struct Effort {
  uint64_t steps = 0;     ///< states processed
  uint64_t merges = 0;    ///< states that were joined with loss of precision
  uint64_t recalled = 0;  ///< calls that were known before
};

/// The result for one file; findings are ordered by position, behind the one that the file is for another
/// controller.
struct FileReport {
  std::shared_ptr<const Source> source;
  std::vector<Finding> findings;
  Effort effort;
};

}  // namespace owlint
