#include "analyzer/audit/audit.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <unordered_map>

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>
#include <nlohmann/json.hpp>

#include "analyzer/audit/assembly.h"
#include "analyzer/audit/checking.h"
#include "analyzer/audit/hashes.h"
#include "analyzer/audit/options.h"
#include "analyzer/audit/record.h"
#include "analyzer/text/files.h"
#include "analyzer/text/parallel.h"
#include "analyzer/text/paths.h"
#include "analyzer/text/printable.h"

namespace owlint::audit {
namespace {

using Clock = std::chrono::steady_clock;

class Run {
 public:
  Run(const Job& job, Store& store) : job_(job), store_(store), db_(store.db()), facts_(db_) {}

  Outcome go() {
    const auto start = Clock::now();
    find_items();
    // A server that is not mounted is an empty folder: its programs are not gone.
    if (items_.empty() && !out_.problems.empty()) return out_;
    nlohmann::json roots = nlohmann::json::array();
    for (const std::string& path : job_.line.paths) roots.push_back(printable(file_key(path)));
    begin_run(store_,
              {options_text(job_.line), roots.dump(), job_.shard.count == 1 ? "" : job_.shard.text(), tool_hash()},
              out_);
    compare_with_store();
    Checking checking(store_, facts_, out_.run);
    out_.analysed = checking.run(items_, job_.progress, job_.stop);
    const bool stopped = job_.stop != nullptr && job_.stop->load();
    SQLite::Transaction transaction(db_, SQLite::TransactionBehavior::IMMEDIATE);
    if (stopped) {
      out_.interrupted = true;
    } else {
      complete(checking.library());
    }
    out_.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    end_run(store_, out_, stopped ? "interrupted" : "complete");
    transaction.commit();
    return out_;
  }

 private:
  void find_items() {
    std::vector<std::string> roots;
    for (const std::string& path : job_.line.paths) roots.push_back(file_key(path));
    checking::WalkOptions options = job_.line.walk;
    options.follow_links = true;
    checking::Configuration configuration(disk(), job_.line);
    checking::Walk found = checking::walk(disk(), roots, options,
                                          [&](const std::string& folder) { return configuration.patterns_in(folder); });
    out_.problems = std::move(found.problems);
    if (roots.size() > 1) std::ranges::stable_sort(found.files, {}, &checking::WalkedFile::path);
    configuration.know_without_ini(found.without_ini);
    std::string last_error;
    std::set<const MachineSetup*> machines;
    std::shared_ptr<const checking::Settings> last;
    int64_t last_id = 0;
    const auto add_machine = [&](const std::shared_ptr<const checking::Settings>& with) {
      const MachineSetup* const setup = with->profile.setup.get();
      if (setup != nullptr && machines.insert(setup).second) machines_.push_back(with);
    };
    for (checking::WalkedFile& file : found.files) {
      if (!job_.shard.has(file.path)) continue;
      std::string error;
      Item item{std::move(file.path), file.stamp, 0, "", nullptr, 0, false, false, ""};
      item.settings = configuration.shared_settings(item.key, &error);
      if (item.settings != nullptr && item.settings->of_ini) {
        add_machine(item.settings);
        continue;
      }
      if (item.settings == nullptr) {
        item.problem = error;
        if (error != last_error) out_.problems.push_back(error);
        last_error = error;
      } else {
        if (item.settings != last) {
          last_id = settings_number(settings_hash(*item.settings));
          last = item.settings;
          add_machine(last);
        }
        item.settings_id = last_id;
      }
      items_.push_back(std::move(item));
    }
    std::ranges::move(configuration.notes(), std::back_inserter(out_.notes));
    std::vector<const checking::Settings*> settings;
    for (const auto& one : machines_) settings.push_back(one.get());
    const std::set<std::string> by_machines = checking::called_by_machines(settings);
    if (!by_machines.empty()) {
      for (Item& item : items_) item.by_machine = by_machines.contains(item.key);
    }
    out_.files = items_.size();
  }

  int64_t settings_number(const std::string& hash) {
    if (const auto known = settings_.find(hash); known != settings_.end()) return known->second;
    SQLite::Statement add(
        db_, "INSERT INTO settings (hash) VALUES (?) ON CONFLICT (hash) DO UPDATE SET hash = hash RETURNING id");
    add.bind(1, hash);
    add.executeStep();
    return settings_[hash] = add.getColumn(0).getInt64();
  }

