// RS274 arithmetic on known values, shared by the reader (literal labels) and the flow room (constants).
#pragma once

#include "analyzer/syntax/expression.h"

namespace owlint {

/// EQ is true for numbers that differ by less (measured: 0 EQ 0.00009 is true, 0 EQ 0.00011 is false).
inline constexpr double kEqualTolerance = 1e-4;

/// Applies `op` to known operands (`right` is ignored by one-operand operators). Returns null and sets `*result`,
/// or returns the interpreter's message when the operation fails.
const char* apply(Operator op, double left, double right, double* result);

/// Rounds to an integer as LinuxCNC does with numbers of labels and parameters; false if not within 0.0001 of one.
bool to_integer(double value, long* result);

}  // namespace owlint
