// What the scanner keeps and how one line is read.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "analyzer/program/program.h"

using namespace owlint;

namespace {

struct Read {
  explicit Read(std::string bytes) : source(Source::own("p.ngc", std::move(bytes))), syntax(scan(*source)) {}

  /// `line keyword label` of every O-word, or what else the statement is.
  std::string shape() const {
    std::string out;
    for (const Statement& s : syntax.statements) {
      if (s.kind == LineKind::kModeLine) continue;  // a question to the flow
      if (!out.empty()) out += "; ";
      out += std::to_string(s.line) + " ";
      switch (s.kind) {
        case LineKind::kOWord:
          out += s.keyword == Keyword::kBare   ? "bare"
              : s.keyword == Keyword::kUnknown ? "unknown"
                                               : std::string(spelling(s.keyword));
          out += s.label == kNoName ? " ?" : " " + syntax.names.text(s.label);
          break;
        case LineKind::kM98: out += "M98"; break;
        case LineKind::kM99: out += "M99"; break;
        case LineKind::kM99Behind: out += "M99 behind"; break;
        case LineKind::kContour:
          out += "contour" + (s.label == kNoName ? " ?" : " " + syntax.names.text(s.label));
          break;
        case LineKind::kProgramEnd: out += "end"; break;
        case LineKind::kPercent: out += "%"; break;
        case LineKind::kAbort: out += "abort"; break;
        case LineKind::kUserCode: out += "user code"; break;
        case LineKind::kMachineCheck: out += "machine?"; break;
        case LineKind::kRemap: out += "remap"; break;
        case LineKind::kModeLine: break;
        case LineKind::kWords:
        case LineKind::kFileEnd: out += "words"; break;
      }
      if (const LineError* error = syntax.error(s)) out += " (" + error->message + ")";
    }
    return out;
  }

  std::shared_ptr<const Source> source;
  Syntax syntax;
};

std::string shape(const std::string& bytes) { return Read(bytes).shape(); }

}  // namespace

TEST_CASE("motion and comments leave nothing but questions about modes", "[syntax]") {
  const Read read("G0 X1 Y2\n(o100 if [1])\n; o100 if\n\n  G1 Z-2.5 F100 (M2)\nM3 S1000\nT1 M6\n");
  CHECK(read.shape().empty());
  CHECK(read.syntax.lines == 7);
  CHECK(read.syntax.last_code == 7);
  CHECK(read.syntax.first_plain_line == 1);
}

TEST_CASE("every keyword is read", "[syntax]") {
  CHECK(shape("o1 sub\no1 endsub\no1 call\no1 do\no1 while [1]\no1 repeat [2]\no1 if [1]\no1 elseif [1]\n") ==
        "1 sub 1; 2 endsub 1; 3 call 1; 4 do 1; 5 while 1; 6 repeat 1; 7 if 1; 8 elseif 1");
  CHECK(shape("o1 else\no1 endif\no1 break\no1 continue\no1 endwhile\no1 endrepeat\no1 return\no1\n") ==
        "1 else 1; 2 endif 1; 3 break 1; 4 continue 1; 5 endwhile 1; 6 endrepeat 1; 7 return 1; 8 bare 1");
}

TEST_CASE("blanks and case do not matter outside comments", "[syntax]") {
  CHECK(shape("O 1 0 0 I f [ 1 ]\n o100 END if\no100\tre turn\n") == "1 if 100; 2 endif 100; 3 return 100");
  CHECK(shape("o<My Sub> CALL\n") == "1 call mysub");
  CHECK(shape("o100 else if [1]\n") == "1 elseif 100");
}

TEST_CASE("labels are normalised", "[syntax]") {
  CHECK(shape("o0100 sub\no100.0 sub\no<100> sub\no-1 sub\no100.00001 sub\no[50+50] sub\no[1+#2] sub\no#1 sub\n") ==
        "1 sub 100; 2 sub 100; 3 sub 100; 4 sub -1; 5 sub 100; 6 sub 100; 7 sub ?; 8 sub ?");
  CHECK(shape("o1.5 sub\n") == "1 unknown ? (Non integer value for integer)");
}

