#include "analyzer/audit/assembly.h"

#include <ctime>
#include <unordered_map>

#include <fmt/chrono.h>
#include <nlohmann/json.hpp>

#include "analyzer/audit/history.h"
#include "analyzer/audit/record.h"
#include "analyzer/checking/groups.h"
#include "analyzer/report/report.h"
#include "analyzer/text/files.h"

namespace owlint::audit {

void begin_run(Store& store, const Asked& asked, Outcome& outcome) {
  SQLite::Database& db = store.db();
  db.exec("UPDATE run SET state = 'interrupted' WHERE state = 'running'");  // it was killed: nobody else has the store
  outcome.previous = store.last_complete();
  SQLite::Statement add(
      db,
      "INSERT INTO run (started, state, version, tool, options, roots, shard) VALUES (?, 'running', ?, ?, ?, ?, ?)");
  add.bind(1, fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
  add.bind(2, std::string(kToolVersion));
  add.bind(3, asked.tool);
  add.bind(4, asked.options);
  add.bind(5, asked.roots);
  add.bind(6, asked.shard);
  add.exec();
  outcome.run = db.getLastInsertRowid();
}

void end_run(Store& store, const Outcome& outcome, const char* state) {
  SQLite::Statement done(store.db(),
                         "UPDATE run SET state = ?, seconds = ?, files = ?, analysed = ?, errors = ?, warnings = ?, "
                         "infos = ?, new = ?, gone = ? WHERE id = ?");
  done.bind(1, state);
  done.bind(2, outcome.seconds);
  int at = 3;
  for (const size_t number :
       {outcome.files, outcome.analysed, outcome.errors, outcome.warnings, outcome.infos, outcome.fresh, outcome.gone})
    done.bind(at++, static_cast<int64_t>(number));
  done.bind(at, outcome.run);
  done.exec();
}

/// The paths that a run was asked to audit.
std::vector<std::string> roots_of(Store& store, int64_t run) {
  SQLite::Statement roots(store.db(), "SELECT roots FROM run WHERE id = ?");
  roots.bind(1, run);
  roots.executeStep();
  return nlohmann::json::parse(roots.getColumn(0).getString()).get<std::vector<std::string>>();
}

std::set<std::string> machine_records(Store& store) {
  std::set<std::string> records;
  SQLite::Statement all(store.db(), "SELECT record FROM machine");
  while (all.executeStep()) records.insert(blob_of(all.getColumn(0)));
  return records;
}

void take_over(Store& store, Outcome& outcome) {
  SQLite::Statement same(store.db(), "SELECT errors, warnings, infos FROM run WHERE id = ?");
  same.bind(1, outcome.previous);
  same.executeStep();
  outcome.errors = static_cast<size_t>(same.getColumn(0).getInt64());
  outcome.warnings = static_cast<size_t>(same.getColumn(1).getInt64());
  outcome.infos = static_cast<size_t>(same.getColumn(2).getInt64());
  outcome.unchanged = true;
}

void assemble(Store& store, std::vector<Item>& items, const std::set<std::string>& machines, Outcome& outcome) {
  SQLite::Database& db = store.db();
  std::unordered_map<int64_t, size_t> place;
  std::vector<std::string> files;
  for (Item& item : items) {
    if (item.file == 0) item.file = file_number(db, item.key);
    place.emplace(item.file, files.size());
    files.push_back(item.key);
  }
  Records records;
  std::vector<size_t> order;  // of records: whose they are
  SQLite::Statement all(db, "SELECT file, record FROM analysis");
  while (all.executeStep()) {
    const auto at = place.find(all.getColumn(0).getInt64());
    if (at == place.end() || !items[at->second].problem.empty()) continue;
    order.push_back(at->second);
    records.add(blob_of(all.getColumn(1)));
  }
  for (const std::string& machine : machines) records.add(machine);
  std::vector<checking::Checked> checked(files.size());
  for (size_t i = 0; i < order.size(); ++i) checked[order[i]] = records.checked(i);
  std::vector<FileReport> complaints;
  for (size_t i = order.size(); i < records.size(); ++i)
    std::ranges::move(records.reports(i), std::back_inserter(complaints));

  checking::RunResult result = checking::put_together(files, std::move(checked), std::move(complaints), {});
  checking::fold_groups(result.reports, {files, checking::folders_of(disk(), roots_of(store, outcome.run))});
  write_contents(store, outcome.run, items);
  const Changes changes = write_findings(store, outcome.run, result.reports);
  if (outcome.previous != 0) {  // in the first run nothing is new
    outcome.fresh = changes.fresh;
    outcome.gone = changes.gone;
  }
  const Totals totals = totals_of(result.reports);
  outcome.errors = totals.errors;
  outcome.warnings = totals.warnings;
  outcome.infos = totals.infos;
  outcome.notes.insert(outcome.notes.end(), result.notes.begin(), result.notes.end());
  Facts::sweep(db);
  db.exec("DELETE FROM machine");
  SQLite::Statement keep(db, "INSERT INTO machine (record) VALUES (?)");
  for (const std::string& machine : machines) {
    keep.bind(1, machine.data(), static_cast<int>(machine.size()));
    keep.exec();
    keep.reset();
  }
}

}  // namespace owlint::audit
