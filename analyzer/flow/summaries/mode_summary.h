// What the own lines of a sub need of the modes and do to them, whatever the way through it; the subs that it calls are not
// looked at.
#pragma once

#include <map>
#include <vector>

#include "analyzer/program/program.h"

namespace owlint::flow {

struct ModeSummary {
  std::map<Mode, uint32_t> needs;  ///< modes as the caller has them, and the first line that depends on each
  std::vector<Mode> changes;       ///< modes that some line sets
  std::map<Mode, uint8_t> leaves;  ///< those that have this value behind the sub in any case
};

ModeSummary summary_of_modes(const Program& program, RegionId region);

}  // namespace owlint::flow