TEST_CASE("a line number and block delete may come first", "[syntax]") {
  const Read read("/N10 o1 if [1]\nN20.5 o1 endif\no2 sub (x)\n");
  CHECK(read.shape() == "1 if 1; 2 endif 1; 3 sub 2");
  CHECK(read.syntax.statements[0].block_delete);
  CHECK_FALSE(read.syntax.statements[1].block_delete);
  CHECK(read.syntax.statements[2].comment);
  CHECK(shape("(x) o1 sub\n") == "1 sub 1 (Bad character 'o' used)");
  CHECK(shape("N10/o1 if [1]\n").find("Bad character '/' used") != std::string::npos);
}

TEST_CASE("a keyword is a prefix", "[syntax]") {
  const Read read("o1 dogs\no1 endiff\no1 iff [1]\no1 elsewhere\no1 foo\n");
  REQUIRE(read.syntax.statements.size() == 5);
  CHECK(read.syntax.statements[0].keyword == Keyword::kDo);
  CHECK(read.syntax.statements[1].keyword == Keyword::kEndif);
  CHECK(read.syntax.statements[2].keyword == Keyword::kIf);
  CHECK(read.syntax.statements[3].keyword == Keyword::kElse);
  CHECK(read.syntax.statements[4].keyword == Keyword::kUnknown);
  CHECK(read.source->slice(read.syntax.statements[0].rest_span()) == "gs");
  CHECK(read.source->slice(read.syntax.statements[1].rest_span()) == "f");
  CHECK(read.source->slice(read.syntax.statements[4].keyword_span()) == "foo");
}

TEST_CASE("places point into the machinist's own text", "[syntax]") {
  const Read read("G0 X1\n  O 100  I F [#1 EQ 2] (deep)\n");
  REQUIRE(read.syntax.statements.size() == 2);
  const Statement& s = read.syntax.statements[1];
  CHECK(read.source->slice(s.label_span()) == "O 100");
  CHECK(read.source->slice(s.keyword_span()) == "I F");
  CHECK(read.source->slice(s.head_span()) == "O 100  I F");
  CHECK(s.line == 2);
  CHECK(s.offset == 6);
  CHECK(s.comment);
  CHECK(s.has_bracket);
}

TEST_CASE("nothing lies outside of its line, also where the file ends with it", "[syntax]") {
  for (const std::string line :
       {"o#EXISTS[#<a>] if [ATAN[#1]/[2] GT -#<b c>] x", "o<f> call [#1] [2 ** 3] ; c",
        "#[1+2] = SIN[EXISTS[#5]] (c) X#<a", "N10 M98 P#1 L[2", "o1.5 sub", "/G0 X[1", "n o"}) {
    for (size_t length = 0; length <= line.size(); ++length) {
      const Read read(line.substr(0, length));
      for (const Statement& s : read.syntax.statements) {
        const LineError* error = read.syntax.error(s);
        CHECK((error == nullptr || (error->span.begin <= error->span.end && error->span.end <= length)));
        CHECK(std::max({s.label_to, s.keyword_to, s.rest_to}) <= length);
      }
    }
  }
}

TEST_CASE("the program end in its spellings", "[syntax]") {
  CHECK(shape("M2\nM30\nm02\nM 3 0\nM2.0\nG0 X1 M2\nN5 M2 (end)\n") ==
        "1 end; 2 end; 3 end; 4 end; 5 end; 6 end; 7 end");
  CHECK(shape("M3\nM6\n(M2)\n;M30\n").empty());
  CHECK(shape("%\nM2\n%\n") == "1 %; 2 end; 3 %");
  CHECK(Read("\n %\r\nM2\n").syntax.percent);
  CHECK_FALSE(Read("M2\n%\n").syntax.percent);
}

TEST_CASE("Fanuc style calls", "[syntax]") {
  const Read read("M98 P100 L3\nm98p0100\nM99\nO100\nM 9 8 P[#1]\n");
  CHECK(read.shape() == "1 M98; 2 M98; 3 M99; 4 bare 100; 5 M98");
  CHECK(read.syntax.names.text(read.syntax.statements[0].label) == "100");
  CHECK(read.syntax.statements[0].label == read.syntax.statements[1].label);
  CHECK(read.syntax.statements[0].value_count == 1);
  CHECK(read.syntax.statements[4].label == kNoName);
}

