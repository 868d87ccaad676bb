// `--fix`: fixes programs in rounds until nothing is left to fix, in memory; files are written by the caller.
#pragma once

#include <map>

#include "analyzer/checking/run.h"

namespace owlint::checking {

/// One file that was fixed.
struct FixedFile {
  std::string path;
  std::shared_ptr<const Source> before;
  std::string text;
  size_t made = 0;  ///< findings that were fixed
};

struct FixResult {
  RunResult run;  ///< the findings in the fixed texts
  std::vector<FixedFile> fixed;
  std::vector<std::string> unfinished;  ///< files in which fixing did not end; they are left unchanged
};

/// Like run_checks(), but makes the fixes of all findings: the safe ones, or with `unsafe` all. Programs that call a fixed
/// file are checked with the fixed text. `read`: what the files are read from.
FixResult run_and_fix(const Files& read, const std::vector<std::string>& files,
                      const std::vector<const Settings*>& settings, bool unsafe);

}  // namespace owlint::checking
