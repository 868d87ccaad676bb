// Calls that never come back because the program ends in the sub, where lines below the call were to be executed.
#pragma once

#include "analyzer/flow/engine/iteration.h"
#include "analyzer/flow/verdicts/hazards.h"

namespace owlint::flow {

/// Adds them, of a finished analysis.
void find_ends_in_subs(const Iteration& analysis, Hazards& hazards);

}  // namespace owlint::flow
