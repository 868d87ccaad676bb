// The rooms of the audit: records, the store and its steps, search path answers. The command as a whole is tested by
// tests/audit.
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "analyzer/audit/audit.h"
#include "analyzer/audit/packed.h"
#include "analyzer/audit/reading.h"
#include "analyzer/audit/record.h"
#include "analyzer/audit/schema.h"
#include "analyzer/audit/store.h"
#include "analyzer/report/formats.h"
#include "analyzer/text/memory_files.h"
#include "support/damage.h"
#include "support/files.h"

using namespace owlint;
using audit::Store;

namespace {

std::string json_of(const std::vector<FileReport>& reports, const char* format = "json") {
  std::ostringstream out;
  find_format(format)->write(out, reports, {});
  return out.str();
}

audit::Outcome audited(const test::Scratch& scratch, Store& store) {
  checking::CheckRequest line;
  line.paths = {scratch.path() + "/shop"};
  line.absolute = true;
  line.isolated = true;
  line.find_ini = false;
  return audit::run_audit({line, {}, nullptr, nullptr}, store);
}

}  // namespace

TEST_CASE("a record gives back the reports that it was made of, in every format", "[audit]") {
  const MemoryFiles none;
  Library library(none);
  checking::Settings settings;
  size_t findings = 0;
  size_t number = 0;
  constexpr size_t kEvery = OWLINT_PATIENCE == 1 ? 3 : 12;  // the same code runs many times as it is
  for (const auto& [name, text] : test::all_programs()) {
    if (number++ % kEvery != 0) continue;
    const auto source = Source::own("/shop/" + name, text);
    const checking::Checked checked = checking::check_file(source, settings, library, false);
    library.forget(source->path());
    audit::Records records;
    records.add(audit::record_of(checked));
    const checking::Checked back = records.checked(0);
    INFO(name);
    for (const Format& format : formats())
      CHECK(json_of({checked.report.own}, std::string(format.name).c_str()) ==
            json_of({back.report.own}, std::string(format.name).c_str()));
    CHECK(json_of(checked.report.called) == json_of(back.report.called));
    CHECK(back.report.calls == checked.report.calls);
    CHECK(back.report.sub_file == checked.report.sub_file);
    CHECK(back.report.only_definitions == checked.report.only_definitions);
    CHECK(back.as_sub.has_value() == checked.as_sub.has_value());
    findings += checked.report.own.findings.size();
  }
  CHECK(findings > 250 / kEvery);
}

TEST_CASE("bytes that are no record are refused", "[audit]") {
  audit::Records records;
  CHECK_THROWS(records.add("no record"));
  CHECK_THROWS(records.add(""));
}

TEST_CASE("a store of an older owlint gets the steps that it lacks", "[audit]") {
  const test::Scratch scratch;
  const std::string path = scratch.path() + "/old.db";
  {
    SQLite::Database old(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    old.exec(audit::kSteps[0]);
    old.exec("PRAGMA user_version = 1");
    old.exec("PRAGMA application_id = " + std::to_string(audit::kApplicationId));
    old.exec(
        "INSERT INTO run (started, state, version, tool, options, roots, shard) VALUES ('2026-01-01T00:00:00Z', "
        "'running', '0', '', '{}', '[]', '')");
  }
  CHECK_THROWS_WITH(Store::open(path, Store::For::kReading), Catch::Matchers::Contains("older owlint"));
  scratch.write("shop/a.ngc", "o100 if [1]\nM2\n");
  Store store = Store::open(path, Store::For::kWriting);
  CHECK(store.db().execAndGet("PRAGMA user_version").getInt() == static_cast<int>(audit::kSteps.size()));
  const audit::Outcome outcome = audited(scratch, store);
  CHECK(outcome.run == 2);
  CHECK(outcome.previous == 0);
  CHECK(store.db().execAndGet("SELECT state FROM run WHERE id = 1").getString() == "interrupted");
  CHECK(store.db().execAndGet("SELECT count(*) FROM current").getInt() == 1);
  CHECK(store.db().execAndGet("SELECT lines FROM program").getInt() == 2);
}

TEST_CASE("what is no store is left alone", "[audit]") {
  const test::Scratch scratch;
  scratch.write("text.db", "not a database at all, but long enough to look like one\n");
  CHECK_THROWS_WITH(Store::open(scratch.path() + "/text.db", Store::For::kWriting),
                    Catch::Matchers::Contains("is not an owlint store"));
  CHECK(test::read_file(scratch.path() + "/text.db") == "not a database at all, but long enough to look like one\n");
  {
    SQLite::Database(scratch.path() + "/other.db", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
        .exec("CREATE TABLE t (a)");
  }
  CHECK_THROWS_WITH(Store::open(scratch.path() + "/other.db", Store::For::kWriting),
                    Catch::Matchers::Contains("not an owlint store"));
  CHECK_THROWS_WITH(Store::open(scratch.path() + "/none.db", Store::For::kReading),
                    Catch::Matchers::Contains("there is no store"));
}

TEST_CASE("a store has one writer", "[audit]") {
  const test::Scratch scratch;
  const std::string path = scratch.path() + "/shop.db";
  {
    const Store first = Store::open(path, Store::For::kWriting);
    CHECK_THROWS_WITH(Store::open(path, Store::For::kWriting), Catch::Matchers::Contains("another audit"));
    Store reader = Store::open(path, Store::For::kReading);
    CHECK(audit::runs_of(reader).empty());
  }
  CHECK_NOTHROW(Store::open(path, Store::For::kWriting));
}

TEST_CASE("runs that are asked for", "[audit]") {
  const test::Scratch scratch;
  scratch.write("shop/a.ngc", "M2\n");
  Store store = Store::open(scratch.path() + "/shop.db", Store::For::kWriting);
  for (int i = 0; i < 3; ++i) audited(scratch, store);
  CHECK(audit::find_run(store, "last") == 3);
  CHECK(audit::find_run(store, "last-2") == 1);
  CHECK(audit::find_run(store, "2") == 2);
  for (const char* none : {"last-3", "4", "0", "-1", "x", "last-", "last-x", "last2", ""}) {
    INFO(none);
    CHECK_FALSE(audit::find_run(store, none).has_value());
  }
}

TEST_CASE("shards are parts of the whole", "[audit]") {
  size_t all = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::string path = "/shop/part" + std::to_string(i) + ".ngc";
    size_t parts = 0;
    for (uint32_t index = 1; index <= 4; ++index) parts += audit::Shard{index, 4}.has(path) ? 1 : 0;
    CHECK(parts == 1);
    all += audit::Shard{1, 4}.has(path) ? 1 : 0;
  }
  CHECK(all > 200);
  CHECK(all < 300);
}

TEST_CASE("data of the page are gzip in base64", "[audit]") {
  const std::string text = audit::packed("some text");
  CHECK(text.starts_with("H4sI"));
  CHECK(text.find_first_of("<&\"") == std::string::npos);
}
