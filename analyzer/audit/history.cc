#include "analyzer/audit/history.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "analyzer/audit/record.h"
#include "analyzer/findings/identity.h"
#include "analyzer/text/paths.h"
#include "analyzer/text/printable.h"

namespace owlint::audit {
namespace {

struct Row {
  int64_t id = 0;  // 0: new
  int64_t file = 0;
  int64_t first = 0;
  std::string fingerprint;
};

/// Pairs rows that left with rows that came: in the same file first, then anywhere. What stays alone is gone or new.
class Pairing {
 public:
  void left(const Row& row) {
    in_file_[{row.file, row.fingerprint}].push_back(row);
    ++lefts_;
  }

  /// For each row that came, the run in which it was first found; `run` where nothing left is the same finding.
  Changes settle(std::vector<Row*>& came, int64_t run) {
    std::vector<Row*> alone;
    for (Row* row : came) {
      if (!take(in_file_, std::pair(row->file, row->fingerprint), row)) alone.push_back(row);
    }
    std::unordered_map<std::string, std::vector<Row>> anywhere;
    for (auto& [key, rows] : in_file_) {
      for (Row& row : rows) anywhere[key.second].push_back(std::move(row));
    }
    Changes changes;
    for (Row* row : alone) {
      if (take(anywhere, row->fingerprint, row)) continue;
      row->first = run;
      ++changes.fresh;
    }
    changes.gone = lefts_;
    return changes;
  }

 private:
  template <typename Map, typename Key>
  bool take(Map& from, const Key& key, Row* row) {
    const auto at = from.find(key);
    if (at == from.end() || at->second.empty()) return false;
    row->first = at->second.back().first;
    at->second.pop_back();
    --lefts_;
    return true;
  }

