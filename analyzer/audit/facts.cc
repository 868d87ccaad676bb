#include "analyzer/audit/facts.h"

#include <map>
#include <memory>
#include <set>

#include <fmt/format.h>

#include "analyzer/audit/hashes.h"
#include "analyzer/text/files.h"
#include "analyzer/text/paths.h"

namespace owlint::audit {
namespace {

std::string subject_of(const SearchPath& path) {
  std::string text;
  for (const SearchFolder& folder : path.folders()) text += (folder.tree ? "//" : "") + file_key(folder.path) + "\n";
  return text;
}

std::unique_ptr<SearchPath> search_path_of(const std::string& subject) {
  std::vector<SearchFolder> folders;
  for (size_t at = 0; at < subject.size();) {
    const size_t feed = std::min(subject.find('\n', at), subject.size());
    const std::string folder = subject.substr(at, feed - at);
    const bool tree = folder.starts_with("//");
    folders.push_back({folder.substr(tree ? 2 : 0), tree});
    at = feed + 1;
  }
  return std::make_unique<SearchPath>(disk(), std::move(folders));
}

}  // namespace

std::vector<Fact> facts_of(const Inputs& inputs, const std::function<std::string(const Source&)>& bytes_of) {
  std::vector<Fact> facts;
  if (!inputs.answers.empty()) {
    const std::string subject = subject_of(*inputs.search_path);
    for (const Answer& answer : inputs.answers)
      facts.push_back({static_cast<int>(answer.question), subject, answer.name, answer.text, 0});
  }
  std::set<std::string> files;
  for (const auto& source : inputs.called) {
    const std::string key = file_key(source->path());
    if (files.insert(key).second) facts.push_back({Fact::kBytes, key, "", bytes_of(*source), 0});
  }
  for (const std::string& key : inputs.compared) {
    std::string error;
    if (!files.insert(key).second) continue;
    const auto source = disk().read(key, &error);
    facts.push_back({Fact::kBytes, key, "", hash_of(source == nullptr ? std::string_view() : source->bytes()), 0});
  }
  return facts;
}

Facts::Facts(SQLite::Database& db)
    : db_(db),
      insert_(db, "INSERT INTO fact (kind, subject, name, answer, stamp) VALUES (?, ?, ?, ?, ?)"),
      forget_(db, "DELETE FROM rests_on WHERE file = ?"),
      rest_(db, "INSERT OR IGNORE INTO rests_on (file, fact) VALUES (?, ?)") {
  SQLite::Statement all(db, "SELECT id, kind, subject, name, answer, stamp FROM fact");
  while (all.executeStep()) {
    Stored stored{all.getColumn(0).getInt64(),
                  {all.getColumn(1).getInt(), all.getColumn(2).getString(), all.getColumn(3).getString(),
                   all.getColumn(4).getString(), static_cast<uint64_t>(all.getColumn(5).getInt64())}};
    ids_.emplace(key_of(stored.fact), stored.id);
    stored_.push_back(std::move(stored));
  }
}

std::string Facts::key_of(const Fact& fact) {
  std::string key = fmt::format("{}\n{}", fact.kind, fact.subject);
  for (const std::string* part : {&fact.name, &fact.answer}) {
    key += '\0';
    key += *part;
  }
  return key;
}

bool Facts::holds(const Fact& fact, const SearchPath* path,
                  const std::function<std::string(const std::string&)>& walked, uint64_t* stamp) const {
  if (fact.kind != Fact::kBytes) return ask(*path, static_cast<Answer::Question>(fact.kind), fact.name) == fact.answer;
  if (const std::string hash = walked(fact.subject); !hash.empty()) return hash == fact.answer;
  *stamp = disk().info(fact.subject).stamp;
  if (*stamp != 0 && *stamp == fact.stamp) return true;
  std::string error;
  const auto source = disk().read(fact.subject, &error);
  return hash_of(source == nullptr ? std::string_view() : source->bytes()) == fact.answer;
}

std::vector<int64_t> Facts::untrue(const std::function<std::string(const std::string& key)>& walked) {
  std::vector<int64_t> out;
  std::map<std::string_view, std::unique_ptr<SearchPath>> paths;
  SQLite::Statement stamped(db_, "UPDATE fact SET stamp = ? WHERE id = ?");
  for (Stored& stored : stored_) {
    const SearchPath* path = nullptr;
    if (stored.fact.kind != Fact::kBytes) {
      auto& made = paths[stored.fact.subject];
      if (made == nullptr) made = search_path_of(stored.fact.subject);
      path = made.get();
    }
    uint64_t stamp = stored.fact.stamp;
    if (!holds(stored.fact, path, walked, &stamp)) {
      out.push_back(stored.id);
    } else if (stamp != stored.fact.stamp) {
      stored.fact.stamp = stamp;
      stamped.bind(1, static_cast<int64_t>(stamp));
      stamped.bind(2, stored.id);
      stamped.exec();
      stamped.reset();
    }
  }
  return out;
}

void Facts::rest(int64_t file, const std::vector<Fact>& facts) {
  forget_.bind(1, file);
  forget_.exec();
  forget_.reset();
  for (const Fact& fact : facts) {
    const auto [at, added] = ids_.try_emplace(key_of(fact), 0);
    if (added) {
      insert_.bind(1, fact.kind);
      insert_.bind(2, fact.subject);
      insert_.bind(3, fact.name);
      insert_.bind(4, fact.answer);
      insert_.bind(5, static_cast<int64_t>(fact.stamp));
      insert_.exec();
      insert_.reset();
      at->second = db_.getLastInsertRowid();
    }
    rest_.bind(1, file);
    rest_.bind(2, at->second);
    rest_.exec();
    rest_.reset();
  }
}

void Facts::sweep(SQLite::Database& db) { db.exec("DELETE FROM fact WHERE id NOT IN (SELECT fact FROM rests_on)"); }

}  // namespace owlint::audit
