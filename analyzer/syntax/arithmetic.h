// RS274 arithmetic on known values, shared by the reader (literal labels) and the flow room (constants).
#pragma once

#include "analyzer/syntax/expression.h"

namespace owlint {

/// EQ is true for numbers that differ by less (measured: 0 EQ 0.00009 is true, 0 EQ 0.00011 is false).
inline constexpr double kEqualTolerance = 1e-4;

/// What is said of a value that is no finite number. LinuxCNC looks at complete values only (Expr::complete), so that
/// `[1 / 0 ** -1]` is 0 (measured).
inline constexpr const char* kNotANumber = "Calculation resulted in 'not a number'";
inline constexpr const char* kInfinite = "Calculation resulted in 'infinity'";
inline bool is_not_finite(const char* message) { return message == kNotANumber || message == kInfinite; }

/// Applies `op` to known operands (`right` is ignored by one-operand operators). Returns null and sets `*result`,
/// or returns the interpreter's message when the operation fails.
const char* apply(Operator op, double left, double right, double* result);

/// Rounds to an integer as LinuxCNC does with numbers of labels and parameters; false if not within 0.0001 of one.
bool to_integer(double value, long* result);

}  // namespace owlint
