// Expressions of RS274/NGC as flat nodes: `[#1 + 2]`, `ATAN[1]/[2]`, `EXISTS[#<a>]`. Parsing never throws; a malformed
// expression returns an error with its position and the interpreter's message.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analyzer/syntax/line_text.h"
#include "analyzer/syntax/names.h"

namespace owlint {

enum class Operator : uint8_t {
  // leaves
  kNumber,     // value
  kNamed,      // #<name>: name
  kParameter,  // #n, #[...], ##n: left is the number
  kExistsNamed,
  kExistsNumbered,
  // one operand, left
  kNegate,
  kAbs,
  kAcos,
  kAsin,
  kCos,
  kExp,
  kFix,
  kFup,
  kLn,
  kRound,
  kSin,
  kSqrt,
  kTan,
  // two operands
  kAtan,
  kPower,
  kTimes,
  kDivide,
  kModulo,
  kPlus,
  kMinus,
  kEq,
  kNe,
  kGt,
  kGe,
  kLt,
  kLe,
  kAnd,
  kOr,
  kXor,
};

using ExprId = uint32_t;
inline constexpr ExprId kNoExpr = UINT32_MAX;

/// One node, 16 bytes: its content depends on its operator.
class Expr {
 public:
  static Expr number(double value) {
    Expr e(Operator::kNumber);
    e.value_ = value;
    return e;
  }
  /// kNamed or kExistsNamed.
  static Expr named(Operator op, NameId name) {
    Expr e(op);
    e.name_ = name;
    return e;
  }
  static Expr of(Operator op, ExprId left, ExprId right = kNoExpr) {
    Expr e(op);
    e.operands_ = {left, right};
    return e;
  }

  Operator op;
  bool target = false;    ///< the left side of an assignment, not read
  bool complete = false;  ///< the last operation of a bracket

  double value() const { return value_; }  ///< of a kNumber
  NameId name() const { return is_name() ? name_ : kNoName; }
  ExprId left() const { return is_leaf() ? kNoExpr : operands_.left; }
  ExprId right() const { return is_leaf() ? kNoExpr : operands_.right; }

  /// The same in another program, whose expressions and names have other numbers.
  template <typename MoveExpr, typename MoveName>
  void move(const MoveExpr& expr, const MoveName& new_name) {
    if (is_name()) name_ = new_name(name_);
    if (!is_leaf()) operands_ = {expr(operands_.left), expr(operands_.right)};
  }

 private:
  struct Operands {
    ExprId left, right;
  };
  explicit Expr(Operator o) : op(o), value_(0) {}
  bool is_name() const { return op == Operator::kNamed || op == Operator::kExistsNamed; }
  bool is_leaf() const { return op == Operator::kNumber || is_name(); }

  union {
    double value_;
    NameId name_;
    Operands operands_;
  };
};
static_assert(sizeof(Expr) == 16);

/// All expressions of a program, in one array; an operand always comes before its operator.
using ExprPool = std::vector<Expr>;

/// Calls `visit` for the operands of an expression, not for theirs. Whoever goes on to theirs goes no deeper than a line is long.
template <typename Visit>
void for_each_operand(const Expr& expr, const Visit& visit) {
  if (expr.left() != kNoExpr) visit(expr.left());
  if (expr.right() != kNoExpr) visit(expr.right());
}

/// Whether `fits` is true of an operand.
template <typename Fits>
bool any_operand(const Expr& expr, const Fits& fits) {
  return (expr.left() != kNoExpr && fits(expr.left())) || (expr.right() != kNoExpr && fits(expr.right()));
}

/// An error in a part of a line: the interpreter's message, and the normalised characters that it is about.
struct ReadError {
  StopKind kind = StopKind::kNone;
  size_t from = 0;  ///< index into the LineText
  size_t to = 0;
  std::string message;
};

/// Reads values out of one line. The cursor stays where reading ended; after a failure `error()` says why.
class ExpressionParser {
 public:
  /// `split_numbers`: takes the places of numbers that blanks divide; null where nobody asks.
  ExpressionParser(const LineText& line, ExprPool& pool, Names& names, std::vector<Span>* split_numbers = nullptr)
      : line_(line), pool_(pool), names_(names), split_numbers_(split_numbers) {}

  /// Reads `[ ... ]` at the cursor.
  ExprId bracketed();
  /// Reads any value: number, `[...]`, `#...`, a function, with signs.
  ExprId value();
  /// Reads digits that are a whole number, as nearly all are; for anything else returns false and reads nothing.
  bool plain_number(uint32_t* number);
  /// Reads what follows `#`: `5`, `[...]`, `<name>`, `#5`.
  ExprId parameter();

  size_t cursor = 0;
  const ReadError& error() const { return error_; }

 private:
  ExprId add(Expr expr);
  ExprId fail(size_t from, size_t to, std::string message);
  ExprId number();
  ExprId function();
  ExprId exists();
  bool read_operator(Operator* op, bool* closed);
  bool read_name(NameId* name);
  void note_split(size_t from, size_t to);
  ExprId in_brackets();

  const LineText& line_;
  ExprPool& pool_;
  Names& names_;
  std::vector<Span>* split_numbers_;
  size_t depth_ = 0;  // of brackets
  ReadError error_;
  const char* failed_ =
      nullptr;  // the interpreter computes while it reads: a failing operation comes before a malformed one
};

/// Name of an operator as it is written (`**`, `LT`, `SQRT`), for messages and graphs.
std::string_view operator_text(Operator op);

}  // namespace owlint
