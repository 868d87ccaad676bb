#include "analyzer/audit/checking.h"

#include <chrono>
#include <mutex>

#include "analyzer/audit/hashes.h"
#include "analyzer/audit/record.h"
#include "analyzer/text/files.h"
#include "analyzer/text/parallel.h"

namespace owlint::audit {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

int64_t file_number(SQLite::Database& db, const std::string& key) {
  SQLite::Statement find(db, "SELECT id FROM file WHERE path = ?");
  find.bind(1, key);
  if (find.executeStep()) return find.getColumn(0).getInt64();
  SQLite::Statement add(db, "INSERT INTO file (path, id) SELECT ?, coalesce(max(id), 0) + 1 FROM file RETURNING id");
  add.bind(1, key);
  add.executeStep();
  return add.getColumn(0).getInt64();
}

std::string Checking::bytes_of(const Source& source) {
  {
    const std::lock_guard lock(hashing_);
    if (const auto known = hashes_.find(source.path()); known != hashes_.end()) return known->second;
  }
  std::string hash = hash_of(source.bytes());
  const std::lock_guard lock(hashing_);
  return hashes_.emplace(source.path(), std::move(hash)).first->second;
}

Checking::Done Checking::check(Item& item) {
  Done done;
  done.item = &item;
  const auto start = Clock::now();
  const auto source = disk().read(item.key, &item.problem);
  if (source == nullptr) {
    item.hash.clear();
    return done;
  }
  checking::Settings settings = *item.settings;
  settings.options.notes_inputs = true;
  const checking::Checked checked = checking::check_file(source, settings, library_, item.by_machine);
  item.hash = hash_of(source->bytes());
  done.record = record_of(checked);
  const auto hash = [this](const Source& called) { return bytes_of(called); };
  done.facts = facts_of(checked.report.inputs, hash);
  if (checked.as_sub) std::ranges::move(facts_of(checked.as_sub->inputs, hash), std::back_inserter(done.facts));
  done.bytes = source->bytes().size();
  done.lines = source->line_count();
  done.seconds = seconds_since(start);
  return done;
}

void Checking::put_away(std::vector<Done>& batch) {
  SQLite::Database& db = store_.db();
  SQLite::Transaction transaction(db, SQLite::TransactionBehavior::IMMEDIATE);
  SQLite::Statement file(db, "UPDATE file SET stamp = ?, hash = ?, settings = ?, machine = ? WHERE path = ?");
  SQLite::Statement analysis(
      db, "INSERT OR REPLACE INTO analysis (file, run, seconds, bytes, lines, record) VALUES (?, ?, ?, ?, ?, ?)");
  SQLite::Statement unreadable(db, "DELETE FROM analysis WHERE file = ?");
  for (Done& done : batch) {
    Item& item = *done.item;
    if (item.file == 0) item.file = file_number(db, item.key);
    file.bind(1, static_cast<int64_t>(item.stamp));
    file.bind(2, item.hash);
    file.bind(3, item.settings_id);
    file.bind(4, item.by_machine ? 1 : 0);
    file.bind(5, item.key);
    file.exec();
    file.reset();
    facts_.rest(item.file, done.facts);
    if (done.record.empty()) {
      unreadable.bind(1, item.file);
      unreadable.exec();
      unreadable.reset();
      continue;
    }
    analysis.bind(1, item.file);
    analysis.bind(2, run_);
    analysis.bind(3, done.seconds);
    analysis.bind(4, static_cast<int64_t>(done.bytes));
    analysis.bind(5, static_cast<int64_t>(done.lines));
    analysis.bind(6, done.record.data(), static_cast<int>(done.record.size()));
    analysis.exec();
    analysis.reset();
  }
  transaction.commit();
  batch.clear();
}

size_t Checking::run(std::vector<Item>& items, const std::function<void(size_t done, size_t total)>& progress,
                     const std::atomic<bool>* stop) {
  constexpr size_t kBatch = 256;
  constexpr double kLongest = 0.05;  // seconds that something finished waits to be stored
  std::vector<Item*> todo;
  for (Item& item : items) {
    if (item.analyse) todo.push_back(&item);
  }
  std::mutex writing;
  std::vector<Done> batch;
  size_t count = 0;
  auto stored = Clock::now();
  for_each(todo.size(), [&](size_t i) {
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) return;
    Done done = check(*todo[i]);
    const std::lock_guard lock(writing);
    batch.push_back(std::move(done));
    ++count;
    if (batch.size() >= kBatch || seconds_since(stored) >= kLongest) {
      put_away(batch);
      stored = Clock::now();
    }
    if (progress) progress(count, todo.size());
  });
  if (!batch.empty()) put_away(batch);
  return count;
}

}  // namespace owlint::audit
