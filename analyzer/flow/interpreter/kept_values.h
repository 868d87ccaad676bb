// Assignments that change nothing: a loop goes round for ever if its only step is one of them.
#pragma once

#include "analyzer/flow/interpreter/evaluator.h"

namespace owlint::flow {

/// Whether a line assigns, and each parameter that it assigns stays what it was, whatever that is: `#1 = [#1 + #2]` where `#2` is
/// 0. `in`: before the line, which does not stop.
bool keeps_values(const Syntax& syntax, const Statement& line, const Parameters& in, Evaluator& evaluator);

}  // namespace owlint::flow
