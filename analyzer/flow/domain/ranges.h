// Ranges of numbers: what is known about a value that is not one constant. Every operation returns a range that contains all
// results of arithmetic.h for members of its operands; if nothing better is known, all numbers.
#pragma once

#include <limits>
#include <vector>

#include "analyzer/flow/limits.h"
#include "analyzer/syntax/expression.h"

namespace owlint::flow {

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;   ///< `low` itself is not a member
  bool below_high = false;  ///< `high` itself is not a member

  static Range of(double value) { return {value, value, false, false}; }
  bool is_all() const;
  bool is_one() const { return low == high; }
  /// No number is a member.
  bool is_empty() const { return low > high || (low == high && (above_low || below_high)); }
  bool has(double value) const;
  bool operator==(const Range&) const = default;
};

/// The smallest range that contains both.
Range hull(const Range& a, const Range& b);
Range intersection(const Range& a, const Range& b);

/// Applies an operator; `right` is ignored for operators with one operand. Comparisons return 0, 1, or the range from 0 to 1.
Range apply(Operator op, const Range& left, const Range& right);
/// The interpreter's message if the operation fails for all members, else null.
const char* always_fails(Operator op, const Range& left, const Range& right);

/// The members of `left` for which `left OP right` can be `truth`; OP is EQ, NE, GT, GE, LT or LE.
Range narrowed(const Range& left, Operator op, const Range& right, bool truth);
/// The comparison with its sides swapped: `a LT b` is `b GT a`.
Operator mirrored(Operator op);
/// Whether `op` is one of the six comparisons.
bool is_comparison(Operator op);

/// Adds the limits of a comparison with `number`: the number, and for EQ and NE the limits of what counts as equal to it.
void add_thresholds(Operator op, double number, std::vector<double>& out);

/// Numbers at which ranges may begin and end. Widened to them, a range that grows in every pass of a loop stops growing
/// after a few passes.
class Thresholds {
 public:
  /// From a program's conditions: the numbers that parameters are compared with. With more than `most`, only 0 is used.
  explicit Thresholds(std::vector<double> numbers, size_t most = Limits{}.thresholds);
  Thresholds() : Thresholds(std::vector<double>{}) {}
  Range widened(const Range& range) const;
  const std::vector<double>& numbers() const { return numbers_; }

 private:
  std::vector<double> numbers_;  // sorted
};

}  // namespace owlint::flow