  /// Decides what has to be analysed. Both lists are in the order of paths.
  void compare_with_store() {
    std::vector<Item*> to_look_at;
    std::unordered_map<int64_t, Item*> by_number;
    struct Known {
      std::string hash;
      int64_t settings;
      bool machine;
    };
    std::vector<Known> known(items_.size());
    SQLite::Statement all(db_, "SELECT path, id, present, stamp, hash, settings, machine FROM file ORDER BY path");
    size_t at = 0;
    size_t present = 0;
    while (all.executeStep()) {
      const auto path_column = all.getColumn(0);
      const std::string_view path(path_column.getText(), static_cast<size_t>(path_column.getBytes()));
      while (at < items_.size() && items_[at].key < path) ++at;
      const bool here = at < items_.size() && items_[at].key == path;
      if (all.getColumn(2).getInt() != 0) here ? ++present : ++vanished_;
      if (!here) continue;
      Item& item = items_[at];
      item.file = all.getColumn(1).getInt64();
      known[at] = {all.getColumn(4).getString(), all.getColumn(5).getInt64(), all.getColumn(6).getInt() != 0};
      const auto stamp = static_cast<uint64_t>(all.getColumn(3).getInt64());
      if (known[at].hash.empty()) continue;
      if (stamp != 0 && stamp == item.stamp) {
        item.hash = known[at].hash;
      } else {
        to_look_at.push_back(&item);
      }
    }
    came_ = items_.size() - present;
    for_each(to_look_at.size(), [&](size_t i) {
      Item& item = *to_look_at[i];
      const auto source = disk().read(item.key, &item.problem);
      if (source != nullptr) item.hash = hash_of(source->bytes());
    });
    SQLite::Transaction transaction(db_, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement stamped(db_, "UPDATE file SET stamp = ? WHERE path = ?");
    for (const Item* item : to_look_at) {
      stamped.bind(1, static_cast<int64_t>(item->stamp));
      stamped.bind(2, item->key);
      stamped.exec();
      stamped.reset();
    }
    for (size_t i = 0; i < items_.size(); ++i) {
      Item& item = items_[i];
      if (item.settings == nullptr) continue;
      item.analyse = item.hash.empty() || item.hash != known[i].hash || item.settings_id != known[i].settings ||
          item.by_machine != known[i].machine;
    }
    const auto walked = [this](const std::string& key) {
      const auto item = std::ranges::lower_bound(items_, key, {}, &Item::key);
      return item != items_.end() && item->key == key ? item->hash : std::string();
    };
    const std::vector<int64_t> untrue = facts_.untrue(walked);
    if (!untrue.empty()) {
      for (Item& item : items_) by_number.emplace(item.file, &item);
      SQLite::Statement resting(db_, "SELECT file FROM rests_on WHERE fact = ?");
      for (const int64_t fact : untrue) {
        resting.bind(1, fact);
        while (resting.executeStep()) {
          const auto item = by_number.find(resting.getColumn(0).getInt64());
          if (item != by_number.end() && item->second->settings != nullptr) item->second->analyse = true;
        }
        resting.reset();
      }
    }
    transaction.commit();
  }

  void complete(Library& library) {
    std::set<std::string> machines;
    for (const auto& settings : machines_)
      machines.insert(record_of(checking::check_machines({settings.get()}, library)));
    SQLite::Statement since(db_,
                            "SELECT count(*) FROM analysis WHERE run > ?");  // by runs that did not come to their end
    since.bind(1, out_.previous);
    since.executeStep();
    const bool same_programs =
        out_.previous != 0 && came_ == 0 && vanished_ == 0 && out_.analysed == 0 && since.getColumn(0).getInt64() == 0;
    since.reset();
    // A program that cannot be read or checked, now or in the run before: what is said of it has changed, or may have.
    const bool troubles =
        db_.execAndGet("SELECT count(*) FROM content WHERE until IS NULL AND problem <> ''").getInt() > 0 ||
        std::ranges::any_of(items_, [](const Item& item) { return !item.problem.empty(); });
    if (same_programs && !troubles && machine_records(store_) == machines) {
      take_over(store_, out_);
    } else {
      assemble(store_, items_, machines, out_);
    }
    for (const Item& item : items_) {
      if (item.settings != nullptr && !item.problem.empty())
        out_.problems.push_back(fmt::format("cannot read {}: {}", item.key, item.problem));
    }
  }

  const Job& job_;
  Store& store_;
  SQLite::Database& db_;
  Facts facts_;
  Outcome out_;
  std::vector<Item> items_;
  std::vector<std::shared_ptr<const checking::Settings>> machines_;  // settings with different ones
  std::unordered_map<std::string, int64_t> settings_;
  size_t came_ = 0, vanished_ = 0;  // programs, against the last complete run
};

}  // namespace

std::string Shard::text() const { return fmt::format("{}/{}", index, count); }

bool Shard::has(const std::string& path) const {
  return count == 1 || XXH3_64bits(path.data(), path.size()) % count == index - 1;
}

Outcome run_audit(const Job& job, Store& store) { return Run(job, store).go(); }

}  // namespace owlint::audit
