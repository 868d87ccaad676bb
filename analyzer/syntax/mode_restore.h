// M72, and the end of a sub behind M73: the modes that were saved come back by lines that the interpreter makes of what differs.
#pragma once

#include "analyzer/syntax/mode_faults.h"

namespace owlint {

struct Restored {
  bool stops;        ///< on all runs
  Answer something;  ///< whether something differed: then the rest of the line of M72 is lost
};

/// `word`: M72.
Restored restore(const MachineWords& machine, const ModeSets& saved, uint8_t word, ModeFaults& line);

}  // namespace owlint
