// Where the modes in effect have been set.
#pragma once

#include "analyzer/flow/engine/iteration.h"

namespace owlint::flow {

/// A line of one of the files; null and 0 if no line has set the mode.
struct ModeSetter {
  const Program* file = nullptr;
  uint32_t line = 0;
};

/// The last line on the way to a record that has set one of the modes. `next`: the statement to which that way leads.
ModeSetter last_setter(const Iteration& analysis, RecordId record, StatementId next, ModeMask modes);

}  // namespace owlint::flow
