#include "support/fixture.h"

#include "support/bundle.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "support/files.h"
#include "support/process.h"

namespace owlint::test {
namespace {

namespace fs = std::filesystem;

/// The value of `key` in a line such as `; key: value`; false when the line is another one.
bool value_of(std::string line, const std::string& prefix, const std::string& key, std::string* value) {
  if (!line.empty() && line.back() == '\n') line.pop_back();
  if (!line.empty() && line.back() == '\r') line.pop_back();
  const std::string wanted = prefix + key + ": ";
  if (!line.starts_with(wanted)) return false;
  *value = line.substr(wanted.size());
  return true;
}

/// Lines with their line ends.
std::vector<std::string> split(const std::string& bytes) {
  std::vector<std::string> lines;
  for (size_t at = 0; at < bytes.size();) {
    const size_t feed = bytes.find('\n', at);
    const size_t next = feed == std::string::npos ? bytes.size() : feed + 1;
    lines.push_back(bytes.substr(at, next - at));
    at = next;
  }
  return lines;
}

std::string prefix_of(const Fixture& fixture) { return fixture.lines_in == fixture.path ? "; " : ""; }

Fixture read_fixture(const std::string& path) {
  Fixture fixture;
  fixture.path = path;
  fixture.folder = fs::path(path).parent_path().filename().string();
  const std::string beside = fs::path(path).replace_extension(".expect").string();
  fixture.lines_in = fs::exists(beside) ? beside : path;
  const std::string prefix = prefix_of(fixture);
  fixture.bundle = is_bundle(read_file(path));
  for (const std::string& line : split(read_file(fixture.lines_in))) {
    std::string value;
    if (value_of(line, prefix, "asks", &value)) fixture.asks = value;
    if (value_of(line, prefix, "options", &value)) fixture.options = value;
    if (value_of(line, prefix, "expect", &value)) fixture.expected.push_back(value);
  }
  return fixture;
}

}  // namespace

std::vector<Fixture> all_fixtures() {
  std::vector<Fixture> fixtures;
  for (const std::string& path : files_below(repository("tests/programs"))) {
    if (!path.ends_with(".expect")) fixtures.push_back(read_fixture(path));
  }
  return fixtures;
}

std::vector<std::string> expectations(const nlohmann::json& findings) {
  std::vector<std::string> out;
  for (const auto& f : findings) {
    const auto place = [&](const char* end) {
      return fmt::format("{}:{}", f[end]["line"].get<int>(), f[end]["column"].get<int>());
    };
    const std::string file = f.contains("file") ? f["file"].get<std::string>() + " " : "";
    out.push_back(fmt::format("{}{} {}-{} {} {} {}", file, f["code"].get<std::string>(), place("start"), place("end"),
                              f["severity"].get<std::string>(), f["reach"].get<std::string>(),
                              f["stops"].get<bool>() ? "stops" : "runs"));
  }
  if (out.empty()) out.emplace_back("nothing");
  return out;
}

bool meets(const std::string& expected, const std::string& found) {
  if (expected == found) return true;
  std::vector<std::string> wanted = words(expected);
  std::vector<std::string> seen = words(found);
  if (wanted.size() != 5 || seen.size() != 5 || wanted[1].find(':') != std::string::npos) return false;
  seen[1] = seen[1].substr(0, seen[1].find(':'));
  return wanted == seen;
}

void rewrite(const Fixture& fixture, const std::vector<std::string>& found) {
  const std::string prefix = prefix_of(fixture);
  const std::string before = read_file(fixture.lines_in);
  std::string after;
  bool written = false;
  std::string ending = "\n";
  const auto write = [&] {
    for (const std::string& line : found) after += prefix + "expect: " + line + ending;
    written = true;
  };
  for (const std::string& line : split(before)) {
    std::string value;
    if (line.ends_with("\r\n")) ending = "\r\n";
    if (!value_of(line, prefix, "expect", &value)) {
      after += line;
      continue;
    }
    if (!written) write();
    // A last line without line feed stays one.
    if (!line.ends_with('\n')) after.resize(after.size() - ending.size());
  }
  if (!written && prefix.empty()) write();
  if (after != before) write_file(fixture.lines_in, after);
}

std::vector<nlohmann::json> check_fixtures(const std::vector<Fixture>& fixtures) {
  std::map<std::string, std::vector<size_t>> by_options;
  std::vector<nlohmann::json> out(fixtures.size());
  for (size_t i = 0; i < fixtures.size(); ++i) {
    if (fixtures[i].bundle) {
      out[i] = findings_of_bundle(read_file(fixtures[i].path), fixtures[i].options);
    } else {
      by_options[fixtures[i].options].push_back(i);
    }
  }
  for (const auto& [options, members] : by_options) {
    std::vector<std::string> paths;
    for (const size_t i : members) paths.push_back(fixtures[i].path);
    const nlohmann::json files = check_files(paths, options);
    for (size_t i = 0; i < members.size(); ++i) out[members[i]] = files[i]["findings"];
  }
  return out;
}

const CheckedFixtures& checked_fixtures() {
  static const CheckedFixtures checked = [] {
    std::vector<Fixture> fixtures = all_fixtures();
    std::vector<nlohmann::json> findings = check_fixtures(fixtures);
    return CheckedFixtures{std::move(fixtures), std::move(findings)};
  }();
  return checked;
}

size_t update_fixtures() {
  size_t first = 0;
  for (int round = 0; round < 4; ++round) {
    const std::vector<Fixture> fixtures = all_fixtures();
    const std::vector<nlohmann::json> findings = check_fixtures(fixtures);
    size_t rewritten = 0;
    for (size_t i = 0; i < fixtures.size(); ++i) {
      const std::vector<std::string> found = expectations(findings[i]);
      if (found == fixtures[i].expected) continue;
      rewrite(fixtures[i], found);
      ++rewritten;
    }
    if (rewritten == 0) return first;
    if (round == 0) first = rewritten;
  }
  throw std::runtime_error("the fixtures' expectations do not settle");
}

}  // namespace owlint::test
