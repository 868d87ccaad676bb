// OW303 expression-malformed: an expression on an O-word line that the interpreter cannot read.
// Depends on: brackets, operators, functions and operands are checked when the expression is
// evaluated, not when the line is skipped.
#include "rules/idioms.h"

namespace owlint::rules {
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
    {"Unknown operation", "an operator is expected here", "operators are + - * / ** MOD EQ NE GT GE LT LE AND OR XOR; comments do not belong in brackets"},
    {"Unknown word", "this is not a function", "functions are ABS ACOS ASIN ATAN COS EXISTS EXP FIX FUP LN ROUND SIN SQRT TAN; there is no NOT"},
    {"bad number format", "a number is expected here", "write a number, `#` and a parameter, `[`, or a function"},
    {"No characters found", "a value is missing at the end of the line", "write a number, `#` and a parameter, `[`, or a function"},
    {"Left bracket missing after unary", "the function is not followed by `[`", "put its argument in brackets: `SIN[30]`"},
    {"Slash missing", "`ATAN` takes two values", "write `ATAN[y]/[x]`"},
    {"Left bracket missing after slash", "`ATAN` takes two values, each in brackets", "write `ATAN[y]/[x]`"},
    {"Equal sign missing", "a parameter stands here without `=`", "write `#1=...`, or a word letter before the parameter"},
    {"Named parameter not terminated", "the parameter's name is not closed with `>`", "write `#<name>`"},
    {"Bad character ']'", "this bracket closes nothing", "remove it"},
    {"Bad format unsigned integer", "`N` is not followed by a number", "write a line number, or remove the `N`"},
    {"Attempt to divide by zero", "this divides by zero", "change the divisor, or test it before"},
    {"Non integer value", "a parameter's number must be a whole one", "check what it is computed from"},
    {"Negative argument to sqrt", "this takes the root of a negative number", "test the value before"},
    {"Zero or negative argument to ln", "this takes the logarithm of zero or a negative number", "test the value before"},
    {"Argument to a", "the argument is not between -1 and 1", "test the value before"},
    {"Attempt to raise negative", "a negative number has no power that is not a whole number", "test the value before"},
    {"Parameter number out of range", "there is no parameter with that number", "numbers go from #1 to #5601"},
    {"Expected", "`EXISTS` takes one parameter", "write `EXISTS[#<name>]`"},
};

void word(Finding& f) {
  f.message = "this value cannot be computed";
  f.help = "check the values that go into it";
  for (const Words& words : kWords) {
    if (!f.interpreter.starts_with(words.interpreter)) continue;
    f.message = words.message;
    f.help = words.help;
    return;
  }
}

Finding* report(const Input& in, Reporter& out, StatementId id, const std::string& interpreter) {
  const Statement& s = in.program.at(id);
  const LineError* error = in.program.syntax.error(s);
  const bool reading = error != nullptr && error->message == interpreter;
  const Span whole = s.kind == LineKind::kOWord ? Span{s.offset + s.label_from, s.end()} : s.whole();
  Finding& f = out.add(reading ? error->span : whole, "");
  f.interpreter = interpreter;
  word(f);
  if (reading) explain_idiom(in, id, f);
  return &f;
}

void check(const Input& in, Reporter& out) {
  for_stops(in, out, [&](const FlowStop& s) { return report(in, out, s.statement, s.interpreter); });
  for_unmet_errors(in, out, [&](StatementId id, const LineError& e) { report(in, out, id, e.message)->reach = in.flow.reach(id); });
}

}  // namespace

extern const Rule kOw303{
    .code = "OW303",
    .name = "expression-malformed",
    .summary = "unclosed or extra bracket, unknown operator or function, missing operand",
    .group = Group::kLine,
    .level = Severity::kError,
    .page = {
        .what = R"(A bracket too few or too many, an operator LinuxCNC does not have (`=`, `==`, `>`, `<`, `!`, `NOT`),
an unknown function, a function without its brackets, or an operator with nothing beside it.)",
        .why = R"(The interpreter stops at the line when it evaluates it; in a skipped branch or an uncalled sub
nothing is said. The messages are many: `Unclosed expression` for a missing bracket,
`Unexpected character after O-word` for one too many, `Unknown operation` for `=` and `>`,
`Unknown word where unary operation could be` for `NOT`, `Unknown word starting with s` for a
function such as `SQR`, `Left bracket missing after unary operation name` for `SQRT #1`,
`Slash missing after first atan argument`, `bad number format (conversion failed) parsing ''` for a
missing operand.

FEATURE 0x20 (`OWORD_WARNONLY`) changes nothing here.)",
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
        .fix = R"(Close every bracket. Comparisons are `EQ NE GT GE LT LE`, joined by `AND OR XOR`; write `[#1 EQ 0]`
for "not".)",
        .level_reason = "Error where a run evaluates the line: the program stops. Warning where no run does.",
        .interpreter = "Unclosed expression",
        .options = "",
    },
    .check = check,
};

}  // namespace owlint::rules
