// Fixes work: with any one of them made, the finding that it belongs to is gone; made twice, nothing changes any more.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "rules/driver/lint.h"
#include "support/corpus.h"
#include "support/files.h"
#include "support/fixture.h"

using namespace owlint;

namespace {

FileReport check(const std::string& text) {
  LintOptions all;
  all.extend_select = {"OW"};
  return lint(Source::own("program.ngc", text), {}, all);
}

std::string made(const std::string& text, const Fix& fix) {
  std::string out;
  size_t at = 0;
  std::vector<Edit> edits = fix.edits;
  std::ranges::sort(edits, {}, [](const Edit& e) { return e.span.begin; });
  for (const Edit& edit : edits) {
    REQUIRE(edit.span.begin >= at);  // edits of one fix do not overlap
    REQUIRE(edit.span.begin <= edit.span.end);
    REQUIRE(edit.span.end <= text.size());
    out += text.substr(at, edit.span.begin - at) + edit.text;
    at = edit.span.end;
  }
  return out + text.substr(at);
}

/// Findings of a rule, and those that another finding of it speaks for.
size_t count(const FileReport& report, std::string_view code) {
  size_t found = 0;
  for (const Finding& f : report.findings) {
    if (f.code == code) found += 1 + static_cast<size_t>(std::ranges::count(f.consequences, code, &Consequence::code));
  }
  return found;
}

}  // namespace

TEST_CASE("a fix takes its finding away", "[fixes]") {
  std::vector<std::string> paths;
  for (const test::CorpusProgram& c : test::corpus()) paths.push_back(c.path);
  for (const test::Fixture& f : test::all_fixtures()) {
    if (!f.bundle) paths.push_back(f.path);
  }
  std::map<std::string, size_t> fixes;
  for (const std::string& path : paths) {
    const std::string text = test::read_file(path);
    const FileReport before = check(text);
    for (const Finding& f : before.findings) {
      for (const Fix& fix : f.fixes) {
        ++fixes[std::string(f.code)];
        const std::string fixed = made(text, fix);
        INFO(path << ": " << f.code << " " << fix.title << "\n" << fixed);
        CHECK(fixed != text);
        CHECK(count(check(fixed), f.code) < count(before, f.code));
      }
    }
  }
  for (const char* code :
       {"OW001", "OW002", "OW101", "OW102", "OW103", "OW104", "OW105", "OW106", "OW107", "OW108", "OW202",
        "OW203", "OW204", "OW205", "OW206", "OW207", "OW208", "OW213", "OW214", "OW216", "OW301", "OW302",
        "OW304", "OW305", "OW307", "OW308", "OW310", "OW311", "OW312", "OW313", "OW315"}) {
    INFO(code);
    CHECK(fixes[code] > 0);
  }
}
