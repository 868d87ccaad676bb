// The language server's text: lines and positions under edits, tokens; and the formatter.
#include <random>

#include <catch2/catch.hpp>

#include "analyzer/format/indent.h"
#include "analyzer/lsp/document.h"
#include "analyzer/lsp/lexer.h"
#include "analyzer/lsp/parameter_uses.h"
#include "support/corpus.h"
#include "support/files.h"
#include "support/fixture.h"

using namespace owlint;
using lsp::Encoding;

namespace {

std::string indented(const std::string& text) {
  std::string out;
  size_t at = 0;
  for (const Edit& edit : indentation(*build_program(Source::own("p.ngc", text)), {})) {
    out += text.substr(at, edit.span.begin - at) + edit.text;
    at = edit.span.end;
  }
  return out + text.substr(at);
}

/// The lines as LinuxCNC sees them, without the blanks that they begin with.
std::string without_indent(const std::string& text) {
  std::string out;
  for (size_t at = 0; at < text.size();) {
    const size_t feed = std::min(text.find('\n', at), text.size());
    const size_t first = std::min(text.find_first_not_of(" \t", at), feed);
    out += text.substr(first, feed - first) + "\n";
    at = feed + 1;
  }
  return out;
}

std::vector<std::string> all_programs() {
  std::vector<std::string> out;
  for (const test::CorpusProgram& c : test::corpus()) out.push_back(test::read_file(c.path));
  for (const test::Fixture& f : test::all_fixtures()) out.push_back(test::read_file(f.path));
  return out;
}

}  // namespace

TEST_CASE("lines under random edits are those of the whole text", "[lsp]") {
  std::mt19937 random(42);
  const auto below = [&](size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random); };
  const std::vector<std::string> pieces = {"\n",         "\r\n", "\r", "G1 X1", "ä",      "€",
                                           "\U0001F600", "\xFF", "",   "\n\n",  "a\rb\nc"};
  std::string text = "G0\r\nG1\n";
  lsp::Lines lines(text);
  for (int i = 0; i < 20000; ++i) {
    const size_t from = below(text.size() + 1);
    const size_t to = from + below(std::min<size_t>(text.size() - from, 6) + 1);
    const std::string& piece = pieces[below(pieces.size())];
    text.replace(from, to - from, piece);
    lines.replaced(text, from, to, piece.size());
    if (text.size() > 300) {
      text.resize(150);
      lines = lsp::Lines(text);
    }
    const lsp::Lines fresh(text);
    REQUIRE(lines.count() == fresh.count());
    for (size_t line = 0; line < fresh.count(); ++line) REQUIRE(lines.start(line) == fresh.start(line));
  }
}

TEST_CASE("positions go to the protocol and back in every encoding", "[lsp]") {
  const std::string text = "(ä €\U0001F600) o1\nG1\r\n\r(\xFF)";
  for (const Encoding encoding : {Encoding::kUtf8, Encoding::kUtf16, Encoding::kUtf32}) {
    const lsp::Document document("file:///p.ngc", "/p.ngc", text, encoding);
    for (const size_t offset :
         {size_t{0}, size_t{1}, size_t{3}, size_t{4}, size_t{7}, size_t{11}, size_t{12}, text.size()}) {
      CHECK(document.offset(document.position(offset)) == offset);
    }
    CHECK(document.offset({{"line", 99}, {"character", 0}}) == text.size());
    CHECK(document.offset({{"line", 1}, {"character", 99}}) == text.find("G1") + 2);
  }
  const lsp::Document utf16("file:///p.ngc", "/p.ngc", text, Encoding::kUtf16);
  CHECK(utf16.position(text.find("o1")) == lsp::Json{{"line", 0}, {"character", 8}});
  const lsp::Document utf32("file:///p.ngc", "/p.ngc", text, Encoding::kUtf32);
  CHECK(utf32.position(text.find("o1")) == lsp::Json{{"line", 0}, {"character", 7}});
  const lsp::Document utf8("file:///p.ngc", "/p.ngc", text, Encoding::kUtf8);
  CHECK(utf8.position(text.find("o1")) == lsp::Json{{"line", 0}, {"character", 13}});
}

