// Calls that do not find their sub: the interpreter reads on to the end of a file, and stops there. The call is to blame.
#pragma once

#include "analyzer/flow/engine/iteration.h"
#include "analyzer/flow/verdicts/stops.h"

namespace owlint::flow {

/// Why a search for a sub from the line of `call` on fails.
StopKind why_not_found(const Iteration& analysis, NameId sub, StatementId call);

/// Adds the stops of calls in the finished analysis that seek their sub to the end of a file.
void find_missing_subs(const Iteration& analysis, Stops& stops);

}  // namespace owlint::flow
