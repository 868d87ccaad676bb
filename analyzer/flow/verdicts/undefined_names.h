// Whether it is certain that some run reads a name that is not there: then it is an error, else a warning.
#pragma once

#include <vector>

#include "analyzer/flow/flow.h"
#include "analyzer/flow/interpreter/refinement.h"
#include "analyzer/program/program.h"

namespace owlint::flow {

/// Whether a name is missing only after a loop without a pass, or for a value that a list of cases does not have
/// (`elseif`, or one `if` after the other): lines above assign it there, and nobody but the program's author knows whether
/// that happens.
bool assigned_in_most_cases(const Program& program, const FlowStop& stop);

/// Whether the branches on a path go as they do independently of each other, or are known not to.
bool followed(const Program& program, const Refinement& refinement, const std::vector<Decision>& path);

}  // namespace owlint::flow
