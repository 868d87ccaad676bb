// The command line as scripts rely on it: exit statuses, streams, inputs of all sorts.
#include <sys/stat.h>

#include <filesystem>

#include <catch2/catch.hpp>

#include "support/files.h"
#include "support/process.h"

using namespace owlint::test;

namespace command_line_test {
namespace {

const std::string kGood = "G0 X1\nM2\n";
const std::string kBad = "o1 if [1]\no1 endif\no1 if [1]\no1 endif\nM2\n";  // OW104
const std::string kWarning = "o1 if [0]\no1 endif done\nM2\n";              // OW304, runs

Run run(std::vector<std::string> arguments, const std::string& input = {}, const std::string& folder = {}) {
  return owlint::test::owlint(arguments, input, folder);
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("exit status 0 for clean and 1 for findings", "[cli]") {
  const Scratch s;
  CHECK(run({"--isolated", s.write("good.ngc", kGood)}).status == 0);
  CHECK(run({"--isolated", s.write("bad.ngc", kBad)}).status == 1);
  CHECK(run({"check", "--isolated", s.path()}).status == 1);
  const std::string warning = s.write("warning.ngc", kWarning);
  CHECK(run({"--isolated", warning}).status == 0);
  CHECK(run({"--isolated", "--fail-on", "warning", warning}).status == 1);
  CHECK(run({"--isolated", "--fail-on", "info", warning}).status == 1);
  CHECK(run({"--isolated", "--fail-on", "warning", "--feature", "0x20", s.path() + "/bad.ngc"}).status == 1);
  CHECK(run({"--isolated", "--feature", "0x20", s.path() + "/bad.ngc"}).status == 0);
}

TEST_CASE("exit status 2 for wrong usage", "[cli]") {
  const Scratch s;
  const std::string good = s.write("good.ngc", kGood);
  const std::vector<std::vector<std::string>> wrong = {{},
                                                       {"--nonsense", good},
                                                       {"check"},
                                                       {"--format", "yaml", good},
                                                       {"--fail-on", "fatal", good},
                                                       {"--jobs", "many", good},
                                                       {"--feature", "many", good},
                                                       {"--linuxcnc", "2.6", good},
                                                       {"--select", "OW99", good},
                                                       {"--ignore", "XX", good},
                                                       {"--severity", "OW104", good},
                                                       {"--severity", "OW104=fatal", good},
                                                       {"--severity", "OW999=off", good},
                                                       {"--color", "pink", good},
                                                       {"--config", s.path() + "/none.toml", good},
                                                       {"--ini", s.path() + "/none.ini", good},
                                                       {"graph"},
                                                       {"graph", s.path() + "/none.ngc"},
                                                       {"graph", "--format", "png", good},
                                                       {"explain"},
                                                       {"explain", "OW999"},
                                                       {"rules", "--format", "yaml"},
                                                       {"rules", "more"}};
  for (const auto& arguments : wrong) {
    const Run r = run(arguments);
    std::string shown;
    for (const std::string& a : arguments) shown += " " + a;
    INFO("owlint" << shown << "\n" << r.out << r.err);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK_FALSE(r.err.empty());
  }
}

TEST_CASE("an unknown option is named, also where it took the place of a path", "[cli]") {
  CHECK(run({"-x.ngc"}).err ==
        "owlint: unknown option `-x.ngc`; `--help` lists all, and what comes after `--` is a path\n");
  CHECK(run({"--selct", "OW1", "a.ngc"}).err == "owlint: unknown option `--selct`, did you mean `--select`?\n");
  CHECK(contains(run({"check"}).err, "needs PATH"));
}

TEST_CASE("a path in a report is the file's, line ends and all", "[cli]") {
  const Scratch s;
  const std::string path = s.write("a\nb.ngc", kBad);
  CHECK(nlohmann::json::parse(run({"--isolated", "--format", "json", path}).out)["files"][0]["path"] == path);
  CHECK(nlohmann::json::parse(run({"--isolated", "--format", "jsonl", path}).out)["path"] == path);
}

TEST_CASE("help and version are asked for", "[cli]") {
  CHECK(run({"--version"}).out.starts_with("owlint "));
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"--help"}, {"check", "--help"}, {"graph", "--help"}, {"rules", "-h"}}) {
    const Run r = run(arguments);
    CHECK(r.status == 0);
    CHECK(contains(r.out, "owlint"));
    CHECK(r.err.empty());
  }
}

TEST_CASE("standard input has a name", "[cli]") {
  const Run r = run({"--isolated", "-"}, kBad);
  CHECK(r.status == 1);
  CHECK(contains(r.out, "<stdin>:3:1: error"));
  CHECK(contains(run({"--isolated", "--stdin-filename", "part.ngc", "-"}, kBad).out, "part.ngc:3:1: error"));
  CHECK(run({"--isolated", "-"}, kGood).status == 0);
}

TEST_CASE("the configuration of a named standard input is the one of its folder", "[cli]") {
  const Scratch s;
  s.write("owlint.toml", "ignore = [\"OW104\"]\n");
  CHECK(run({"--stdin-filename", s.path() + "/part.ngc", "-"}, kBad).status == 0);
}

