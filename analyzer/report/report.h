// Writes findings. Every format writes to a stream; nothing here decides anything.
#pragma once

#include <ostream>
#include <vector>

#include "analyzer/findings/file_report.h"
#include "analyzer/text/printable.h"

namespace owlint {

class Library;

inline constexpr std::string_view kToolName = "owlint";
inline constexpr std::string_view kToolVersion = OWLINT_VERSION;

struct Totals {
  size_t files = 0;
  size_t errors = 0;
  size_t warnings = 0;
  size_t infos = 0;
  size_t hidden = 0;  ///< known findings, which are not shown

  void count(const Finding& finding);
  size_t total() const { return errors + warnings + infos; }
};

Totals totals_of(const std::vector<FileReport>& files);

/// `2 errors, 1 warning in 3 files`.
std::string totals_text(const Totals& totals);

/// `owlint-report-1`, see share/owlint-report-1.schema.json.
void write_json(std::ostream& out, const std::vector<FileReport>& files);
/// One object for each finding, on a line of its own, with its `path`.
void write_jsonl(std::ostream& out, const FileReport& file);

/// The number of findings by rule, the largest first; how many files were parsed, and how often called.
void write_statistics(std::ostream& out, const std::vector<FileReport>& files, const Library& library);

}  // namespace owlint
