// No rule without fixtures and a full page; and what a page shows is what owlint does. That LinuxCNC does it too is
// the business of interpreter/confirm.py.
#include <filesystem>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "support/files.h"
#include "support/fixture.h"
#include "support/process.h"

using namespace owlint::test;

namespace {

nlohmann::json rules() { return nlohmann::json::parse(owlint::test::owlint({"rules", "--format", "json"}).out); }

/// Whether a text is still what new_rule.py has put there.
bool is_placeholder(const std::string& text) { return text == "…" || text == "…\n"; }

bool has_code(const nlohmann::json& findings, const std::string& code) {
  return std::ranges::any_of(findings, [&](const auto& f) { return f["code"].template get<std::string>() == code; });
}

}  // namespace

TEST_CASE("every rule has a fixture that shows it and one that does not", "[coverage][fixtures]") {
  const auto& [fixtures, findings] = checked_fixtures();
  std::set<std::string> shown;
  std::set<std::string> spared;
  for (size_t i = 0; i < fixtures.size(); ++i) {
    (has_code(findings[i], fixtures[i].folder) ? shown : spared).insert(fixtures[i].folder);
  }
  std::set<std::string> codes;
  for (const auto& rule : rules()) {
    const auto code = rule["code"].get<std::string>();
    codes.insert(code);
    INFO(code);
    CHECK(shown.contains(code));
    CHECK(spared.contains(code));
  }
  for (const Fixture& fixture : fixtures) {
    INFO(fixture.path << " is in the folder of no rule");
    CHECK(codes.contains(fixture.folder));
  }
}

TEST_CASE("every rule is one file that is named after it", "[coverage]") {
  std::set<std::string> files;
  for (const std::string& path : files_below(repository("rules"))) {
    const std::string name = std::filesystem::path(path).filename().string();
    if (!name.starts_with("ow")) continue;
    files.insert(name);
    INFO(name << ": new_rule.py has put a … there");
    const std::string source = read_file(path);
    CHECK(source.find("\n// …") == std::string::npos);
    CHECK(source.find(": …\n") == std::string::npos);
  }
  std::string last;
  std::set<std::string> names;
  for (const auto& rule : rules()) {
    const auto code = rule["code"].get<std::string>();
    const auto name = rule["name"].get<std::string>();
    INFO(code);
    CHECK(code > last);
    last = code;
    CHECK(names.insert(name).second);
    std::string file = "ow" + code.substr(2) + "_" + name + ".cc";
    std::ranges::replace(file, '-', '_');
    CHECK(files.erase(file) == 1);
  }
  CHECK(files == std::set<std::string>());
}

TEST_CASE("every rule has a page with all parts", "[coverage]") {
  for (const auto& rule : rules()) {
    INFO(rule["code"].get<std::string>());
    for (const char* part : {"summary", "what", "why", "bad", "good", "fix", "level_reason"}) {
      INFO(part);
      const auto text = rule[part].get<std::string>();
      CHECK_FALSE(text.empty());
      CHECK_FALSE(is_placeholder(text));
      CHECK(text.find(" \n") == std::string::npos);
    }
    CHECK_FALSE(is_placeholder(rule["interpreter"].get<std::string>()));
    for (const char* part : {"bad", "good"}) CHECK(rule[part].get<std::string>().back() == '\n');
    for (const char* part : {"what", "why", "fix", "level_reason"}) CHECK(rule[part].get<std::string>().back() == '.');
    CHECK(rule["bad"].get<std::string>() != rule["good"].get<std::string>());
    CHECK_FALSE(rule["summary"].get<std::string>().ends_with('.'));
  }
}

TEST_CASE("every page's bad example has the finding and its good one has none", "[coverage]") {
  for (const auto& rule : rules()) {
    const auto code = rule["code"].get<std::string>();
    const auto options = rule["options"].get<std::string>();
    INFO(code);
    const nlohmann::json bad = findings_of(rule["bad"], options);
    CHECK(has_code(bad, code));
    const nlohmann::json good = findings_of(rule["good"], options);
    INFO(good.dump(2));
    CHECK(good.empty());
    for (const auto& f : bad) {
      if (f["code"].get<std::string>() != code || !f["stops"].get<bool>() || code == "OW505")
        continue;  // a crash says nothing
      CHECK_FALSE(f.value("interpreter", "").empty());
      CHECK_FALSE(rule["interpreter"].get<std::string>().empty());
    }
  }
}

TEST_CASE("a page's bad example shows its own rule only", "[coverage]") {
  // Rules that come with another one's finding by their nature.
  const std::map<std::string, std::vector<std::string>> companions = {
      {"OW503", {"OW1", "OW2"}}, {"OW504", {"OW1"}}, {"OW506", {"OW208"}}, {"OW410", {"OW403"}},
      {"OW310", {"OW710"}},      {"OW319", {"OW3"}}, {"OW302", {"OW854"}}, {"OW306", {"OW854"}}};
  for (const auto& rule : rules()) {
    const auto code = rule["code"].get<std::string>();
    for (const auto& f : findings_of(rule["bad"], rule["options"])) {
      const auto found = f["code"].get<std::string>();
      if (found == code) continue;
      INFO(code << ": also " << found << " on line " << f["start"]["line"]);
      const auto companion = companions.find(code);
      CHECK((companion != companions.end() && std::ranges::any_of(companion->second, [&](const std::string& prefix) {
               return found.starts_with(prefix);
             })));
    }
  }
}

TEST_CASE("messages are lower case and end without a full stop", "[coverage][fixtures]") {
  const auto& [fixtures, findings] = checked_fixtures();
  for (size_t i = 0; i < fixtures.size(); ++i) {
    for (const auto& f : findings[i]) {
      for (const std::string& text : {f["message"].get<std::string>(), f.value("help", "")}) {
        if (text.empty()) continue;
        INFO(fixtures[i].path << ": " << text);
        CHECK_FALSE(is_placeholder(text));
        CHECK(text.back() != '.');
        CHECK((std::islower(static_cast<unsigned char>(text[0])) != 0 ||
               !std::isalpha(static_cast<unsigned char>(text[0])) || text.starts_with("LinuxCNC") ||
               text.starts_with("M") || text.starts_with("N") || text.starts_with("U+")));
      }
    }
  }
}
