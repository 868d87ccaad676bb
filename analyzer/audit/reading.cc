#include "analyzer/audit/reading.h"

#include <algorithm>
#include <charconv>
#include <map>

#include "analyzer/audit/record.h"

namespace owlint::audit {
namespace {

size_t number(const SQLite::Column& column) { return static_cast<size_t>(column.getInt64()); }

std::optional<int64_t> integer(std::string_view text) {
  int64_t value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// One report a file, from records of one finding each.
std::vector<FileReport> joined(Records& records) {
  std::vector<FileReport> out;
  for (size_t i = 0; i < records.size(); ++i) {
    for (FileReport& report : records.reports(i)) {
      if (out.empty() || out.back().source->path() != report.source->path()) {
        out.push_back(std::move(report));
      } else {
        std::ranges::move(report.findings, std::back_inserter(out.back().findings));
      }
    }
  }
  return out;
}

}  // namespace

std::vector<RunRow> runs_of(Store& store) {
  std::vector<RunRow> runs;
  SQLite::Statement all(store.db(),
                        "SELECT id, started, state, version, options, roots, shard, seconds, files, analysed, errors, "
                        "warnings, infos, new, gone FROM run ORDER BY id");
  while (all.executeStep()) {
    RunRow& run = runs.emplace_back();
    run.id = all.getColumn(0).getInt64();
    int at = 1;
    for (std::string* text : {&run.started, &run.state, &run.version, &run.options, &run.roots, &run.shard})
      *text = all.getColumn(at++).getString();
    run.seconds = all.getColumn(at++).getDouble();
    for (size_t* count : {&run.files, &run.analysed, &run.errors, &run.warnings, &run.infos, &run.fresh, &run.gone})
      *count = number(all.getColumn(at++));
  }
  return runs;
}

std::optional<int64_t> find_run(Store& store, const std::string& text) {
  if (text.starts_with("last")) {
    int64_t back = 0;
    if (text.size() > 4) {
      const auto given = text[4] == '-' ? integer(std::string_view(text).substr(5)) : std::nullopt;
      if (!given || *given < 0) return std::nullopt;
      back = *given;
    }
    SQLite::Statement query(store.db(),
                            "SELECT id FROM run WHERE state = 'complete' ORDER BY id DESC LIMIT 1 OFFSET ?");
    query.bind(1, back);
    if (query.executeStep()) return query.getColumn(0).getInt64();
    return std::nullopt;
  }
  const auto id = integer(text);
  if (!id) return std::nullopt;
  SQLite::Statement query(store.db(), "SELECT id FROM run WHERE id = ? AND state = 'complete'");
  query.bind(1, *id);
  if (query.executeStep()) return *id;
  return std::nullopt;
}

int64_t run_before(Store& store, int64_t run) {
  SQLite::Statement query(store.db(), "SELECT coalesce(max(id), 0) FROM run WHERE state = 'complete' AND id < ?");
  query.bind(1, run);
  query.executeStep();
  return query.getColumn(0).getInt64();
}

std::vector<ProgramRow> programs_of(Store& store, int64_t run) {
  std::vector<ProgramRow> programs;
  SQLite::Statement all(
      store.db(),
      "SELECT path, content.hash, bytes, lines, problem FROM content JOIN file ON file.id = content.file "
      "WHERE since <= ?1 AND (until IS NULL OR until > ?1) ORDER BY path");
  all.bind(1, run);
  while (all.executeStep()) {
    programs.push_back({all.getColumn(0).getString(), all.getColumn(1).getString(), number(all.getColumn(2)),
                        static_cast<uint32_t>(all.getColumn(3).getInt64()), all.getColumn(4).getString()});
  }
  return programs;
}

std::vector<FileReport> reports_of(Store& store, int64_t run, bool all) {
  Records records;
  SQLite::Statement query(store.db(),
                          "SELECT record FROM finding JOIN file ON file.id = finding.file WHERE since <= ?1 AND (until "
                          "IS NULL OR until > ?1) "
                          "ORDER BY path, line, \"column\", code, finding.id");
  query.bind(1, run);
  while (query.executeStep()) records.add(blob_of(query.getColumn(0)));
  std::vector<FileReport> reports = joined(records);
  if (!all) return reports;
  std::map<std::string, bool> reported;
  for (const FileReport& report : reports) reported.emplace(report.source->path(), true);
  for (const ProgramRow& program : programs_of(store, run)) {
    if (program.problem.empty() && !reported.contains(program.path))
      reports.push_back({Source::excerpt(program.path, {}, program.lines), {}, {}});
  }
  std::ranges::stable_sort(reports, {},
                           [](const FileReport& report) -> const std::string& { return report.source->path(); });
  return reports;
}

std::vector<FileReport> reports_of(Store& store, const std::vector<int64_t>& findings) {
  Records records;
  SQLite::Statement query(store.db(), "SELECT record FROM finding WHERE id = ?");
  for (const int64_t id : findings) {
    query.bind(1, id);
    if (query.executeStep()) records.add(blob_of(query.getColumn(0)));
    query.reset();
  }
  return joined(records);
}

}  // namespace owlint::audit
