// What people read, kept word for word in tests/snapshots. With OWLINT_UPDATE=1 they are rewritten.
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "analyzer/report/pages.h"
#include "rules/driver/codes_page.h"
#include "support/bundle.h"
#include "support/files.h"
#include "support/fixture.h"
#include "support/process.h"

using namespace owlint::test;

namespace {

/// Runs owlint in tests/programs and holds everything it prints against the snapshot `name`.
void snapshot(const std::string& name, const std::string& arguments,
              const std::string& folder = repository("tests/programs")) {
  const Run run = owlint::test::owlint(words(arguments), "", folder);
  const std::string text = fmt::format("$ owlint {}\n{}{}[exit status {}]\n", arguments, run.out, run.err, run.status);
  const std::string path = repository("tests/snapshots/" + name + ".txt");
  if (updating()) {
    if (!std::filesystem::exists(path) || read_file(path) != text) write_file(path, text);
    return;
  }
  INFO(path);
  REQUIRE(std::filesystem::exists(path));
  CHECK(text == read_file(path));
}

}  // namespace

TEST_CASE("the text of one fixture for each rule is as in its snapshot", "[snapshots][fixtures]") {
  if (updating()) update_fixtures();  // their lines are in the snapshots
  const auto& [fixtures, findings] = checked_fixtures();
  std::map<std::string, const Fixture*> first;
  for (size_t i = 0; i < fixtures.size(); ++i) {
    const auto own = [&](const auto& f) { return f["code"].template get<std::string>() == fixtures[i].folder; };
    if (std::ranges::any_of(findings[i], own)) first.emplace(fixtures[i].folder, &fixtures[i]);
  }
  REQUIRE(first.size() > 50);
  for (const auto& [code, fixture] : first) {
    const std::string path = code + "/" + std::filesystem::path(fixture->path).filename().string();
    const std::string options = fixture->options.empty() ? "" : fixture->options + " ";
    if (fixture->bundle) {
      const Scratch scratch;
      unpack(read_file(fixture->path), scratch);
      snapshot(code, "check --isolated --no-find-ini --color never " + options + ".", scratch.path());
      continue;
    }
    snapshot(code, "check --isolated --color never " + options + path);
  }
}

TEST_CASE("other texts are as in their snapshots", "[snapshots]") {
  if (updating()) update_fixtures();
  snapshot("check-color", "--isolated --color always OW104/label-if-twice.ngc");
  snapshot("check-statistics",
           "--isolated --quiet --statistics --format jsonl OW104/label-if-twice.ngc OW205/if-unclosed-skipped.ngc");
  snapshot("check-json", "--isolated --format json OW104/label-if-twice.ngc");
  for (const char* format : {"grouped", "gcc", "github", "gitlab", "checkstyle", "junit", "rdjson"}) {
    snapshot(std::string("check-") + format,
             std::string("--isolated --quiet --format ") + format +
                 " OW104/label-if-twice.ngc OW207/call-before-define-by-name.ngc OW104/label-if-in-loop.ngc");
  }
  snapshot("check-call", "--isolated OW303/zero-in-one-of-many-calls.ngc");
  snapshot("check-nothing", "--isolated OW104/label-if-in-loop.ngc");
  snapshot("explain", "explain OW104");
  snapshot("explain-unknown", "explain if-label-resued");
  snapshot("rules", "rules");
  snapshot("rules-markdown", "rules --format markdown");
  snapshot("graph-dot", "graph OW104/label-if-reused-in-other-sub.ngc");
  snapshot("graph-mermaid", "graph --format mermaid OW104/label-if-reused-in-other-sub.ngc");
  snapshot("extents", "extents --isolated OW904/depth-in-a-loop.ngc");
  snapshot("extents-json", "extents --isolated --format json OW904/depth-in-a-loop.ngc");
  snapshot("graph-json", "graph --format json OW104/label-if-reused-in-other-sub.ngc");
}

TEST_CASE("docs/rules holds the rules' pages", "[snapshots]") {
  std::string error;
  if (updating()) REQUIRE(owlint::write_rule_pages(repository("docs/rules"), &error));
  CHECK(read_file(repository("docs/rules/README.md")) == owlint::rule_index());
  std::set<std::string> expected{"README.md", "noise.md"};
  for (const owlint::Rule* rule : owlint::catalogue()) {
    expected.insert(std::string(rule->code) + ".md");
    CHECK(read_file(repository("docs/rules/" + std::string(rule->code) + ".md")) == owlint::rule_page(*rule));
  }
  std::set<std::string> there;
  for (const std::string& path : files_below(repository("docs/rules"))) there.insert(path.substr(path.rfind('/') + 1));
  CHECK(there == expected);
}

TEST_CASE("docs/codes.md holds the table of codes", "[snapshots]") {
  const std::string path = repository("docs/codes.md");
  const std::string page = owlint::codes_page();
  if (updating() && (!std::filesystem::exists(path) || read_file(path) != page)) write_file(path, page);
  REQUIRE(std::filesystem::exists(path));
  CHECK(read_file(path) == page);
}
