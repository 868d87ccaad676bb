#include "analyzer/audit/merge.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyzer/audit/assembly.h"
#include "analyzer/audit/facts.h"

namespace owlint::audit {
namespace {

/// What the last run of a store says of itself.
struct Part {
  Asked asked;
  size_t analysed = 0;
};

Part part_of(Store& store) {
  SQLite::Statement last(
      store.db(),
      "SELECT options, roots, shard, tool, analysed FROM run WHERE state = 'complete' ORDER BY id DESC LIMIT 1");
  if (!last.executeStep()) throw StoreProblem(fmt::format("the store {} has no complete run", store.path()));
  return {{last.getColumn(0).getString(), last.getColumn(1).getString(), last.getColumn(2).getString(),
           last.getColumn(3).getString()},
          static_cast<size_t>(last.getColumn(4).getInt64())};
}

/// Copies what a store knows of its programs.
class Importer {
 public:
  Importer(Store& from, Store& into, Facts& facts, int64_t run)
      : from_(from.db()), into_(into.db()), facts_(facts), run_(run) {}

  void import(std::vector<Item>& items) {
    read_settings();
    SQLite::Statement files(from_,
                            "SELECT path, id, stamp, file.hash, settings, machine, content.problem, seconds, "
                            "analysis.bytes, analysis.lines, record FROM file "
                            "JOIN content ON content.file = file.id AND content.until IS NULL LEFT JOIN analysis ON "
                            "analysis.file = file.id WHERE present = 1 ORDER BY path");
    SQLite::Statement put(into_, "UPDATE file SET stamp = ?, hash = ?, settings = ?, machine = ? WHERE id = ?");
    SQLite::Statement known(into_, "SELECT record FROM analysis WHERE file = ?");
    SQLite::Statement analysis(
        into_, "INSERT OR REPLACE INTO analysis (file, run, seconds, bytes, lines, record) VALUES (?, ?, ?, ?, ?, ?)");
    while (files.executeStep()) {
      Item item;
      item.key = files.getColumn(0).getString();
      item.file = file_number(into_, item.key);
      item.hash = files.getColumn(3).getString();
      item.problem = files.getColumn(6).getString();
      put.bind(1, files.getColumn(2).getInt64());
      put.bind(2, item.hash);
      put.bind(3, settings_[files.getColumn(4).getInt64()]);
      put.bind(4, files.getColumn(5).getInt());
      put.bind(5, item.file);
      put.exec();
      put.reset();
      if (!files.getColumn(10).isNull()) {
        const std::string record = blob_of(files.getColumn(10));
        known.bind(1, item.file);
        const bool same = known.executeStep() && blob_of(known.getColumn(0)) == record;
        known.reset();
        if (!same) {
          analysis.bind(1, item.file);
          analysis.bind(2, run_);
          analysis.bind(3, files.getColumn(7).getDouble());
          analysis.bind(4, files.getColumn(8).getInt64());
          analysis.bind(5, files.getColumn(9).getInt64());
          analysis.bind(6, record.data(), static_cast<int>(record.size()));
          analysis.exec();
          analysis.reset();
        }
      }
      facts_.rest(item.file, facts_for(files.getColumn(1).getInt64()));
      items.push_back(std::move(item));
    }
  }

 private:
  void read_settings() {
    SQLite::Statement all(from_, "SELECT id, hash FROM settings");
    SQLite::Statement add(
        into_, "INSERT INTO settings (hash) VALUES (?) ON CONFLICT (hash) DO UPDATE SET hash = hash RETURNING id");
    while (all.executeStep()) {
      add.bind(1, all.getColumn(1).getString());
      add.executeStep();
      settings_[all.getColumn(0).getInt64()] = add.getColumn(0).getInt64();
      add.reset();
    }
  }

  std::vector<Fact> facts_for(int64_t file) {
    std::vector<Fact> facts;
    SQLite::Statement query(from_,
                            "SELECT kind, subject, name, answer, stamp FROM fact JOIN rests_on ON rests_on.fact = "
                            "fact.id WHERE rests_on.file = ?");
    query.bind(1, file);
    while (query.executeStep()) {
      facts.push_back({query.getColumn(0).getInt(), query.getColumn(1).getString(), query.getColumn(2).getString(),
                       query.getColumn(3).getString(), static_cast<uint64_t>(query.getColumn(4).getInt64())});
    }
    return facts;
  }

  SQLite::Database& from_;
  SQLite::Database& into_;
  Facts& facts_;
  int64_t run_;
  std::map<int64_t, int64_t> settings_;
};

/// Throws where the parts are not all of one job.
void check_parts(const std::vector<Part>& parts, const std::vector<std::string>& stores) {
  std::set<std::string> shards;
  size_t count = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    const Asked& one = parts[i].asked;
    if (one.shard.empty())
      throw StoreProblem(fmt::format("the store {} is no shard's: its run had no --shard", stores[i]));
    if (one.tool != parts[0].asked.tool)
      throw StoreProblem(fmt::format("{} and {} were written by different builds of owlint", stores[0], stores[i]));
    if (one.options != parts[0].asked.options || one.roots != parts[0].asked.roots)
      throw StoreProblem(
          fmt::format("{} and {} are of different jobs: their paths or options differ", stores[0], stores[i]));
    if (!shards.insert(one.shard).second) throw StoreProblem(fmt::format("shard {} is there twice", one.shard));
    const size_t of = std::stoul(one.shard.substr(one.shard.find('/') + 1));
    if (count != 0 && of != count)
      throw StoreProblem(
          fmt::format("{} and {} are of different jobs: {} and {} shards", stores[0], stores[i], count, of));
    count = of;
  }
  std::vector<std::string> missing;
  for (size_t i = 1; i <= count; ++i) {
    const std::string shard = fmt::format("{}/{}", i, count);
    if (!shards.contains(shard)) missing.push_back(shard);
  }
  if (!missing.empty())
    throw StoreProblem(fmt::format("not all shards are there: {} missing", fmt::join(missing, ", ")));
}

}  // namespace

Outcome merge(Store& into, const std::vector<std::string>& stores) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<Store> shards;
  std::vector<Part> parts;
  for (const std::string& path : stores) {
    shards.push_back(Store::open(path, Store::For::kReading));
    parts.push_back(part_of(shards.back()));
  }
  check_parts(parts, stores);
  Outcome outcome;
  SQLite::Transaction transaction(into.db(), SQLite::TransactionBehavior::IMMEDIATE);
  Asked asked = parts[0].asked;
  asked.shard.clear();
  begin_run(into, asked, outcome);
  Facts facts(into.db());
  std::vector<Item> items;
  std::set<std::string> machines;
  for (size_t i = 0; i < shards.size(); ++i) {
    outcome.analysed += parts[i].analysed;
    Importer(shards[i], into, facts, outcome.run).import(items);
    machines.merge(machine_records(shards[i]));
  }
  std::ranges::sort(items, {}, &Item::key);
  outcome.files = items.size();
  assemble(into, items, machines, outcome);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  end_run(into, outcome, "complete");
  transaction.commit();
  return outcome;
}

}  // namespace owlint::audit