  std::map<std::pair<int64_t, std::string>, std::vector<Row>> in_file_;
  size_t lefts_ = 0;
};

void bind_place(SQLite::Statement& insert, int at, const Source& source, Span span) {
  const Position begin = source.position(span.begin);
  const Position end = source.position(span.end);
  insert.bind(at, begin.line);
  insert.bind(at + 1, begin.column);
  insert.bind(at + 2, end.line);
  insert.bind(at + 3, end.column);
}

void insert_finding(SQLite::Statement& insert, const Row& row, int64_t run, const Source& source, const Finding& f,
                    const std::string& record) {
  insert.bind(1, row.file);
  insert.bind(2, run);
  insert.bind(3, row.first);
  insert.bind(4, std::string(f.code));
  insert.bind(5, std::string(f.rule));
  insert.bind(6, std::string(severity_text(f.severity)));
  bind_place(insert, 7, source, f.span);
  insert.bind(11, printable(f.message));
  insert.bind(12, printable(f.help));
  insert.bind(13, printable(f.interpreter));
  insert.bind(14, f.stops ? 1 : 0);
  insert.bind(15, std::string(reach_text(f.reach)));
  insert.bind(16, printable(f.scope));
  insert.bind(17, row.fingerprint);
  insert.bind(18, record.data(), static_cast<int>(record.size()));
  insert.exec();
  insert.reset();
}

void close_row(SQLite::Statement& close, int64_t run, int64_t id) {
  close.bind(1, run);
  close.bind(2, id);
  close.exec();
  close.reset();
}

}  // namespace

void write_contents(Store& store, int64_t run, const std::vector<Item>& items) {
  SQLite::Database& db = store.db();
  struct Old {
    std::string hash, problem;
    bool there = false;
  };
  std::unordered_map<int64_t, Old> known;
  SQLite::Statement all(db, "SELECT file, hash, problem FROM content WHERE until IS NULL");
  while (all.executeStep())
    known.emplace(all.getColumn(0).getInt64(), Old{all.getColumn(1).getString(), all.getColumn(2).getString(), false});
  SQLite::Statement close(db, "UPDATE content SET until = ? WHERE file = ? AND until IS NULL");
  SQLite::Statement add(db,
                        "INSERT INTO content (file, since, hash, bytes, lines, problem) SELECT ?1, ?2, ?3, "
                        "coalesce(max(bytes), 0), coalesce(max(lines), 0), ?4 FROM analysis WHERE file = ?1");
  SQLite::Statement present(db, "UPDATE file SET present = ? WHERE path = ?");
  SQLite::Statement absent(db, "UPDATE file SET present = 0, hash = '', stamp = 0 WHERE id = ?");
  SQLite::Statement unknown(db, "DELETE FROM analysis WHERE file = ?");
  SQLite::Statement rests(db, "DELETE FROM rests_on WHERE file = ?");
  for (const Item& item : items) {
    const auto old = known.find(item.file);
    if (old != known.end()) {
      old->second.there = true;
      if (old->second.hash == item.hash && old->second.problem == item.problem) continue;
      close_row(close, run, item.file);
    }
    add.bind(1, item.file);
    add.bind(2, run);
    add.bind(3, item.hash);
    add.bind(4, item.problem);
    add.exec();
    add.reset();
    present.bind(1, 1);
    present.bind(2, item.key);
    present.exec();
    present.reset();
  }
  for (const auto& [file, old] : known) {
    if (old.there) continue;
    close_row(close, run, file);
    for (SQLite::Statement* statement : {&absent, &unknown, &rests}) {
      statement->bind(1, file);
      statement->exec();
      statement->reset();
    }
  }
}

Changes write_findings(Store& store, int64_t run, const std::vector<FileReport>& reports) {
  SQLite::Database& db = store.db();
  std::multimap<std::pair<int64_t, std::string>, std::pair<Row, std::string>>
      known;  // by file and fingerprint: with the record
  SQLite::Statement all(db, "SELECT id, file, first, fingerprint, record FROM finding WHERE until IS NULL");
  while (all.executeStep()) {
    Row row{all.getColumn(0).getInt64(), all.getColumn(1).getInt64(), all.getColumn(2).getInt64(),
            all.getColumn(3).getString()};
    known.emplace(std::pair(row.file, row.fingerprint), std::pair(row, blob_of(all.getColumn(4))));
  }
  struct Came {
    Row row;
    const Source* source;
    const Finding* finding;
    std::string record;
  };
  std::vector<Came> came;
  for (const FileReport& report : reports) {
    if (report.findings.empty()) continue;
    const int64_t file = file_number(db, file_key(report.source->path()));
    const std::vector<std::string> prints = fingerprints(*report.source, report.findings);
    for (size_t i = 0; i < prints.size(); ++i) {
      const Finding& finding = report.findings[i];
      std::string record = record_of(std::vector<FileReport>{{report.source, {finding}, {}}});
      const auto [from, to] = known.equal_range({file, prints[i]});
      const auto same = std::find_if(from, to, [&](const auto& entry) { return entry.second.second == record; });
      if (same != to) {
        known.erase(same);
      } else {
        came.push_back({{0, file, 0, prints[i]},
                        finding.source == nullptr ? report.source.get() : finding.source.get(),
                        &finding,
                        std::move(record)});
      }
    }
  }
  Pairing pairing;
  SQLite::Statement close(db, "UPDATE finding SET until = ? WHERE id = ?");
  for (const auto& [key, entry] : known) {
    pairing.left(entry.first);
    close_row(close, run, entry.first.id);
  }
  std::vector<Row*> rows;
  for (Came& one : came) rows.push_back(&one.row);
  const Changes changes = pairing.settle(rows, run);
  SQLite::Statement insert(db,
                           "INSERT INTO finding (file, since, first, code, rule, severity, line, \"column\", end_line, "
                           "end_column, message, help, interpreter, stops, reach, "
                           "scope, fingerprint, record) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const Came& one : came) insert_finding(insert, one.row, run, *one.source, *one.finding, one.record);
  return changes;
}

Difference difference(Store& a, int64_t run_a, Store& b, int64_t run_b) {
  const auto rows = [](Store& store, int64_t run) {
    std::vector<StoredFinding> all;
    SQLite::Statement query(
        store.db(),
        "SELECT finding.id, file.path, fingerprint FROM finding JOIN file ON file.id = finding.file "
        "WHERE since <= ?1 AND (until IS NULL OR until > ?1) ORDER BY file.path, line, \"column\", code, finding.id");
    query.bind(1, run);
    while (query.executeStep())
      all.push_back({query.getColumn(0).getInt64(), query.getColumn(1).getString(), query.getColumn(2).getString()});
    return all;
  };
  // Takes out of both what is the same by a key; the same file first, then the fingerprint alone.
  const auto pair_off = [](std::vector<StoredFinding>& left, std::vector<StoredFinding>& right, const auto& key) {
    std::map<std::string, size_t> counts;
    for (const StoredFinding& f : left) ++counts[key(f)];
    std::map<std::string, size_t> matched;
    std::erase_if(right, [&](const StoredFinding& f) {
      const auto at = counts.find(key(f));
      if (at == counts.end() || at->second == 0) return false;
      --at->second;
      ++matched[key(f)];
      return true;
    });
    std::erase_if(left, [&](const StoredFinding& f) {
      const auto at = matched.find(key(f));
      if (at == matched.end() || at->second == 0) return false;
      --at->second;
      return true;
    });
  };
  Difference out{rows(b, run_b), rows(a, run_a)};
  pair_off(out.gone, out.fresh, [](const StoredFinding& f) { return f.path + '\n' + f.fingerprint; });
  pair_off(out.gone, out.fresh, [](const StoredFinding& f) { return f.fingerprint; });
  return out;
}

}  // namespace owlint::audit
