// `owlint check`: reads, lints in parallel, reports in the order of the paths.
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

#include "analyzer/cli/commands.h"
#include "analyzer/cli/run.h"
#include "analyzer/cli/walk.h"
#include "analyzer/report/report.h"
#include "analyzer/text/parallel.h"

namespace owlint::cli {
namespace {

bool use_color(const CommandLine& line) {
  if (line.color != "auto") return line.color == "always";
  const char* no_color = std::getenv("NO_COLOR");
  return line.output.empty() && (no_color == nullptr || *no_color == '\0') && ::isatty(STDOUT_FILENO) != 0;
}

std::shared_ptr<const Source> read(const std::string& path, const CommandLine& line, std::string* error) {
  if (path != "-") return Source::map(path, error);
  std::string bytes{std::istreambuf_iterator<char>(std::cin), {}};
  return Source::own(line.stdin_filename, std::move(bytes));
}

}  // namespace

int check_command(const CommandLine& line) {
  Severity fail_on{};
  severity_from_text(line.fail_on, &fail_on);
  const Walk found = walk(line.paths);
  int status = kClean;
  for (const std::string& problem : found.problems) {
    complain(problem);
    status = kUsage;
  }
  for (const std::string& folder : found.empty) complain("no programs in " + folder + " (*.ngc *.nc *.tap *.cnc *.gcode)");

  Configuration configuration(line);
  std::vector<Settings> settings(found.files.size());
  std::string last_error;
  std::vector<bool> usable(found.files.size());
  for (size_t i = 0; i < found.files.size(); ++i) {
    std::string error;
    const std::string& path = found.files[i] == "-" ? line.stdin_filename : found.files[i];
    usable[i] = configuration.settings_for(path, &settings[i], &error);
    if (usable[i]) continue;
    status = kUsage;
    if (error != last_error) complain(error);  // once, not for every file below it
    last_error = error;
  }

  std::vector<const Settings*> wanted;
  for (size_t i = 0; i < found.files.size(); ++i) wanted.push_back(usable[i] ? &settings[i] : nullptr);
  use_cores(line.jobs);
  Library library;
  const auto load = [&line](const std::string& path, std::string* error) { return read(path, line, error); };
  const RunResult result = run_checks(found.files, wanted, load, library);
  const std::vector<FileReport>& reports = result.reports;
  for (size_t i = 0; i < found.files.size(); ++i) {
    if (result.errors[i].empty()) continue;
    complain("cannot read " + found.files[i] + ": " + result.errors[i]);
    status = kUsage;
  }
  if (!line.quiet) {
    constexpr size_t kMaxNotes = 4;
    const std::vector<std::string>& notes = configuration.notes();
    for (size_t i = 0; i < std::min(notes.size(), kMaxNotes); ++i) complain(notes[i]);
    if (notes.size() > kMaxNotes) complain(std::to_string(notes.size() - kMaxNotes) + " more notes like these");
    for (const std::string& note : result.notes) complain(note);
  }

  std::ofstream file;
  if (!line.output.empty()) {
    file.open(line.output, std::ios::binary | std::ios::trunc);
    if (!file) {
      complain("cannot write " + line.output);
      return kUsage;
    }
  }
  const bool color = use_color(line);
  std::ostream& out = line.output.empty() ? std::cout : file;
  if (line.format == "json") {
    write_json(out, reports);
  } else {
    for (const FileReport& report : reports) {
      if (line.format == "jsonl") {
        write_jsonl(out, report);
      } else {
        write_text(out, report, color);
      }
    }
  }
  out.flush();
  if (!out) {
    complain("cannot write the report");
    return kUsage;
  }
  if (line.statistics) write_statistics(std::cerr, reports, library);
  const Summary summary = summarize(reports);
  if (line.format == "text" && !line.quiet && summary.files > 0) std::cerr << summary_text(summary) << '\n';
  if (status != kClean) return status;
  for (const FileReport& report : reports) {
    for (const Finding& finding : report.findings) {
      if (finding.severity >= fail_on) return kFindings;
    }
  }
  return kClean;
}

}  // namespace owlint::cli
