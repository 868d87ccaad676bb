// Text for people: colours, narrow terminals, wide characters.
#include <sstream>

#include <catch2/catch.hpp>

#include "analyzer/report/formats.h"
#include "analyzer/report/markdown.h"
#include "analyzer/report/snippet.h"
#include "analyzer/text/width.h"
#include "rules/driver/lint.h"
#include "support/files.h"
#include "support/process.h"

using namespace owlint;
using namespace owlint::test;

namespace terminal_test {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// What is marked in a line, with the part between « and » as the span.
Snippet marked(std::string line, size_t room = 60) {
  const size_t begin = line.find("«");
  line.erase(begin, 2);
  const size_t end = line.find("»");
  line.erase(end, 2);
  return snippet(*Source::own("p.ngc", line + "\n"), {begin, end}, room);
}

size_t widest(const std::string& text) {
  size_t most = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) most = std::max(most, columns(line));
  return most;
}

/// A command in a terminal of so many columns; its lines end in CR LF.
Run in_terminal(size_t width, const std::string& command, const std::string& folder) {
  return shell("script -qec \"stty cols " + std::to_string(width) + "; " + command + "\" /dev/null < /dev/null",
               folder);
}

const std::string kBad = "o1 if [1]\no1 endif\no1 if [1]\no1 endif\nM2\n";

}  // namespace

TEST_CASE("how many columns text takes", "[terminal]") {
  CHECK(columns("abc") == 3);
  CHECK(columns("点検") == 4);
  CHECK(columns("e\xCC\x81") == 1);  // with a combining accent
  CHECK(columns("🔧") == 2);
  CHECK(columns("👩‍🔧") == 2);  // several code points, one character
  CHECK(columns("🇩🇪") == 2);
  CHECK(columns("ａ") == 2);  // full width
  CHECK(columns("\x1b[1;31mred\x1b[0m") == 3);
  CHECK(columns("±°µ") == 3);
}

TEST_CASE("marks stand under what they mean", "[terminal]") {
  const auto check = [](const std::string& line, size_t pad, size_t width) {
    INFO(line);
    const Snippet shown = marked(line);
    CHECK(shown.pad == pad);
    CHECK(shown.marked == width);
  };
  check("«o1» if", 0, 2);
  check("(点検) «o1» if", 7, 2);
  check("(🔧) «o1» if", 5, 2);
  check("(e\xCC\x81) «o1» if", 4, 2);
  check("(\xB0) «o1» if", 4, 2);  // Latin-1
  check("\t«o1» if", 8, 2);
  check("a\t«o1»\tif", 8, 2);
  check("«a\tb»", 0, 9);
  check("o1 if «[点]»", 6, 4);
  check("o1 if«»", 5, 1);
  CHECK(marked("a\t«o1» if").text == "a       o1 if");
}

TEST_CASE("long lines are cut around what is meant, with marks", "[terminal]") {
  const std::string filler(200, 'x');
  const Snippet right = marked("«o1» " + filler, 40);
  CHECK(right.text == "o1 " + std::string(36, 'x') + "…");
  CHECK(right.pad == 0);
  const Snippet left = marked("(" + filler + ") «o1»", 40);
  CHECK(left.text.starts_with("…x"));
  CHECK(left.text.ends_with(" o1"));
  CHECK(columns(left.text) <= 40);
  CHECK(left.pad == columns(left.text) - 2);
  const Snippet both = marked("(" + filler + ") «o1» " + filler, 40);
  CHECK(both.text.starts_with("…"));
  CHECK(both.text.ends_with("…"));
  CHECK(columns(both.text) <= 40);
  CHECK(std::string(both.text).substr(both.text.find("o1"), 2) == "o1");
  CHECK(columns(both.text.substr(0, both.text.find("o1"))) == both.pad);
  std::string wide;
  for (int i = 0; i < 100; ++i) wide += "点";
  const Snippet cut = marked("(" + wide + ") «o1» (" + wide + ")", 41);
  CHECK(columns(cut.text) <= 41);
  CHECK(columns(cut.text.substr(0, cut.text.find("o1"))) == cut.pad);
  const Snippet all = marked("«" + filler + "»", 40);  // longer than there is room
  CHECK(columns(all.text) == 40);
  CHECK(all.pad + all.marked <= 40);
}

TEST_CASE("lines break at blanks", "[terminal]") {
  CHECK(wrapped("one two three", 8, "  ") == "one two\n  three");
  CHECK(wrapped("one two three", 0, "  ") == "one two three");
  CHECK(wrapped("one two", 8, "", 5) == "one\ntwo");
  CHECK(wrapped("averylongword x", 5, " ") == "averylongword\n x");
  CHECK(wrapped("点検 点検", 6, "") == "点検\n点検");
}