TEST_CASE("M98 and M99 beside words", "[syntax]") {
  CHECK(shape("G0 X1 M99\nM99 G0 X1\n(x) M99\nM099\nM99.5\n") ==
        "1 M99 behind; 2 M99; 3 M99 behind; 4 M99; 5 words (Non integer value for integer)");
  const Read read("M98 P1 G0 X#1\nM99 P5\nM99 (c)\nM98 L2 X#1 P1\n");
  CHECK(read.shape().starts_with("1 M98; 2 M99 (P word with no"));
  CHECK(read.source->slice(read.syntax.statements[0].rest_span()) == "G0 X#1");
  CHECK(read.syntax.statements[0].value_count == 1);
  CHECK_FALSE(read.syntax.statements[0].repeats);
  CHECK(read.source->slice(read.syntax.statements[1].rest_span()) == "P5");
  CHECK(read.syntax.statements[2].rest_span().begin == read.syntax.statements[2].rest_span().end);
  CHECK(read.shape().ends_with("4 M98"));
  CHECK(read.syntax.statements.back().repeats);
  CHECK(read.syntax.statements.back().value_count == 2);
  CHECK(shape("M99 M99\nM30 M99\nM5 M99\n") ==
        "1 M99 (Two m codes used from same modal group); 2 end (Two m codes used from same modal group); 3 M99 behind");
  CHECK(
      shape("G0 M98 P1\nM98 P1 P2\nM98 P-1 P2\nM98 P1 L-1\nM98 P1 L.5\nM98 L2\nM98 P1 )\n") ==
      "1 words (Unknown m code used: M98); 2 M98 (Multiple p words on one line); 3 M98; 4 M98 (Negative l word used); "
      "5 M98 (Non integer value for integer); 6 M98 (Found 'm98' code with no P-word); 7 M98 (Bad character ')' used)");
  // Its words are checked as on any line, but for the flow to report: not where it is skipped.
  CHECK(shape("M98 P1 H5\nM98 P1 G1 X5 F9\nM98 P5.5 F-1\nM98 P1 M3 M5\n") ==
        "1 M98; 2 M98; 3 M98 (Negative f word used); 4 M98 (Two m codes used from same modal group)");
}

TEST_CASE("labels that lack something are read all the same", "[syntax]") {
  const Read read("N100 sub\n100 endsub\n<hole> call\n0<hole> call\n0100 call\nendif\n");
  const auto& all = read.syntax.statements;
  REQUIRE(all.size() == 6);
  for (size_t i = 0; i < 5; ++i) {
    CHECK(all[i].kind == LineKind::kOWord);
    CHECK(all[i].refused);
  }
  CHECK(read.syntax.names.text(all[0].label) == "100");
  CHECK(all[0].is(Keyword::kSub));
  CHECK(all[1].is(Keyword::kEndsub));
  CHECK(read.syntax.names.text(all[3].label) == "hole");
  CHECK(all[5].kind == LineKind::kWords);
  CHECK(all[5].keyword == Keyword::kEndif);
  CHECK(read.syntax.error(all[4])->kind == StopKind::kZeroForO);
  CHECK(read.syntax.error(all[1])->kind == StopKind::kLetterForgotten);
}

TEST_CASE("text among words is noticed, words with functions are not", "[syntax]") {
  CHECK(shape("GOTO 20\nG0 X1 hello\nN10 drill\n").find("3 words (Unknown word starting with r)") != std::string::npos);
  CHECK(Read("G0 XSIN[30]\nifix[1.5] g2 x2\n").syntax.errors.empty());
}

