// The formats of `owlint check --format`: one list for the option, its help and the dispatch. Each format is a file of its
// own, and none of them decides anything.
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/report/report.h"

namespace owlint {

/// How a report looks.
struct ReportStyle {
  bool color = false;
  std::string root;  ///< the folder that is worked in: paths below it are shown without it
  size_t width = 0;  ///< columns of the reader's terminal; 0: not a terminal
};

using Reports = std::vector<FileReport>;

struct Format {
  std::string_view name;
  std::string_view what;  ///< for people
  bool for_people;        ///< with a summary line on standard error
  void (*write)(std::ostream& out, const Reports& files, const ReportStyle& style);
};

/// All formats, the default first.
const std::vector<Format>& formats();
const Format* find_format(std::string_view name);

/// One file for people: position, message, the line with carets, related places, what LinuxCNC says, how to fix it.
void write_text(std::ostream& out, const FileReport& file, const ReportStyle& style);
void write_text_report(std::ostream& out, const Reports& files, const ReportStyle& style);
void write_grouped(std::ostream& out, const Reports& files, const ReportStyle& style);
void write_gcc(std::ostream& out, const Reports& files, const ReportStyle& style);
void write_sarif(std::ostream& out, const Reports& files, const ReportStyle& style);
void write_github(std::ostream& out, const Reports& files, const ReportStyle& style);
void write_gitlab(std::ostream& out, const Reports& files, const ReportStyle& style);
void write_checkstyle(std::ostream& out, const Reports& files, const ReportStyle& style);
void write_junit(std::ostream& out, const Reports& files, const ReportStyle& style);
void write_csv(std::ostream& out, const Reports& files, const ReportStyle& style);
void write_rdjson(std::ostream& out, const Reports& files, const ReportStyle& style);

// --- used by several formats ---

/// The path relative to the root, if it is below; printable.
std::string shown_path(const Source& source, const ReportStyle& style);
/// The same for JSON, which can hold any name: nothing is replaced.
std::string json_path(const Source& source, const ReportStyle& style);
/// The message with what LinuxCNC says and how to fix it, each on a line of its own or after `separator`.
std::string whole_message(const Finding& finding, std::string_view separator = "\n");
/// The related lines of a finding, and if no run reaches it, the line that keeps every run away.
std::vector<Related> related_lines(const Finding& finding);
/// The file that a finding is in.
const Source& source_of(const FileReport& file, const Finding& finding);

}  // namespace owlint