TEST_CASE("reports fit a narrow terminal", "[terminal]") {
  const auto source = Source::own("a.ngc",
                                  "o1 if [1] (a comment that goes on and on, and then on again)\no1 endif\no1 if [1] "
                                  "(a comment that goes on and on, and then on again)\no1 endif\nM2\n");
  const std::vector<FileReport> reports{lint(source, Profile{}, LintOptions{})};
  REQUIRE(reports[0].findings.size() == 1);
  for (const size_t width : {40U, 60U, 80U}) {
    std::ostringstream out;
    write_text_report(out, reports, {true, "", width});
    INFO(out.str());
    CHECK(widest(out.str()) <= width);
    CHECK(contains(out.str(), "…") == (width < 70));
  }
  std::ostringstream wide;
  write_text_report(wide, reports, {false, "", 0});
  CHECK(contains(wide.str(), "on again)\n"));
}

TEST_CASE("marks stay in place below a line number of any length", "[terminal]") {
  const auto source = Source::own("a.ngc", std::string(123455, '\n') + "o1 endif\nM2\n");
  const std::vector<FileReport> reports{lint(source, Profile{}, LintOptions{})};
  std::ostringstream out;
  write_text_report(out, reports, {false, "", 0});
  CHECK(contains(out.str(), "123456 | o1 endif\n       | ^"));
}

TEST_CASE("Markdown for terminals", "[terminal]") {
  const std::string page =
      "# Title\n\nSome `code` and **more** words that\ngo on.\n\n```\no1 if [1]\n  G0\n```\n\n| a | b |\n|---|---|\n| "
      "one | a cell with `code` in it |\n| two | x |\n\n- first\n- second\n\n1. one\n";
  CHECK(render_markdown(page, false, 30) ==
        "Title\n\nSome `code` and more words\nthat go on.\n\n    o1 if [1]\n      G0\n\na    b\n---  "
        "------------------------\none  a cell with `code` in it\ntwo  x\n\n- first\n- second\n\n1. one\n");
  const std::string colored = render_markdown(page, true, 30);
  CHECK(contains(colored, "\x1b[1;4mTitle\x1b[0m"));
  CHECK(contains(colored, "Some \x1b[36mcode\x1b[0m and \x1b[1mmore\x1b[0m"));
  CHECK_FALSE(contains(colored, "`"));
  for (const size_t width : {24U, 30U, 50U}) {
    CHECK(widest(render_markdown(page, false, width)) <= width);
    CHECK(widest(render_markdown(page, true, width)) <= width);
  }
}

TEST_CASE("explain shows its page in a terminal's colours, and plainly elsewhere", "[cli][terminal]") {
  const Scratch s;
  const std::string plain = owlint::test::owlint({"explain", "OW104"}).out;
  CHECK_FALSE(contains(plain, "\x1b["));
  CHECK_FALSE(contains(plain, "```"));
  CHECK_FALSE(contains(plain, "# "));
  CHECK(plain.starts_with("OW104 if-label-reused\n"));
  CHECK(contains(plain, "\n    o100 if [#5070 EQ 1]\n"));
  const Run terminal = in_terminal(60, "$OWLINT explain OW104", s.path());
  CHECK(contains(terminal.out, "\x1b[1;4mOW104 if-label-reused\x1b[0m"));
  CHECK(contains(owlint::test::owlint({"explain", "--color", "always", "OW104"}).out, "\x1b["));
}

TEST_CASE("colours are for terminals that have them", "[cli][terminal]") {
  const Scratch s;
  s.write("bad.ngc", kBad);
  const auto colored = [&](const std::string& environment) {
    const Run run = in_terminal(80, "export TERM=xterm; " + environment + " $OWLINT --isolated bad.ngc", s.path());
    INFO(run.out);
    CHECK(contains(run.out, "bad.ngc:3:1:"));
    return contains(run.out, "\x1b[");
  };
  CHECK(colored(""));
  CHECK_FALSE(colored("NO_COLOR=1"));
  CHECK_FALSE(colored("TERM=dumb"));
  CHECK(colored("NO_COLOR="));
}

TEST_CASE("what is written is as wide as the terminal", "[cli][terminal]") {
  const Scratch s;
  s.write("bad.ngc", kBad);
  for (const char* command : {"$OWLINT --isolated --color never bad.ngc", "$OWLINT explain --color never OW208",
                              "$OWLINT check --help", "$OWLINT rules"}) {
    std::string out = in_terminal(60, command, s.path()).out;
    std::erase(out, '\r');
    INFO(command << "\n" << out);
    CHECK(out.size() > 100);
    CHECK(widest(out) <= 60);
  }
}

}  // namespace terminal_test