TEST_CASE("what cannot be read does not keep the rest from being checked", "[cli]") {
  const Scratch s;
  const std::string bad = s.write("bad.ngc", kBad);
  const std::string fifo = s.path() + "/fifo.ngc";
  REQUIRE(::mkfifo(fifo.c_str(), 0600) == 0);
  const std::string locked = s.write("locked.ngc", kGood);
  REQUIRE(::chmod(locked.c_str(), 0) == 0);
  for (const std::string& path : {s.path() + "/none.ngc", fifo, std::string("/dev/null"), locked}) {
    if (path == locked && ::geteuid() == 0) continue;  // root reads everything
    const Run r = run({"--isolated", path, bad});
    INFO(path << "\n" << r.err);
    CHECK(r.status == 2);
    CHECK(contains(r.err, path));
    CHECK(contains(r.out, "bad.ngc:3:1: error"));
    CHECK(r.seconds < 5 * OWLINT_PATIENCE);
  }
}

TEST_CASE("a folder takes its programs, and one without any is an error, unless it may be empty", "[cli]") {
  const Scratch s;
  s.write("programs/a.ngc", kGood);
  s.write("programs/deep/b.NC", kBad);
  s.write("programs/readme.txt", kBad);
  const Run r = run({"--isolated", s.path() + "/programs"});
  CHECK(r.status == 1);
  CHECK(contains(r.out, "deep/b.NC:3:1"));
  CHECK_FALSE(contains(r.out, "readme.txt"));
  CHECK(contains(r.err, "in 2 files"));
  std::filesystem::create_directory(s.path() + "/empty");
  const Run none = run({"--isolated", s.path() + "/empty"});
  CHECK(none.status == 2);
  CHECK(contains(none.err, "no programs in "));
  CHECK(none.out.empty());
  CHECK(run({"fmt", s.path() + "/empty"}).status == 2);
  const Run allowed = run({"--isolated", "--allow-empty", s.path() + "/empty"});
  CHECK(allowed.status == 0);
  CHECK(allowed.err.empty());
  const Run both = run({"--isolated", s.path() + "/empty", s.path() + "/programs"});  // the rest is still checked
  CHECK(both.status == 2);
  CHECK(contains(both.out, "deep/b.NC:3:1"));
}

TEST_CASE("a file given twice is checked once", "[cli]") {
  const Scratch s;
  const std::string bad = s.write("bad.ngc", kBad);
  CHECK(contains(run({"--isolated", bad, bad}).err, "in 1 file"));
}

TEST_CASE("a binary file is a program that stops", "[cli]") {
  const Scratch s;
  const std::string binary = s.write("binary.ngc", read_file(OWLINT_PROGRAM).substr(0, 1 << 20));
  const Run r = run({"--isolated", "--format", "json", binary});
  CHECK(r.status == 1);
  CHECK(nlohmann::json::parse(r.out)["summary"]["errors"].get<int>() >= 1);
}

TEST_CASE("the report goes to a file when asked", "[cli]") {
  const Scratch s;
  const std::string bad = s.write("bad.ngc", kBad);
  const std::string report = s.path() + "/report.json";
  const Run r = run({"--isolated", "--format", "json", "--output", report, bad});
  CHECK(r.status == 1);
  CHECK(r.out.empty());
  CHECK(read_file(report) == run({"--isolated", "--format", "json", bad}).out);
  CHECK(run({"--isolated", "--output", s.path() + "/no/folder", bad}).status == 2);
}

TEST_CASE("rules are selected on the command line", "[cli]") {
  const auto count = [](const std::string& options) { return findings_of(kBad, options).size(); };
  CHECK(count("") == 1);
  CHECK(count("--select OW2") == 0);
  CHECK(count("--select OW2,OW104") == 1);
  CHECK(count("--ignore OW1") == 0);
  CHECK(count("--select OW1 --ignore OW104") == 0);
  CHECK(count("--severity OW104=off") == 0);
  CHECK(findings_of(kBad, "--severity OW104=info")[0]["severity"] == "info");
  CHECK(findings_of("O1 if [1]\nO1 endif\nM2\n", "").empty());
  CHECK(findings_of("O1 if [1]\nO1 endif\nM2\n", "--extend-select OW311").size() == 2);
}

TEST_CASE("one finding a line and figures at the end", "[cli]") {
  const Scratch s;
  s.write("a.ngc", kBad);
  s.write("b.ngc", kBad);
  s.write("c.ngc", kWarning);
  const Run r = run({"--isolated", "--format", "jsonl", "--statistics", s.path()});
  std::istringstream lines(r.out);
  size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) CHECK(nlohmann::json::parse(line).contains("path"));
  CHECK(count == 3);
  CHECK(contains(r.err, "      2  OW104  if-label-reused\n      1  OW304  text-after-oword\n      3  reports, "));
}

