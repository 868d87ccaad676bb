// Inputs that nobody should give: they are checked as quickly as others, and every report stays valid.
#include <chrono>
#include <functional>
#include <iostream>
#include <random>
#include <set>

#include <fmt/ranges.h>
#include <catch2/catch.hpp>

#include "analyzer/report/formats.h"
#include "rules/driver/lint.h"
#include "support/files.h"
#include "support/process.h"

using namespace owlint;

namespace hostile_test {
namespace {

constexpr double kTooSlow = 10 * OWLINT_PATIENCE;  // seconds
constexpr int kMany =
    50'000 / OWLINT_PATIENCE;  // what goes quadratic shows in optimised programs; sanitizers need not wait for it

std::string repeat(int count, const std::function<std::string(int)>& line) {
  std::string out;
  for (int i = 1; i <= count; ++i) out += line(i);
  return out;
}

std::string lines(int count, const std::string& line) {
  return repeat(count, [&](int) { return line; });
}

/// Every position must be one of the file, and findings must be in order. One assertion: there may be many findings.
void check_report(const FileReport& report) {
  const uint64_t size = report.source->bytes().size();
  uint64_t last = 0;
  std::string wrong;
  const auto expect = [&](bool good, std::string_view what) {
    if (!good) wrong = what;
  };
  const auto inside = [&](Span span) {
    expect(span.begin <= span.end && span.end <= size, "a place outside the file");
  };
  for (const Finding& f : report.findings) {
    inside(f.span);
    expect(f.span.begin >= last, "findings out of order");
    last = f.span.begin;
    expect(!f.message.empty(), "no message");
    expect(f.severity != Severity::kOff, "a finding that is off");
    for (const Related& r : f.related) inside(r.span);
    for (const Consequence& c : f.consequences) inside(c.span);
    for (const Fix& fix : f.fixes) {
      for (const Edit& edit : fix.edits) inside(edit.span);
    }
  }
  std::ostringstream json;
  write_json(json, {report});
  expect(nlohmann::json::accept(json.str()), "JSON that is none");
  std::ostringstream text;
  write_text(text, report, {});
  REQUIRE(wrong == "");
}

/// Lints, checks the report and the time, and gives the codes that were found, each once.
std::string codes(const std::string& name, std::string bytes, const LintOptions& options = {}) {
  const auto started = std::chrono::steady_clock::now();
  const FileReport report = lint(Source::own("p.ngc", std::move(bytes)), Profile{}, options);
  check_report(report);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  std::cout << fmt::format("hostile: {:<28} {:6.2f} s, {} findings\n", name, seconds, report.findings.size());
  INFO(name << " took " << seconds << " s");
  if (seconds >= kTooSlow) WARN(name << " took " << seconds << " s");  // what hangs meets ctest's time limit
  std::set<std::string_view> found;
  for (const Finding& f : report.findings) found.insert(f.code);
  return fmt::format("{}", fmt::join(found, " "));
}

std::string label_block(int i) { return fmt::format("o{} if [#1 GT {}]\no{} endif\n", i, i, i); }

}  // namespace

TEST_CASE("files with nothing in them", "[hostile]") {
  CHECK(codes("empty", "") == "OW315");
  CHECK(codes("line feeds", "\n\n\n") == "OW315");
  CHECK(codes("comments", lines(1000, "(nothing here)\n") + "; nothing\n") == "OW315");
  CHECK(codes("percent", "%\n%\n").empty());
}

TEST_CASE("bytes that are no text", "[hostile]") {
  CHECK(codes("NUL", std::string(100000, '\0')).find("OW3") == 0);
  CHECK(codes("one line of 10 MB", std::string(10 << 20, 'G')) == "OW309");
  CHECK(codes("one open bracket line", "o1 if " + std::string(240, '[') + "\nM2\n") == "OW303");
  CHECK(codes("Latin-1",
              "(Fl\xE4"
              "che)\nG0 X1 ; gr\xFC\xDF"
              "e\nM2\n")
            .empty());
  CHECK(codes("BOM", "\xEF\xBB\xBFo1 if [1]\no1 endif\nM2\n").find("OW314") == 0);
  CHECK(codes("CR only", lines(20, "G0 X1\r") + "M2\r").find("OW314") == 0);
}

TEST_CASE("very many labels", "[hostile]") {
  CHECK(codes("ten times as many labels", repeat(10 * kMany, label_block) + "M2\n").empty());
  CHECK(codes("many duplicate labels", lines(kMany, "o1 if [#1 GT 0]\no1 endif\n") + "M2\n") == "OW104");
  CHECK(codes("many duplicates, constant", lines(kMany, "o1 if [1]\no1 endif\n") + "M2\n") == "OW104");
  CHECK(codes("many duplicate whiles", lines(kMany, "o1 while [#1 GT 0]\no1 endwhile\n") + "M2\n") == "OW103 OW508");
}

TEST_CASE("very deep nesting", "[hostile]") {
  const int n = kMany;
  const auto open = [](const char* keyword) {
    return [keyword](int i) { return fmt::format("o{} {}\n", i, keyword); };
  };
  const auto close = [](const char* keyword) {
    return [keyword](int i) { return fmt::format("o{} {}\n", kMany + 1 - i, keyword); };
  };
  CHECK(codes("many nested ifs", repeat(n, open("if [#5420 GT 0]")) + repeat(n, close("endif")) + "M2\n").empty());
  CHECK(codes("many nested whiles", repeat(n, open("while [#5420 GT 0]")) + repeat(n, close("endwhile")) + "M2\n")
            .empty());
  CHECK(codes("many ifs not closed", repeat(n, open("if [#1 GT 0]")) + "M2\n") == "OW205");
  CHECK(codes("many dos not closed", repeat(n, open("do")) + "M2\n") == "OW205");
  CHECK(codes("many ends", repeat(n, open("endif")) + "M2\n") == "OW106");
  CHECK(codes("many crossed", repeat(n, open("if [#1 GT 0]")) + repeat(n, open("endif")) + "M2\n").find("OW106") !=
        std::string::npos);
  CHECK(codes("many elses", "o1 if [#1 GT 0]\n" + lines(n, "o1 else\n") + "o1 endif\nM2\n") == "OW212");
  CHECK(codes("many elseifs",
              "o1 if [#5420 GT 0]\n" + repeat(n, [](int i) { return fmt::format("o1 elseif [#5070 EQ {}]\n", i); }) +
                  "o1 endif\nM2\n")
            .empty());
}

TEST_CASE("very many subs and calls", "[hostile]") {
  const int n = kMany;
  const std::string subs = repeat(n, [](int i) { return fmt::format("o{0} sub\nG0 X1\no{0} endsub\n", i); });
  CHECK(codes("many subs", subs + "M2\n").empty());
  CHECK(codes("many subs and calls", subs + repeat(n, [](int i) { return fmt::format("o{} call\n", i); }) + "M2\n")
            .empty());
  CHECK(
      codes("many calls of one",
            "o1 sub\nG0 X#1\no1 endsub\n" + repeat(n, [](int i) { return fmt::format("o1 call [{}]\n", i); }) + "M2\n")
          .empty());
  CHECK(codes("many calls of nothing", repeat(n, [](int i) { return fmt::format("o{} call\n", i); }) + "M2\n") ==
        "OW208");
  CHECK(
      codes("many nested subs", repeat(n, [](int i) { return fmt::format("o{} sub\n", i); }) + "M2\n").find("OW202") !=
      std::string::npos);
  CHECK(codes("a chain of many calls",
              repeat(n, [](int i) { return fmt::format("o{} sub\no{} call\no{} endsub\n", i, i + 1, i); }) +
                  "o1 call\nM2\n")
            .find("OW210") != std::string::npos);
  CHECK(codes("many wrong ends with the same labels",
              repeat(n, [](int i) { return fmt::format("o{0} sub\no1 if [#5070]\no2 endif\no{0} endsub\n", i + 10); }) +
                  repeat(n, [](int i) { return fmt::format("o{} call\n", i + 10); }) + "M2\n") == "OW104 OW106");
  CHECK(codes("many redefinitions", lines(n, "o1 sub\no1 endsub\n") + "M2\n") == "OW201");
}

TEST_CASE("very many values", "[hostile]") {
  const int n = kMany;
  CHECK(codes("many parameters",
              repeat(n, [](int i) { return fmt::format("#<p{0}> = {0}\n", i); }) +
                  repeat(n, [](int i) { return fmt::format("o{0} if [#<p{0}> GT 5]\no{0} endif\n", i); }) + "M2\n")
            .empty());
  CHECK(codes("many assignments in a loop",
              "o1 while [#5420 GT 0]\n" +
                  repeat(n, [](int i) { return fmt::format("#{0} = [#{0} + 1]\n", i % 5000 + 31); }) +
                  "o1 endwhile\nM2\n")
            .empty());
  CHECK(codes("many suppressions", lines(n, "(owlint: ignore OW104)\n") + "M2\n") == "OW002");
  CHECK(codes("many refused lines", lines(n, "G0 X[1+]\n") + "M2\n") == "OW303");
  CHECK(codes("loop of many passes", "#1 = 0\no1 while [#1 LT 100000]\n#1 = [#1 + 1]\no1 endwhile\nM2\n").empty());
}

TEST_CASE("random bytes", "[hostile]") {
  std::mt19937 random(7);
  LintOptions all;
  all.extend_select = {"OW"};
  for (int round = 0; round < 300; ++round) {
    std::string bytes(random() % 3000, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    check_report(lint(Source::own("p.ngc", bytes), Profile{}, all));
  }
}

TEST_CASE("random pieces of programs", "[hostile]") {
  const std::vector<std::string> pieces = {"o1 ",       "o2 ",      "o<a> ",      "O[#1] ",
                                           "o[1+1] ",   "sub",      "endsub",     "call",
                                           "do",        "while",    "repeat",     "if",
                                           "elseif",    "else",     "endif",      "break",
                                           "continue",  "endwhile", "endrepeat",  "return",
                                           " [1]",      " [0]",     " [#1 GT 2]", " [#<x>]",
                                           "\n",        "\n",       "\n",         "\r\n",
                                           "M2\n",      "%\n",      "#1=3\n",     "#<x>=1\n",
                                           "M98 P1\n",  "M99\n",    "(c)",        "(",
                                           ";x",        "/",        "N5 ",        "G0 X1\n",
                                           "[",         "]",        "\xE4",       "(owlint: ignore)\n",
                                           "#1=[1/0]\n"};
  std::mt19937 random(11);
  LintOptions all;
  all.extend_select = {"OW"};
  for (int round = 0; round < 4000; ++round) {
    std::string bytes;
    const size_t count = random() % 60;
    for (size_t i = 0; i < count; ++i) bytes += pieces[random() % pieces.size()];
    Profile profile;
    if (round % 3 == 0) profile.feature = 0x20;
    INFO(bytes);
    check_report(lint(Source::own("p.ngc", bytes), profile, all));
  }
}

TEST_CASE("the program itself takes hostile files", "[hostile]") {
  std::mt19937 random(13);
  std::string bytes(1 << 20, '\0');
  for (char& c : bytes) c = static_cast<char>(random());
  const auto run = test::owlint({"--isolated", "--format", "json", "-"}, bytes);
  CHECK(run.status == 1);
  CHECK(nlohmann::json::accept(run.out));
  if (run.seconds >= kTooSlow) WARN("took " << run.seconds << " s");
}

}  // namespace hostile_test
