// RS274 arithmetic on known values, shared by the reader (literal labels) and the flow room (constants).
#pragma once

#include "analyzer/syntax/expression.h"

namespace owlint {

/// EQ holds for what differs by less (measured: 0 EQ 0.00009 holds, 0 EQ 0.00011 does not).
inline constexpr double kEqualTolerance = 1e-4;

/// Applies `op` to known operands (`right` is ignored by one-operand operators). Returns null and sets `*result`,
/// or returns the interpreter's message when the operation fails.
const char* apply(Operator op, double left, double right, double* result);

/// Rounds to an integer as label and parameter numbers are read; false when not within 0.0001 of one.
bool to_integer(double value, long* result);

}  // namespace owlint