TEST_CASE("uris are paths and back", "[lsp]") {
  for (const char* path : {"/a b/ä.ngc", "/100%.ngc", "/plain.ngc", "/a#b?c.ngc"})
    CHECK(lsp::path_of_uri(lsp::uri_of_path(path)) == path);
  CHECK(lsp::path_of_uri("file:///C%3A/x") == "/C:/x");
  CHECK(lsp::path_of_uri("file://host/x%zz") == "/x%zz");
  CHECK(lsp::path_of_uri("untitled:1") == "untitled:1");
}

TEST_CASE("a line's tokens", "[lsp]") {
  const auto kinds = [](std::string_view line) {
    std::string out;
    for (const lsp::Token& t : lsp::tokenize(line))
      out += "CLKPNOFW"[static_cast<size_t>(t.kind)] + std::string(line.substr(t.begin, t.end - t.begin)) + "|";
    return out;
  };
  CHECK(kinds("o100 if [#1 GT 5] (c)") == "Lo100|Kif|P#1|OGT|N5|C(c)|");
  CHECK(kinds("  N10 O<Drill> call [#<depth>] ; x") == "WN10|LO<Drill>|Kcall|P#<depth>|C; x|");
  CHECK(kinds("G1 X[SIN[#3] * 2] F#<_feed>") == "WG1|WX|FSIN|P#3|O*|N2|WF|P#<_feed>|");
  CHECK(kinds("#<a> = [##2 + #[1]]") == "P#<a>|O=|P##2|O+|P#|N1|");
  CHECK(kinds("o#1 call") == "Lo|P#1|Wc|Wa|Wl|Wl|");
  CHECK(kinds("/G0") == "WG0|");
  CHECK(kinds("(open") == "C(open|");
}

TEST_CASE("the parameters of a line, as LinuxCNC reads them", "[lsp]") {
  const auto names = [](std::string_view line) {
    std::string out;
    for (const lsp::ParameterUse& use : lsp::parameter_uses(line)) {
      out += use.name.empty() ? "?" : use.name;
      out += std::string(use.assigned ? "=" : "") + (use.printed ? "!" : "") + "@" +
          std::string(line.substr(use.begin, use.end - use.begin)) + "|";
    }
    return out;
  };
  CHECK(names("#<depth> = [#1 + #<De PTH>]") == "<depth>=@#<depth>|1@#1|<depth>@#<De PTH>|");
  CHECK(names("G0 X#3.0 Y# 0 3 Z#5.") == "3@#3.0|3@# 0 3|5@#5.|");
  CHECK(names("##<a> = 1 #[#2 + 1] = 3") == "?@#|<a>=@#<a>|?@#|2@#2|");
  CHECK(names("o<#1> call [EXISTS[#<_b>]] ; #4") == "<_b>@#<_b>|");
  CHECK(names("o#7 if [#<a> EQ 1]") == "7@#7|<a>@#<a>|");
  CHECK(names("(Debug, #<A> and #3.5 # 4 #[5])(note #6)(MSG,#8)") == "<a>!@#<A>|3!@#3|");
  CHECK(names("( print,#1)(log , #2)(print #3)(abort,#04)") == "1!@#1|4!@#04|");
  CHECK(names("#<open (debug,#<open") == "");
  CHECK(names("#1.5") == "?@#1.5|");
}

TEST_CASE("the formatter changes indentation only, and once", "[format]") {
  for (const std::string& text : all_programs()) {
    const std::string once = indented(text);
    CHECK(without_indent(once) == without_indent(text));
    CHECK(indented(once) == once);
  }
}

TEST_CASE("indentation follows blocks", "[format]") {
  CHECK(indented("o1 sub\no2 if [#1]\nG0\no2 else\nG1\no2 endif\no1 endsub\nM2\n") ==
        "o1 sub\n  o2 if [#1]\n    G0\n  o2 else\n    G1\n  o2 endif\no1 endsub\nM2\n");
  CHECK(indented("o1 do\nG0\no1 while [#1]\n") == "o1 do\n  G0\no1 while [#1]\n");
  CHECK(indented("o1 if [#1]\nG0\nM2\n") == "o1 if [#1]\nG0\nM2\n");  // not closed
  CHECK(indented("o1 if [#1]\n\n\tG0\r\no1 endif\nM2\n") == "o1 if [#1]\n\n  G0\r\no1 endif\nM2\n");
  const std::string longest(251, 'G');
  CHECK(indented("o1 if [#1]\n" + longest + "\no1 endif\n") ==
        "o1 if [#1]\n " + longest + "\no1 endif\n");  // 252 is the limit
}
