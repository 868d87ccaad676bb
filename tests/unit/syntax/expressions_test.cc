// Expressions: values and messages as LinuxCNC's, from a table that confirm.py puts to LinuxCNC as well.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"
#include "rules/driver/lint.h"
#include "support/files.h"

using namespace owlint;

namespace {

/// Reads one `[ ... ]`.
struct Parsed {
  explicit Parsed(const std::string& text) {
    line.assign(text, 0);
    id = parser.bracketed();
  }
  LineText line;
  ExprPool pool;
  Names names;
  ExpressionParser parser{line, pool, names};
  ExprId id = kNoExpr;
};

/// What an expression of literals gives, as `G0 X` prints it, or what LinuxCNC says; empty when it has parameters.
std::string outcome(const std::string& expression) {
  const auto report = lint(Source::own("p.ngc", fmt::format("G21 G90\n#100=[{}]\nG0 X#100\nM2\n", expression)),
                           Profile{}, LintOptions{});
  for (const Finding& f : report.findings) {
    if (f.stops && !f.interpreter.empty()) return f.interpreter;
  }
  const Parsed parsed("[" + expression + "]");
  double value = 0;
  if (parsed.id == kNoExpr || !literal_value(parsed.pool, parsed.id, &value)) return {};
  return fmt::format("{:.4f}", value + 0.0);
}

}  // namespace

TEST_CASE("expressions give what LinuxCNC gives", "[expressions]") {
  const std::string table = test::read_file(test::repository("tests/unit/syntax/expressions.tsv"));
  size_t rows = 0;
  for (size_t at = 0; at < table.size();) {
    const size_t feed = table.find('\n', at);
    const std::string row = table.substr(at, feed - at);
    at = feed + 1;
    if (row.starts_with('#') && row.find('\t') == std::string::npos) continue;
    const size_t tab = row.find('\t');
    REQUIRE(tab != std::string::npos);
    const std::string expression = row.substr(0, tab);
    const std::string wanted = row.substr(tab + 1);
    ++rows;
    INFO(expression);
    const bool parameters =
        expression.find('#') != std::string::npos && std::isdigit(static_cast<unsigned char>(wanted[0])) != 0;
    CHECK(outcome(expression) == (parameters ? "" : wanted));
  }
  CHECK(rows > 80);
}

TEST_CASE("operands stand before their operators", "[expressions]") {
  const Parsed parsed("[1+[2*#3]-SQRT[#<a>]]");
  REQUIRE(parsed.id != kNoExpr);
  for (ExprId id = 0; id < parsed.pool.size(); ++id) {
    const Expr& e = parsed.pool[id];
    if (e.left() != kNoExpr) CHECK(e.left() < id);
    if (e.right() != kNoExpr) CHECK(e.right() < id);
  }
  CHECK(parsed.pool[parsed.id].op == Operator::kMinus);
  CHECK(parsed.parser.cursor == parsed.line.size());
}

TEST_CASE("an error of an expression says where it is", "[expressions]") {
  const Parsed parsed("[ 1 + foo ]");
  REQUIRE(parsed.id == kNoExpr);
  const ReadError& error = parsed.parser.error();
  CHECK(error.message == "Unknown word starting with f");
  const Span span = parsed.line.span(error.from, error.to);
  CHECK(span.begin == 6);
  CHECK(span.end == 9);
}

TEST_CASE("brackets nest as deep as a line is long", "[expressions]") {
  const std::string deep = std::string(120, '[') + "1" + std::string(120, ']');
  const Parsed parsed(deep);
  REQUIRE(parsed.id != kNoExpr);
  double value = 0;
  CHECK(literal_value(parsed.pool, parsed.id, &value));
  CHECK(value == 1);
}

TEST_CASE("numbers within 0.0001 of an integer are integers", "[expressions]") {
  long n = 0;
  CHECK((to_integer(100.00005, &n) && n == 100));
  CHECK((to_integer(99.99995, &n) && n == 100));
  CHECK((to_integer(-3.00005, &n) && n == -3));
  CHECK_FALSE(to_integer(1.5, &n));
  CHECK_FALSE(to_integer(1e300, &n));
  CHECK_FALSE(to_integer(-1e300, &n));
  CHECK_FALSE(to_integer(std::nan(""), &n));
}
