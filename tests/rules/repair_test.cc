// Forgotten ends: each end of a block or sub in the sound programs of the corpus is deleted in turn. owlint must
// report one mistake, and where it says in which place the end is missing, that must be the place.
#include <iostream>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "analyzer/findings/severity.h"
#include "rules/driver/lint.h"
#include "support/corpus.h"
#include "support/files.h"

using namespace owlint;

namespace {

struct Deletion {
  std::string path;
  std::string text;     ///< the program without the line
  std::string what;     ///< `o100 endif`
  uint32_t line = 0;    ///< where it stood
  uint32_t opener = 0;  ///< the line of the `if`, `sub`...
  bool sub = false;
};

std::vector<Deletion> deletions() {
  std::vector<Deletion> out;
  for (const test::CorpusProgram& c : test::corpus()) {
    if (!c.sound) continue;
    const auto source = Source::own(c.path, test::read_file(c.path));
    const auto program = build_program(source);
    const auto add = [&](StatementId opener, StatementId end, bool sub) {
      const Statement& s = program->at(end);
      std::string text(source->bytes());
      text.erase(s.offset, s.end() + 1 - s.offset);
      out.push_back({c.path, std::move(text), program->head(end), s.line, program->at(opener).line, sub});
    };
    for (const Block& b : program->blocks) add(b.opener, b.end, false);
    for (const Region& r : program->regions) {
      if (r.opener != kNoStatement && program->at(r.opener).is(Keyword::kSub)) add(r.opener, r.end, true);
    }
  }
  return out;
}

/// Whether only blank lines and comments are between two lines of the program without the end.
bool same_place(const Source& source, uint32_t a, uint32_t b) {
  for (uint32_t line = std::min(a, b); line < std::max(a, b); ++line) {
    const std::string_view text = source.slice(source.line(line));
    const size_t first = text.find_first_not_of(" \t\r");
    if (first != std::string_view::npos && text[first] != ';' && text[first] != '(') return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a deleted end is one error at its block", "[repair]") {
  const std::vector<Deletion> all = deletions();
  REQUIRE(all.size() > 100);
  size_t single = 0;
  for (const Deletion& d : all) {
    const FileReport report = lint(Source::own(d.path, d.text), Profile{}, LintOptions{});
    std::string found;
    for (const Finding& f : report.findings) {
      found += fmt::format("  {} {} {}: {}\n", report.source->position(f.span.begin).line, severity_text(f.severity),
                           f.code, f.message);
    }
    INFO(fmt::format("{} without `{}` of line {}, opened on line {}:\n{}", d.path, d.what, d.line, d.opener, found));
    CHECK_FALSE(report.findings.empty());
    if (report.findings.size() == 1) ++single;
    CHECK(report.findings.size() == 1);
    if (report.findings.empty()) continue;
    // Where the condition is true the interpreter runs through to the end: a warning then.
    const Finding& f = report.findings[0];
    CHECK(f.severity == (f.stops ? Severity::kError : Severity::kWarning));
  }
  std::cout << fmt::format("bracket repair: {} ends deleted, {} give one finding\n", all.size(), single);
}

TEST_CASE("the place suggested for a deleted end is right", "[repair]") {
  size_t blocks = 0;
  size_t suggested = 0;
  size_t right = 0;
  for (const Deletion& d : deletions()) {
    if (d.sub) continue;
    ++blocks;
    const auto source = Source::own(d.path, d.text);
    const auto program = build_program(source);
    for (const Block& b : program->blocks) {
      if (b.end != kNoStatement || program->at(b.opener).line != d.opener || b.suggested_line == 0) continue;
      ++suggested;
      if (same_place(*source, b.suggested_line, d.line)) {
        ++right;
      } else if (std::getenv("OWLINT_VERBOSE") != nullptr) {
        std::cout << fmt::format("{} without `{}` of line {}: suggested line {}\n", d.path, d.what, d.line,
                                 b.suggested_line);
      }
    }
  }
  std::cout << fmt::format("bracket repair: of {} blocks a place is suggested for {}, right for {}\n", blocks,
                           suggested, right);
  CHECK(suggested * 100 >= blocks * 50);
  CHECK(right * 100 >= suggested * 90);
}
