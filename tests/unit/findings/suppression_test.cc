// Comments that suppress findings.
#include <catch2/catch.hpp>

#include "analyzer/findings/suppression.h"
#include "rules/driver/lint.h"

using namespace owlint;

namespace {

std::vector<Suppression> parse(const std::string& words, uint32_t line = 5, bool own_line = true) {
  const auto source = Source::own("p.ngc", words);
  return parse_suppressions(*source, {0, words.size()}, line, own_line, suppressed_code);
}

/// `line code` of all findings.
std::vector<std::string> found(const std::string& program) {
  const FileReport report = lint(Source::own("p.ngc", program), Profile{}, LintOptions{});
  std::vector<std::string> out;
  for (const Finding& f : report.findings)
    out.push_back(std::to_string(report.source->position(f.span.begin).line) + " " + std::string(f.code));
  return out;
}

using Found = std::vector<std::string>;

}  // namespace

TEST_CASE("words of a suppression", "[suppression]") {
  const auto list = parse(" ignore OW301, ow5 -- the post writes it so");
  REQUIRE(list.size() == 2);
  CHECK(list[0].code == "OW301");
  CHECK(list[0].line == 6);
  CHECK(list[0].span == Span{8, 13});
  CHECK(list[1].code == "OW5");
  CHECK(parse(" ignore OW301", 5, false)[0].line == 5);
  CHECK(parse(" ignore-file OW5")[0].line == 0);
  CHECK(parse(" ignore").size() == 1);
  CHECK(parse(" ignore")[0].code.empty());
  CHECK(parse(" ignore -- all of it")[0].code.empty());
  CHECK(parse(" IGNORE ow301")[0].code == "OW301");
  CHECK(parse(" ignroe OW1")[0].malformed);
  CHECK(parse("")[0].malformed);
  CHECK(parse(" -- why")[0].malformed);
}

TEST_CASE("codes of a suppression may be small or names, and the words behind them are the reason", "[suppression]") {
  const auto codes = [](const std::string& words) {
    Found out;
    for (const Suppression& s : parse(words)) out.push_back(s.code);
    return out;
  };
  CHECK(codes(" ignore ow104") == Found{"OW104"});
  CHECK(codes(" ignore if-label-reused, OW3") == Found{"OW104", "OW3"});
  CHECK(codes(" ignore IF-LABEL-REUSED") == Found{"OW104"});
  CHECK(codes(" ignore OW104 because the clamp is closed") == Found{"OW104"});
  CHECK(codes(" ignore OW104, OW301: left-over from the post") == Found{"OW104", "OW301"});
  CHECK(codes(" ignore OW104 (owner: Ann)") == Found{"OW104"});
  // What was meant for a code and is none is not taken for a reason.
  CHECK(codes(" ignore this line") == Found{"this"});
  CHECK(codes(" ignore if-lable-reused") == Found{"if-lable-reused"});
  CHECK(codes(" ignore OW104 ow1o5 why") == Found{"OW104", "OW1O5"});
  CHECK(codes(" ignore OW104 if-lable-reused") == Found{"OW104", "if-lable-reused"});
}

TEST_CASE("a suppression on its own line suppresses the next one", "[suppression]") {
  CHECK(found("o1 if [0]\no1 endif done\nM2\n") == Found{"2 OW304"});
  CHECK(found("o1 if [0]\n(owlint: ignore OW304 -- old post)\no1 endif done\nM2\n").empty());
  CHECK(found("o1 if [0]\n; owlint: ignore OW3\no1 endif done\nM2\n").empty());
  CHECK(found("o1 if [0]\n(owlint: ignore OW301)\no1 endif done\nM2\n") == Found{"2 OW002", "3 OW304"});
  CHECK(found("o1 if [0]\n(owlint: ignore)\no1 endif done\nM2\n").empty());
}

TEST_CASE("a suppression for the file may stand anywhere", "[suppression]") {
  CHECK(found("o1 if [0]\no1 endif done\nM2\n(owlint: ignore-file OW304)\n").empty());
  CHECK(found("; owlint: ignore-file\no1 if [0]\no1 endif done\nM2\n").empty());
}

TEST_CASE("a suppression that suppresses nothing is a finding", "[suppression]") {
  CHECK(found("(owlint: ignore OW104)\nG0 X1\nM2\n") == Found{"1 OW002"});
  CHECK(found("(owlint: ignore OW999)\nG0 X1\nM2\n") == Found{"1 OW001"});
  CHECK(found("(owlint: silence OW104)\nG0 X1\nM2\n") == Found{"1 OW001"});
  CHECK(found("(owlint: ignore this line)\no1 if [0]\no1 endif done\nM2\n") == Found{"1 OW001", "3 OW304"});
  CHECK(found("o1 if [0]\n(owlint: ignore text-after-oword because the post writes it)\no1 endif done\nM2\n").empty());
}

TEST_CASE("one comment may suppress several rules on its line", "[suppression]") {
  CHECK(found("(owlint: ignore OW104 OW304)\no1 if [0]\no1 endif\nM2\n") == Found{"1 OW002", "1 OW002"});
}
