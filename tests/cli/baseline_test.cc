// Old findings: the baseline, and `--since`.
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace baseline_test {
namespace {

const std::string kBad =
    "o<probe> sub\n  o100 if [#1]\n  o100 endif\n  o100 if [#1]\n  o100 endif\no<probe> endsub\no<probe> call "
    "[1]\nM2\n";

Run check(const Scratch& s, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"check", "--no-find-ini", "--baseline", s.path() + "/base.json"});
  return owlint::test::owlint(arguments);
}

}  // namespace

TEST_CASE("known findings are not reported, new ones are", "[cli][baseline]") {
  const Scratch s;
  const std::string path = s.write("bad.ngc", kBad);
  CHECK(check(s, {"--update-baseline", path}).status == 0);
  const Run known = check(s, {path});
  CHECK(known.status == 0);
  CHECK(known.out.empty());
  CHECK(known.err == "1 known finding not shown (listed in " + s.path() + "/base.json)\nnothing new found in 1 file\n");
  s.write("bad.ngc", "o9 endif\n" + kBad);
  const Run next = check(s, {path, "--format", "gcc"});
  CHECK(next.status == 1);
  CHECK(next.out.find("bad.ngc:1:1: error: `o9 endif`") != std::string::npos);
  CHECK(std::ranges::count(next.out, '\n') == 1);
}

TEST_CASE("moved lines, another indentation and another folder make no finding new", "[cli][baseline]") {
  const Scratch s;
  CHECK(check(s, {"--update-baseline", s.write("bad.ngc", kBad)}).status == 0);
  std::string moved = "(a new comment)\n\n" + kBad;
  moved.replace(moved.rfind("  o100 if [#1]"), 14, "\t\to100  if [#1]  ");
  std::filesystem::create_directory(s.path() + "/new folder");
  CHECK(check(s, {s.write("new folder/bad.ngc", moved)}).status == 0);
}

TEST_CASE("a second finding of the same kind is new, and one in another sub is", "[cli][baseline]") {
  const Scratch s;
  const std::string open = "o<probe> sub\n  #2 = [1\n";
  const std::string rest = "o<probe> endsub\no<probe> call [1]\nM2\n";
  const std::string path = s.write("bad.ngc", open + rest);
  CHECK(check(s, {"--update-baseline", path}).status == 0);
  s.write("bad.ngc", open + "  #2 = [1\n" + rest);
  CHECK(check(s, {path, "--fail-on", "warning"}).status == 1);
  std::string other = open + rest;
  for (size_t at = 0; (at = other.find("probe", at)) != std::string::npos;) other.replace(at, 5, "plane");
  s.write("bad.ngc", other);
  CHECK(check(s, {path}).status == 1);
}

TEST_CASE("findings that are gone are reported, for the files that were checked", "[cli][baseline]") {
  const Scratch s;
  const std::string bad = s.write("bad.ngc", kBad);
  const std::string good = s.write("good.ngc", "G0 X1\nM2\n");
  CHECK(check(s, {"--update-baseline", bad, good}).status == 0);
  CHECK(check(s, {good}).err.find("no longer there") == std::string::npos);
  s.write("bad.ngc", "G0 X1\nM2\n");
  CHECK(check(s, {bad}).err.find("1 finding of " + s.path() + "/base.json no longer there") != std::string::npos);
}

TEST_CASE("a baseline is sorted JSON, another file in its place is refused", "[cli][baseline]") {
  const Scratch s;
  const std::string path = s.write(
      "b\xFC"
      "gel.ngc",
      kBad);
  CHECK(check(s, {"--update-baseline", path}).status == 0);
  const auto json = nlohmann::json::parse(read_file(s.path() + "/base.json"));
  CHECK(json["schema"] == "owlint-baseline-1");
  REQUIRE(json["findings"].size() == 1);
  CHECK(json["findings"][0] ==
        nlohmann::json{{"file", "bügel.ngc"}, {"code", "OW104"}, {"scope", "o<probe> o100"}, {"text", "o100 if [#1]"}});
  CHECK(check(s, {path}).status == 0);
  for (const char* text : {"", "{}", "[1]", "{\"schema\": \"owlint-baseline-1\", \"findings\": [3]}",
                           "{\"schema\": \"owlint-baseline-1\", \"findings\": 3}"}) {
    s.write("base.json", text);
    const Run run = check(s, {path});
    INFO(text);
    CHECK(run.status == 2);
    CHECK(!run.err.empty());
  }
}

TEST_CASE("option --since takes changed and new files only", "[cli][since]") {
  const Scratch s;
  const auto git = [&](const std::string& arguments) {
    return std::system(
               ("cd '" + s.path() + "' && git -c user.email=a@b -c user.name=a " + arguments + " >/dev/null 2>&1")
                   .c_str()) == 0;
  };
  if (!git("init")) return;
  s.write("old.ngc", kBad);
  s.write("touched.ngc", "G0 X1\nM2\n");
  REQUIRE(git("add ."));
  REQUIRE(git("commit -m first"));
  const auto since = [&](const std::string& revision) {
    return owlint::test::owlint({"check", "--no-find-ini", "--since", revision, "--format", "gcc", "."}, {}, s.path());
  };
  CHECK(since("HEAD").out.empty());
  s.write("touched.ngc", kBad);
  std::filesystem::create_directory(s.path() + "/deep er");
  s.write("deep er/new.ngc", kBad);
  const Run run = since("HEAD");
  CHECK(run.status == 1);
  CHECK(run.out.starts_with("deep er/new.ngc:4:"));
  CHECK(run.out.find("touched.ngc:4:") != std::string::npos);
  CHECK(run.out.find("old.ngc") == std::string::npos);
  CHECK(since("no-such-revision").status == 2);
  CHECK(since("--output=x").status == 2);
  CHECK(!std::filesystem::exists(s.path() + "/x"));
}

TEST_CASE("from two hundred old findings to a check that fails on the next new one", "[cli][baseline]") {
  const Scratch s;
  std::filesystem::create_directory(s.path() + "/parts");
  for (int i = 0; i < 200; ++i) {
    std::string text = kBad;
    for (size_t at = 0; (at = text.find("probe", at)) != std::string::npos; at += 5)
      text.replace(at, 5, "p" + std::to_string(1000 + i));
    s.write("parts/part" + std::to_string(i) + ".ngc", text);
  }
  // The commands of docs/guide.md; none of these mistakes can be fixed safely, for the subs may be called from elsewhere.
  const auto owlint = [&](std::vector<std::string> arguments) { return owlint::test::owlint(arguments, {}, s.path()); };
  CHECK(owlint({"--no-find-ini", "--format", "gcc", "parts"}).status == 1);
  CHECK(owlint({"--no-find-ini", "--baseline", "known.json", "--update-baseline", "parts"})
            .err.starts_with("recorded 200 known findings in known.json"));
  CHECK(owlint({"--no-find-ini", "--baseline", "known.json", "parts"}).status == 0);
  s.write("parts/part7.ngc", "o9 endif\n" + read_file(s.path() + "/parts/part7.ngc"));
  const Run next = owlint({"--no-find-ini", "--baseline", "known.json", "--format", "gcc", "parts"});
  CHECK(next.status == 1);
  CHECK(next.out.starts_with("parts/part7.ngc:1:1: error: "));
  CHECK(std::ranges::count(next.out, '\n') == 1);
}

}  // namespace baseline_test
