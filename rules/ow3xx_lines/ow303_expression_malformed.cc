// OW303 expression-malformed: an expression on an O-word line that the interpreter cannot read.
// Depends on: brackets, operators, functions and operands are checked when the expression is
// evaluated, not when the line is skipped.
#include <algorithm>
#include <initializer_list>

#include "rules/driver/idioms.h"

namespace owlint::rules::ow303 {
namespace {

struct Words {
  std::string_view interpreter;
  std::string_view message;
  std::string_view help;
};

constexpr Words kWords[] = {
    {"Unexpected character after O-word", "this bracket closes nothing", "remove it"},
    {"Unclosed expression", "a bracket is not closed", "close it with `]`"},
    {"Unknown operation name", "this is not an operator", "operators are + - * / ** MOD EQ NE GT GE LT LE AND OR XOR"},
    {"Unknown operation", "an operator is expected here",
     "operators are + - * / ** MOD EQ NE GT GE LT LE AND OR XOR; comments are not allowed in brackets"},
    {"Unknown word", "this is not a function",
     "functions are ABS ACOS ASIN ATAN COS EXISTS EXP FIX FUP LN ROUND SIN SQRT TAN; there is no NOT"},
    {"bad number format", "a number is expected here", "write a number, `#` and a parameter, `[`, or a function"},
    {"No characters found", "a value is missing at the end of the line",
     "write a number, `#` and a parameter, `[`, or a function"},
    {"Left bracket missing after unary", "the function is not followed by `[`",
     "put its argument in brackets: `SIN[30]`"},
    {"Slash missing", "`ATAN` takes two values", "write `ATAN[y]/[x]`"},
    {"Left bracket missing after slash", "`ATAN` takes two values, each in brackets", "write `ATAN[y]/[x]`"},
    {"Equal sign missing", "a parameter without `=`", "write `#1=...`, or a word letter before the parameter"},
    {"Named parameter not terminated", "the parameter's name has no `>`", "write `#<name>`"},
    {"Bad character ']'", "this bracket closes nothing", "remove it"},
    {"Bad format unsigned integer", "`N` is not followed by a number", "write a line number, or remove the `N`"},
    {"Attempt to divide by zero", "this divides by zero", "change the divisor, or test it first"},
    {"Non integer value", "a parameter's number must be a whole number", "check the values that it is computed from"},
    {"Negative argument to sqrt", "this is the root of a negative number", "test the value first"},
    {"Zero or negative argument to ln", "this is the logarithm of zero or a negative number", "test the value first"},
    {"Argument to a", "the argument is not between -1 and 1", "test the value first"},
    {"Attempt to raise negative", "a negative number can only have a whole number as its power",
     "test the value first"},
    {"Parameter number out of range", "there is no parameter with that number", "the numbers are #1 to #5601"},
    {"Expected", "`EXISTS` takes one parameter", "write `EXISTS[#<name>]`"},
};

void word(Finding& f) {
  f.message = "this value cannot be computed";
  f.help = "check the values in it";
  for (const Words& words : kWords) {
    if (!f.interpreter.starts_with(words.interpreter)) continue;
    f.message = words.message;
    f.help = words.help;
    return;
  }
}

/// The operations that a value may have failed in.
struct Failing {
  std::string_view interpreter;
  std::initializer_list<Operator> in;
};
constexpr Failing kFailing[] = {
    {"Attempt to divide by zero", {Operator::kDivide}},
    {"Negative argument to sqrt", {Operator::kSqrt}},
    {"Zero or negative argument to ln", {Operator::kLn}},
    {"Argument to acos", {Operator::kAcos}},
    {"Argument to asin", {Operator::kAsin}},
    {"Attempt to raise negative", {Operator::kPower}},
    {"Parameter number out of range", {Operator::kParameter}},
    {"Non integer value", {Operator::kParameter}},
};

// Depth is bounded by the length of a line.
bool has_operator(const Syntax& syntax, ExprId id, const Failing& failing) {
  const Expr& expr = syntax.exprs[id];
  if (std::ranges::find(failing.in, expr.op) != failing.in.end()) return true;
  bool found = false;
  for_each_operand(expr, [&](ExprId operand) { found = found || has_operator(syntax, operand, failing); });
  return found;
}

/// The word or setting whose value cannot be computed, if only one of the line has such an operation; else all of the line.
Span failing_item(const Program& p, const Statement& s, std::string_view interpreter) {
  const auto* const failing =
      std::ranges::find_if(kFailing, [&](const Failing& f) { return interpreter.starts_with(f.interpreter); });
  if (failing == std::end(kFailing)) return s.whole();
  const Item* only = nullptr;
  for (const Item& item : p.syntax.items_of(s)) {
    const bool fails = (item.value != kNoExpr && has_operator(p.syntax, item.value, *failing)) ||
        (item.target != kNoExpr && has_operator(p.syntax, item.target, *failing));
    if (!fails) continue;
    if (only != nullptr) return s.whole();
    only = &item;
  }
  return only == nullptr ? s.whole() : s.span(only->from, only->to);
}

Finding* report(const Input& in, Reporter& out, StatementId id, const std::string& interpreter) {
  const Statement& s = in.program.at(id);
  const LineError* error = in.program.syntax.error(s);
  const bool reading = error != nullptr && error->message == interpreter;
  const Span whole =
      s.kind == LineKind::kOWord ? Span{s.offset + s.label_from, s.end()} : failing_item(in.program, s, interpreter);
  Finding& f = out.add(reading ? error->span : whole, "");
  f.interpreter = interpreter;
  word(f);
  // What cannot be read to its end: `1.5.2`.
  constexpr std::string_view kTrailing = "bad number format (trailing characters) parsing '";
  if (interpreter.starts_with(kTrailing) && interpreter.ends_with('\'')) {
    f.message =
        "`" + interpreter.substr(kTrailing.size(), interpreter.size() - kTrailing.size() - 1) + "` is not a number";
    f.help = "write a number with one decimal point";
  }
  if (reading) explain_idiom(in, id, f);
  return &f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement, s.interpreter); });
  for_unmet_errors(
      in, out, [&](StatementId id, const LineError& e) { report(in, out, id, e.message)->reach = in.flow.reach(id); });
}

}  // namespace

