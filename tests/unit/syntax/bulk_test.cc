// The fast path of the scanner: it keeps what reading line by line keeps, and passes no line that may stop.
#include <random>

#include <catch2/catch.hpp>

#include "analyzer/syntax/bulk.h"
#include "analyzer/syntax/modes_in_effect.h"
#include "support/files.h"

using namespace owlint;

namespace {

std::string told(std::span<const ModeChange> changes) {
  std::string out;
  for (const ModeChange& change : changes)
    out += " " + std::string(mode_name(change.mode)) + "=" + std::to_string(change.value);
  return out;
}

/// What statements say of words, one line for each.
std::vector<std::string> told(const Syntax& syntax) {
  std::vector<std::string> out{"first" + told(syntax.first_changes)};
  for (StatementId id = 0; id < syntax.statements.size(); ++id) {
    const Statement& s = syntax.statements[id];
    if (s.kind == LineKind::kUserCode || s.kind == LineKind::kMachineCheck) continue;  // the scanner adds them
    std::string one = std::to_string(s.line) + " kind " + std::to_string(static_cast<int>(s.kind));
    if (!s.has_error()) one += told(syntax.changes_after(id));
    if (const LineError* error = syntax.error(s)) one += " " + error->message;
    if (s.kind == LineKind::kModeLine) {
      for (const ModeWord& word : syntax.words_of(s))
        one += " " + std::string(1, word.letter) + std::to_string(word.value);
    }
    out.push_back(one);
    if (s.has_error()) break;  // no run goes on to the lines behind it
  }
  return out;
}

/// The same, each line by the parser: what the fast path is held against.
std::vector<std::string> told_line_by_line(const std::string& text) {
  Syntax syntax;
  LineParser parser(syntax);
  const MachineWords machine;
  ModesInEffect modes(syntax, parser, machine);
  uint32_t number = 0;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size());
    Statement s;
    s.line = ++number;
    bool keep = parser.parse(std::string_view(text).substr(at, end - at), at, &s);
    keep = modes.judge(s, keep);
    if (keep) modes.push(s);
    at = end + 1;
  }
  modes.finish();
  return told(syntax);
}

/// What is told first of the one and not of the other.
std::string difference(const std::vector<std::string>& fast, const std::vector<std::string>& slow) {
  const auto [a, b] = std::mismatch(fast.begin(), fast.end(), slow.begin(), slow.end());
  return a == fast.end() && b == slow.end()
      ? ""
      : "fast: " + (a == fast.end() ? "-" : *a) + "\nline by line: " + (b == slow.end() ? "-" : *b);
}