TEST_CASE("numbers that blanks divide are noted, but not labels", "[syntax]") {
  const Read read("o1 call [1 2] [3] [ 4 + 5 ]\n#1=[1 0]\no 1 0 call [-.5]\nG 1 X 5. 5 Y - 6\n");
  REQUIRE(read.syntax.split_numbers.size() == 3);
  CHECK(read.source->slice(read.syntax.split_numbers[0]) == "1 2");
  CHECK(read.source->slice(read.syntax.split_numbers[1]) == "1 0");
  CHECK(read.source->slice(read.syntax.split_numbers[2]) == "5. 5");
}

TEST_CASE("comments nest nowhere and close on their line", "[syntax]") {
  CHECK(shape("G0 (a (b) X1\n") == "1 words (Nested comment found)");
  CHECK(shape("(open\nG0 X1\n") == "1 words (Unclosed comment found)");
  CHECK(shape("(a) (b) ; (c\n").empty());
  CHECK(shape("o1 call (one) [1] (two) [2] ; three\n") == "1 call 1");
}

TEST_CASE("a line holds 252 characters and a line feed", "[syntax]") {
  CHECK(shape(std::string(252, ' ') + "\nM2\n") == "2 end");
  CHECK(shape("(" + std::string(250, 'x') + ")\n").empty());
  CHECK(shape("(" + std::string(251, 'x') + ")\n") == "1 words (Command too long)");
  CHECK(shape("(" + std::string(251, 'x') + ")").empty());  // the limit counts the line feed
  CHECK(shape("(" + std::string(252, 'x') + ")") == "1 words (Command too long)");
}

TEST_CASE("call arguments", "[syntax]") {
  const Read read("o1 call [1] [#2] [3+4]\no1 call\n");
  CHECK(read.syntax.statements[0].value_count == 3);
  CHECK(read.syntax.statements[1].value_count == 0);
  std::string thirty = "o1 call";
  for (int i = 0; i < 30; ++i) thirty += " [1]";
  CHECK(shape(thirty + "\n") == "1 call 1");
  CHECK(shape(thirty + " [1]\n") == "1 call 1 (Too many subroutine parameters)");
}

TEST_CASE("a NUL hides the rest of its line", "[syntax]") {
  const Read read(std::string("o1 if [1]\0 endif\nM2\n", 20));
  REQUIRE(read.syntax.statements.size() == 2);
  CHECK(read.syntax.statements[0].nul);
  CHECK(read.shape() == "1 if 1; 2 end");
}

TEST_CASE("carriage returns alone end no line", "[syntax]") {
  const Read read("o1 if [1]\ro1 endif\rM2\r");
  CHECK(read.syntax.lines == 1);
  REQUIRE(read.syntax.statements.size() == 1);
  CHECK(read.syntax.statements[0].inner_cr);
  CHECK_FALSE(Read("o1 if [1]\r\n").syntax.statements[0].inner_cr);
}

TEST_CASE("comments that speak to the linter are noted", "[syntax]") {
  const Read read(
      "(owlint: ignore OW301 -- old post)\nG0 X1 ; owlint: ignore OW304\no1 if [1] (owlint: ignore)\n(owlint is "
      "mentioned)\n");
  REQUIRE(read.syntax.directives.size() == 3);
  CHECK(read.source->slice(read.syntax.directives[0].span) == " ignore OW301 -- old post");
  CHECK(read.syntax.directives[0].own_line);
  CHECK_FALSE(read.syntax.directives[1].own_line);
  CHECK_FALSE(read.syntax.directives[1].on_oword);
  CHECK(read.syntax.directives[2].on_oword);
}

TEST_CASE("G70 to G72 with Q run a sub", "[syntax]") {
  CHECK(shape("G71 Q7 X11 Z0 I1\n") == "1 contour 7");
  CHECK(shape("n10 x11 g 7 2 . 1 (c) q [3+4]\n") == "1 contour 7");
  CHECK(shape("G70 Q#1 X11\n") == "1 contour ?");
  CHECK(shape("G71 Q-1 X11\n").empty());  // counts as no Q
  CHECK(shape("G83 Q0.5 X1 Z-5 R2\n").empty());
  CHECK(shape("G73 X1 Z-5 R2 Q1\nG7\n").empty());
  CHECK(shape("(G71) G83 X1 Z-5 R2 Q7\n").empty());
}
