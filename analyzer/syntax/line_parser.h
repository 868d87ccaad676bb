// Turns one normalised line into a Statement. Called by the scanner for the lines that can matter.
#pragma once

#include "analyzer/syntax/statement.h"

namespace owlint {

class LineParser {
 public:
  explicit LineParser(Syntax& syntax) : out_(syntax) {}

  /// Parses `raw` (without line feed) which begins at `offset`. Fills `*statement` and returns true when the line
  /// is one to keep; its values, items and errors are then in the Syntax.
  bool parse(std::string_view raw, uint64_t offset, Statement* statement);
  /// Whether a comment begins on the line that was parsed last.
  bool has_comment() const { return line_.has_comment(); }

 private:
  void o_word(size_t at, Statement& s);
  void label(ExpressionParser& in, Statement& s);
  void arguments(ExpressionParser& in, Statement& s);
  bool words(size_t at, Statement& s);
  void m98(ExpressionParser& in, Statement& s);
  bool word(ExpressionParser& in, Statement& s);
  bool assignment(ExpressionParser& in, Statement& s);
  static std::string bad_character(char c);
  bool misplaced_character(size_t at, Statement& s);
  void recover(size_t at, Statement& s);
  void fail(Statement& s, StopKind kind, size_t from, size_t to, std::string message);
  LineByte relative(size_t at) const;
  size_t keyword_at(size_t at) const;
  size_t skip_comments(size_t at, bool* any) const;

  Syntax& out_;
  LineText line_;
};

/// The value of an expression made of literals only; false when it has parameters or fails.
bool literal_value(const ExprPool& pool, ExprId id, double* value);

/// Name of a numeric label; false when the value is not within 0.0001 of an integer.
bool label_of_number(double value, std::string* name);

}  // namespace owlint