extern const Rule kRule{
    .code = "OW303",
    .name = "expression-malformed",
    .summary = "a missing or extra bracket, an unknown operator or function, a missing value",
    .group = Group::kLine,
    .level = Severity::kError,
    .page =
        {
            .what = R"(A missing or extra bracket, an operator that LinuxCNC does not have (`=`, `==`, `>`, `<`, `!`,
`NOT`), an unknown function, a function without brackets, or an operator without a value beside it.)",
            .why =
                R"(LinuxCNC stops when it runs the line; in a skipped branch, or in a sub that nothing calls, there is
no message. There are many messages: `Unclosed expression` for a missing bracket,
`Unexpected character after O-word` for an extra one, `Unknown operation` for `=` and `>`,
`Unknown word where unary operation could be` for `NOT`, `Unknown word starting with s` for a
function such as `SQR`, `Left bracket missing after unary operation name` for `SQRT #1`,
`Slash missing after first atan argument`, `bad number format (conversion failed) parsing ''` for a
missing value.)",
            .bad = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [[#5070 EQ 1] AND [#5063 GT -5]
  G10 L20 P1 Z0
o100 endif
G0 Z5
M2
)",
            .good = R"(G21 G90
G0 X10 Y10 Z5
G38.3 Z-10 F50
o100 if [[#5070 EQ 1] AND [#5063 GT -5]]
  G10 L20 P1 Z0
o100 endif
G0 Z5
M2
)",
            .fix = R"(Close every bracket. The comparisons are `EQ NE GT GE LT LE`, joined with `AND OR XOR`; write `[#1
EQ 0]` for "not".)",
            .level_reason = "Error if a run executes the line: the program stops. Warning if no run does.",
            .interpreter = "Unclosed expression",
            .options = "",
        },
    .check = check,
};

}  // namespace owlint::rules::ow303
