#include "analyzer/syntax/expression.h"

#include <array>
#include <charconv>

#include "analyzer/syntax/arithmetic.h"
#include "analyzer/syntax/line_parser.h"
#include "analyzer/text/characters.h"

namespace owlint {
namespace {

struct Function {
  std::string_view name;
  Operator op;
};

constexpr std::array<Function, 14> kFunctions = {{
    {"abs", Operator::kAbs},
    {"acos", Operator::kAcos},
    {"asin", Operator::kAsin},
    {"atan", Operator::kAtan},
    {"cos", Operator::kCos},
    {"exp", Operator::kExp},
    {"exists", Operator::kExistsNamed},
    {"fix", Operator::kFix},
    {"fup", Operator::kFup},
    {"ln", Operator::kLn},
    {"round", Operator::kRound},
    {"sin", Operator::kSin},
    {"sqrt", Operator::kSqrt},
    {"tan", Operator::kTan},
}};

struct Infix {
  std::string_view text;
  Operator op;
};

// `**` before `*`, since the first that fits is taken.
constexpr std::array<Infix, 15> kInfixes = {{
    {"**", Operator::kPower},
    {"*", Operator::kTimes},
    {"/", Operator::kDivide},
    {"+", Operator::kPlus},
    {"-", Operator::kMinus},
    {"mod", Operator::kModulo},
    {"eq", Operator::kEq},
    {"ne", Operator::kNe},
    {"gt", Operator::kGt},
    {"ge", Operator::kGe},
    {"lt", Operator::kLt},
    {"le", Operator::kLe},
    {"and", Operator::kAnd},
    {"or", Operator::kOr},
    {"xor", Operator::kXor},
}};

/// Binding strength as documented and measured: ** over * / MOD over + - over comparisons over AND OR XOR;
/// all of them from left to right, `**` included (`2**3**2` is 64).
int strength(Operator op) {
  switch (op) {
    case Operator::kPower: return 5;
    case Operator::kTimes:
    case Operator::kDivide:
    case Operator::kModulo: return 4;
    case Operator::kPlus:
    case Operator::kMinus: return 3;
    case Operator::kAnd:
    case Operator::kOr:
    case Operator::kXor: return 1;
    default: return 2;
  }
}

bool is_number_char(char c) { return (c >= '0' && c <= '9') || c == '.'; }

}  // namespace

std::string_view operator_text(Operator op) {
  for (const Infix& infix : kInfixes) {
    if (infix.op == op) return infix.text;
  }
  for (const Function& function : kFunctions) {
    if (function.op == op) return function.name;
  }
  return "-";
}

ExprId ExpressionParser::add(Expr expr) {
  pool_.push_back(expr);
  return static_cast<ExprId>(pool_.size() - 1);
}

ExprId ExpressionParser::fail(size_t from, size_t to, std::string message) {
  error_ = {StopKind::kExpression, from, to, failed_ != nullptr ? std::string(failed_) : std::move(message)};
  return kNoExpr;
}

bool ExpressionParser::plain_number(uint32_t* number) {
  constexpr size_t kMaxDigits = 9;
  size_t at = cursor;
  uint32_t value = 0;
  while (line_[at] >= '0' && line_[at] <= '9') value = value * 10 + static_cast<uint32_t>(line_[at++] - '0');
  if (at == cursor || at - cursor > kMaxDigits || line_[at] == '.') return false;
  *number = value;
  note_split(cursor, at);
  cursor = at;
  return true;
}

/// Blanks vanish, within numbers too.
void ExpressionParser::note_split(size_t from, size_t to) {
  if (split_numbers_ == nullptr || line_.offset(to - 1) - line_.offset(from) == to - 1 - from) return;
  split_numbers_->push_back(line_.span(from, to));
}

ExprId ExpressionParser::number() {
  const size_t from = cursor;
  // A sign right before it is part of what cannot be read.
  const bool has_sign = from > 0 && (line_[from - 1] == '-' || line_[from - 1] == '+') && is_number_char(line_[from]);
  if (uint32_t whole = 0; plain_number(&whole)) return add(Expr::number(whole));
  while (is_number_char(line_[cursor])) ++cursor;
  const std::string_view digits = line_.text().substr(from, cursor - from);
  const std::string quoted(line_.text().substr(has_sign ? from - 1 : from, cursor - from + (has_sign ? 1 : 0)));
  double value = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (problem != std::errc{}) {
    return fail(from, cursor > from ? cursor : from + 1,
                "bad number format (conversion failed) parsing '" + quoted + "'");
  }
  if (end != digits.data() + digits.size()) {
    return fail(from, cursor, "bad number format (trailing characters) parsing '" + quoted + "'");
  }
  note_split(from, cursor);
  return add(Expr::number(value));
}

bool ExpressionParser::read_name(NameId* name) {
  const size_t from = cursor;  // at '<'
  const size_t close = line_.text().find('>', cursor);
  if (close == std::string_view::npos) {
    fail(from, line_.size(), "Named parameter not terminated");
    return false;
  }
  *name = names_.intern(line_.text().substr(from + 1, close - from - 1));
  cursor = close + 1;
  return true;
}

ExprId ExpressionParser::parameter() {
  if (line_[cursor] == '<') {
    NameId name = kNoName;
    return read_name(&name) ? add(Expr::named(Operator::kNamed, name)) : kNoExpr;
  }
  const ExprId index = value();
  return index == kNoExpr ? kNoExpr : add(Expr::of(Operator::kParameter, index));
}

ExprId ExpressionParser::exists() {
  const size_t from = cursor;  // just after '['
  if (line_[cursor] != '#') return fail(from, from + 1, "Expected # reading parameter");
  ++cursor;
  Expr expr = Expr::of(Operator::kExistsNumbered, kNoExpr);
  if (line_[cursor] == '<') {
    NameId name = kNoName;
    if (!read_name(&name)) return kNoExpr;
    expr = Expr::named(Operator::kExistsNamed, name);
  } else {
    const ExprId number = value();
    if (number == kNoExpr) return kNoExpr;
    expr = Expr::of(Operator::kExistsNumbered, number);
  }
  if (line_[cursor] != ']') return fail(cursor, cursor + 1, "Expected ] reading bracketed parameter");
  ++cursor;
  return add(expr);
}

ExprId ExpressionParser::function() {
  const size_t from = cursor;
  const Function* function = nullptr;
  for (const Function& candidate : kFunctions) {
    if (line_.text().substr(cursor).starts_with(candidate.name)) function = &candidate;
  }
  if (function == nullptr) {
    size_t to = from;
    while (is_small_letter(line_[to])) ++to;
    const char c = line_[from];
    // The interpreter chooses between its two messages by the first letter.
    if (std::string_view("acefrlst").find(c) != std::string_view::npos) {
      return fail(from, to, std::string("Unknown word starting with ") + c);
    }
    return fail(from, to, "Unknown word where unary operation could be");
  }
  cursor += function->name.size();
  if (line_[cursor] != '[') return fail(from, cursor, "Left bracket missing after unary operation name");
  if (function->op == Operator::kExistsNamed) {
    ++cursor;
    return exists();
  }
  const ExprId argument = bracketed();
  if (argument == kNoExpr) return kNoExpr;
  if (function->op != Operator::kAtan) return add(Expr::of(function->op, argument));
  if (line_[cursor] != '/') return fail(from, cursor, "Slash missing after first atan argument");
  ++cursor;
  if (line_[cursor] != '[') return fail(from, cursor, "Left bracket missing after slash with atan");
  const ExprId second = bracketed();
  return second == kNoExpr ? kNoExpr : add(Expr::of(Operator::kAtan, argument, second));
}

ExprId ExpressionParser::value() {
  const size_t from = cursor;
  bool negative = false;
  while (line_[cursor] == '-' || line_[cursor] == '+') {
    if (line_[cursor] == '-') negative = !negative;
    ++cursor;
  }
  const char c = line_[cursor];
  ExprId result = kNoExpr;
  if (c == '[') {
    result = bracketed();
  } else if (c == '#') {
    ++cursor;
    result = parameter();
  } else if (is_small_letter(c)) {
    result = function();
  } else if (cursor >= line_.size()) {
    if (cursor > from) {
      const std::string sign(line_.text().substr(cursor - 1));
      return fail(from, cursor, "bad number format (conversion failed) parsing '" + sign + "'");
    }
    return fail(cursor > 0 ? cursor - 1 : 0, line_.size(), "No characters found in reading real value");
  } else {
    result = number();
  }
  if (result == kNoExpr || !negative) return result;
  return add(Expr::of(Operator::kNegate, result));
}

bool ExpressionParser::read_operator(Operator* op, bool* closed) {
  *closed = line_[cursor] == ']';
  if (*closed) {
    ++cursor;
    return true;
  }
  const std::string_view rest = line_.text().substr(cursor);
  for (const Infix& infix : kInfixes) {
    if (rest.starts_with(infix.text)) {
      *op = infix.op;
      cursor += infix.text.size();
      return true;
    }
  }
  if (rest.empty()) return false;  // the caller knows where the bracket was opened
  size_t to = cursor;
  while (is_small_letter(line_[to])) ++to;
  if (std::string_view("aegmlnox").find(rest[0]) != std::string_view::npos) {
    fail(cursor, to, std::string("Unknown operation name starting with ") + rest[0]);
  } else {
    fail(cursor, to > cursor ? to : cursor + 1, "Unknown operation");
  }
  return false;
}

ExprId ExpressionParser::bracketed() {
  ++depth_;
  const ExprId value = in_brackets();
  --depth_;
  return value;
}

ExprId ExpressionParser::in_brackets() {
  const size_t opened = cursor;
  ++cursor;
  // Operator precedence with explicit stacks; depth is bounded by the number of strengths.
  struct Pending {
    ExprId left;
    Operator op;
  };
  std::array<Pending, 8> pending{};
  size_t depth = 0;
  for (;;) {
    ExprId right = value();
    if (right == kNoExpr) return kNoExpr;
    Operator op{};
    bool closed = false;
    if (!read_operator(&op, &closed)) {
      if (error_.kind == StopKind::kNone) return fail(opened, line_.size(), "Unclosed expression");
      return kNoExpr;
    }
    while (depth > 0 && (closed || strength(pending[depth - 1].op) >= strength(op))) {
      --depth;
      double left_value = 0;
      double right_value = 0;
      double result = 0;
      if (failed_ == nullptr && literal_value(pool_, pending[depth].left, &left_value) &&
          literal_value(pool_, right, &right_value)) {
        failed_ = apply(pending[depth].op, left_value, right_value, &result);
        if (is_not_finite(failed_) && !(closed && depth == 0)) failed_ = nullptr;
      }
      right = add(Expr::of(pending[depth].op, pending[depth].left, right));
    }
    if (closed) {
      pool_[right].complete = true;
      return right;
    }
    pending[depth++] = {right, op};
  }
}

}  // namespace owlint