TEST_CASE("colours only where they are wanted", "[cli]") {
  const Run always = run({"--isolated", "--color", "always", "-"}, kBad);
  CHECK(contains(always.out, "\x1b["));
  CHECK_FALSE(contains(run({"--isolated", "-"}, kBad).out, "\x1b["));
  CHECK_FALSE(contains(run({"--isolated", "--color", "never", "-"}, kBad).out, "\x1b["));
  CHECK_FALSE(contains(run({"--isolated", "--color", "always", "--format", "json", "-"}, kBad).out, "\x1b["));
}

TEST_CASE("two runs and any number of jobs give the same report", "[cli]") {
  for (const char* format : {"json", "text"}) {
    const auto report = [&](const char* jobs) {
      return run({"--isolated", "--format", format, "--jobs", jobs, repository("tests/programs"), repository("corpus")})
          .out;
    };
    const std::string one = report("1");
    CHECK_FALSE(one.empty());
    CHECK(one == report("1"));
    CHECK(one == report("8"));
  }
}

TEST_CASE("explain takes codes and names in any case", "[cli]") {
  const std::string page = run({"explain", "OW104"}).out;
  CHECK(contains(page, "LinuxCNC says: `duplicate O-word label"));
  CHECK(run({"explain", "if-label-reused"}).out == page);
  CHECK(run({"explain", "ow104"}).out == page);
  CHECK(contains(run({"explain", "OW1O4"}).err, "did you mean `OW104`"));
}

TEST_CASE("every rule can be explained", "[cli]") {
  for (const auto& rule : nlohmann::json::parse(run({"rules", "--format", "json"}).out)) {
    const Run r = run({"explain", rule["code"].get<std::string>()});
    CHECK(r.status == 0);
    CHECK(contains(r.out, rule["name"].get<std::string>()));
  }
}

TEST_CASE("a global that the leading comment speaks of is only info", "[cli]") {
  // No fixture: the interpreter that runs fixtures has no operator who sets it.
  const Scratch files;
  const std::string needed =
      files.write("needed.ngc", "(needs #<_Stock_Top>, set by the operator)\nG0 Z[#<_stock_top> + 5]\nM2\n");
  CHECK(run({"check", "--isolated", needed}).out.find("info `#<_stock_top>`") != std::string::npos);
  const std::string later = files.write("later.ngc", "G21\n(needs #<_stock_top>)\nG0 Z[#<_stock_top> + 5]\nM2\n");
  CHECK(run({"check", "--isolated", later}).out.find("warning `#<_stock_top>`") != std::string::npos);
}

TEST_CASE("graphs say what subs do with parameters", "[cli]") {
  const Scratch files;
  const std::string path =
      files.write("p.ngc",
                  "o100 sub\n  #<_result> = [#1 + #<_x_start> + #31]\n  o110 if [#2 GT 0]\n    o100 return\n  o110 "
                  "endif\n  #3 = 5\n  G0 X#3\no100 endsub [#1]\n#<_x_start> = 3\no100 call [1] [2]\nM2\n");
  const nlohmann::json graph = nlohmann::json::parse(run({"graph", "--format", "json", path}).out);
  CHECK(
      graph["scopes"][1]["summary"] ==
      nlohmann::json::parse(
          R"({"arguments": [1, 2], "computed": false, "reads": ["#<_x_start>", "#31"], "writes": ["#<_result>"], "returns": "sometimes"})"));
  CHECK(graph["scopes"][0]["summary"]["writes"] == nlohmann::json::parse(R"(["#<_x_start>"])"));
  const std::string broken = files.write("q.ngc", "o100 sub\n  o110 if [#1 GT 0]\no100 endsub\nM2\n");
  CHECK(nlohmann::json::parse(run({"graph", "--format", "json", broken}).out)["scopes"][1]["summary"].is_null());
}

TEST_CASE("graphs of all fixtures are well formed", "[cli]") {
  for (const std::string& path : files_below(repository("corpus"))) {
    if (!path.ends_with(".ngc")) continue;
    INFO(path);
    const nlohmann::json graph = nlohmann::json::parse(run({"graph", "--format", "json", path}).out);
    CHECK(graph["schema"] == "owlint-graph-1");
    const size_t scopes = graph["scopes"].size();
    const size_t blocks = graph["blocks"].size();
    for (const auto& block : graph["blocks"]) {
      CHECK(block["scope"].get<size_t>() < scopes);
      if (!block["parent"].is_null()) CHECK(block["parent"].get<size_t>() < blocks);
      if (!block["end"].is_null()) CHECK(block["end"].get<int>() > block["line"].get<int>());
    }
    for (const auto& call : graph["calls"]) {
      CHECK(call["from"].get<size_t>() < scopes);
      if (!call["to"].is_null()) CHECK(call["to"].get<size_t>() < scopes);
    }
    const Run dot = run({"graph", path});
    CHECK(dot.status == 0);
    CHECK(dot.out.starts_with("digraph "));
    CHECK(std::ranges::count(dot.out, '{') == std::ranges::count(dot.out, '}'));
    CHECK(run({"graph", "--format", "mermaid", path}).out.starts_with("flowchart "));
  }
}

}  // namespace command_line_test