/// Lines as in programs, most of them plain, and such that are nearly plain.
std::string random_lines(std::mt19937& random) {
  static const std::vector<std::string> kWords = {
      "G0", "G1",    "G2", "G03",   "X1",  "Y-2.5", "Z.5",   "F100",    "S200",   "I1", "J-1", "K0",  "R5", "A1",
      "B2", "C3",    "X1", "Y2",    "G1",  "N10",   "G81",   "G80",     "G90",    "M3", "P1",  "Q2",  "U1", "F-1",
      "X",  "X1..2", "G4", "X1 0",  "G 1", "x+5.",  "G01.5", "L1",      "H1",     "T1", "D1",  "G28", "X.", "(c)",
      "(c", "/",     ";c", "(d e)", "N1.", "F0.5",  "F05",   "(msg,c)", "X1.2.3", "-",  "G10", "g00"};
  std::string text;
  const auto lines = random() % 12;
  for (size_t i = 0; i <= lines; ++i) {
    const auto usual = random() % 3;
    const auto words = random() % 5;
    if (random() % 8 == 0) text += "N" + std::to_string(random() % 100'000);
    for (size_t w = 0; w < words; ++w) {
      text += kWords[random() % (usual != 0 ? 19 : kWords.size())];
      text += std::vector<std::string>{"", " ", "\t", " "}[random() % 4];
    }
    if (random() % 30 == 0) text += "o1 if [#1]";
    if (random() % 50 == 0) text += "X" + std::string(random() % 260, '5');
    text += random() % 10 == 0 ? "\r\n" : "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("the fast path keeps what reading line by line keeps", "[bulk]") {
  std::mt19937 random(4711);
  size_t different = 0;
  for (int i = 0; i < 50'000; ++i) {
    const std::string text = random_lines(random);
    if (text.find(std::string(200, '5')) != std::string::npos || text.find("msg") != std::string::npos) continue;
    const Syntax fast = scan(*Source::own("p.ngc", text));
    if (told(fast) == told_line_by_line(text)) continue;
    if (++different != 1) continue;
    UNSCOPED_INFO("first difference in text " << i << ":\n" << text);
    for (const std::string& line : told(fast)) UNSCOPED_INFO("fast: " << line);
    for (const std::string& line : told_line_by_line(text)) UNSCOPED_INFO("line by line: " << line);
  }
  CHECK(different == 0);
}

TEST_CASE("the fast path keeps of files what reading line by line keeps", "[bulk]") {
  size_t compared = 0;
  for (const char* folder : {"tests/programs", "corpus", "tests/interpreter/called"}) {
    for (const std::string& path : test::files_below(test::repository(folder))) {
      const std::string bytes = test::read_file(path);
      const bool long_lines = bytes.find(std::string(100, 'x')) != std::string::npos;
      if (long_lines || bytes.find('\0') != std::string::npos || bytes.starts_with("%")) continue;
      INFO(path);
      const Syntax fast = scan(*Source::own(path, bytes));
      if (std::ranges::any_of(fast.errors, [](const LineError& e) { return e.kind == StopKind::kLineTooLong; }))
        continue;
      // What the scanner adds to the parser's lines.
      if (std::ranges::any_of(fast.statements, [](const Statement& s) {
            return s.kind == LineKind::kAbort || s.kind == LineKind::kMachineCheck || s.kind == LineKind::kUserCode;
          }))
        continue;
      ++compared;
      CHECK(difference(told(fast), told_line_by_line(bytes)) == "");
    }
  }
  CHECK(compared > 400);
}

TEST_CASE("every kind of processor sorts bytes alike", "[bulk]") {
  constexpr std::string_view kOfPrograms = "0123456789.+-GXYZnf \t\r\n/:@[`{";
  std::mt19937 random(7);
  std::string bytes(ByteClasses::kBlock * ByteClasses::kBlocks, ' ');
  for (int i = 0; i < 200; ++i) {
    // All bytes, or those of programs.
    for (char& c : bytes) c = i % 2 == 0 ? static_cast<char>(random()) : kOfPrograms[random() % kOfPrograms.size()];
    const size_t first = random() % 4, blocks = ByteClasses::kBlocks - random() % 8 - first;
    ByteClasses expected;
    byte_classifiers().back().classify(bytes.data(), blocks, first, &expected);
    for (const ByteClassifier& by : byte_classifiers()) {
      ByteClasses classes;
      by.classify(bytes.data(), blocks, first, &classes);
      INFO(by.name);
      CHECK(classes == expected);
    }
  }
}

TEST_CASE("lines are read alike with vectors and one by one", "[bulk]") {
  std::mt19937 random(4712);
  size_t lines = 0, passed_lines = 0, different = 0;
  while (lines < 1'000'000) {
    std::string text;
    for (int i = 0; i < 50; ++i) text += random_lines(random);
    PlainLines one_by_one(text, nullptr);
    std::vector<PlainLines> others;
    for (const ByteClassifier& by : byte_classifiers()) others.emplace_back(text, &by);
    Proven proven;
    for (size_t at = 0; at < text.size();) {
      const Passed passed = one_by_one.pass(at, text.size(), proven);
      for (PlainLines& other : others) {
        if (other.pass(at, text.size(), proven) == passed) continue;
        if (++different == 1) UNSCOPED_INFO("first difference behind " << at << " in:\n" << text);
      }
      passed_lines += passed.lines;
      lines += passed.lines + 1;
      const size_t end = text.find('\n', passed.next);
      if (end == std::string::npos) break;
      proven = proven_after(std::string_view(text).substr(passed.next, end - passed.next), passed.proven);
      at = end + 1;
    }
  }
  CHECK(different == 0);
  CHECK(passed_lines > lines / 5);
}

TEST_CASE("what may matter is never passed over", "[bulk]") {
  Proven all;
  all.code = 1;
  all.straight[0] = all.arcs[0] = all.alone[0] = 0xFF;
  const auto stops_at = [](const std::string& text, const Proven& proven) {
    return PlainLines(text).pass(0, text.size(), proven).next;
  };
  for (const char* line :
       {"o100 sub", "  O1 if [1]", "G1 X1 (o", "M2",    "m30",   "%",      "N10 M98 P1", "/G0 X1",
        "#1=2",     "G0 X[1]",     "100 sub",  " 5",    "sub",   "if [1]", "G1 X1\rG0",  "\xEF\xBB\xBFG1",
        "G1 X\xE4", "G0 X1;(",     "$(x)",     "X1 X2", "G1 G0", "G1 I1",  "U1",         "G4",
        "X",        "X.",          "X1..",     "F-1",   "G5",    "G1.5",   "X1 2",       "R5",
        "N",        "N1. X1",      "G1 X1 F0", "A1",    "S0",    "F100",   "G2 X1 R5"}) {
    INFO(line);
    CHECK(stops_at(std::string("G1 X1\n") + line + "\nG1 X2\n", all) == 6);
  }
  CHECK(stops_at(std::string("G1 X1\nX") + std::string(252, '1') + "\nG1\n", all) == 6);
  CHECK(stops_at(std::string("G1 X1\nX") + std::string(251, '1') + "\nG1\n", all) == 6 + 253 + 3);
  for (const char* line :
       {"G1 X1 Y-2.5", "  X1", "", "  \t", "N10 G1 X1", "X1\r", "G1X1Y1", "S500", "G2 X1 I1", "g03x1y0r.5", "X1 F05"}) {
    INFO(line);
    const std::string text = std::string("G1 X1\n") + line + "\nG1 X2\n";
    CHECK(stops_at(text, all) == text.size());
  }
}

TEST_CASE("a plain line is passed where one like it has run", "[bulk]") {
  const auto passes = [](const char* line, std::initializer_list<const char*> before) {
    Proven proven;
    for (const char* one : before) proven = proven_after(one, proven);
    const std::string text = std::string(line) + "\n";
    return PlainLines(text).pass(0, text.size(), proven).lines == 1;
  };
  CHECK_FALSE(passes("G1 X1", {}));
  CHECK(passes("G1 X1", {"G1 Y2 (down)"}));
  CHECK(passes("G1 X1 F5", {"G1 Y2"}));
  CHECK_FALSE(passes("G1 X1", {"G1 Y2 F5"}));  // the feed mode may be one that wants F on every line
  CHECK_FALSE(passes("G1 X1", {"G0 Y2"}));
  CHECK_FALSE(passes("G1 X1", {"G1 Y2", "M5"}));
  CHECK(passes("X1", {"G1 Y2"}));
  CHECK(passes("X1", {"X2"}));
  CHECK_FALSE(passes("Y1", {"X2"}));  // the motion may be one that wants both
  CHECK_FALSE(passes("A1", {"A2"}));
  CHECK(passes("G2 X1 I1", {"G3 X2 I2"}));
  CHECK_FALSE(passes("G2 X1 J1", {"G3 X2 I2"}));
  CHECK_FALSE(passes("G2 X1 R1", {"G3 X2 R2"}));
  CHECK(passes("G2 X1 Y1 R1", {"G3 X2 Y2 R2"}));
}
