// What else is wrong with a line of words that the interpreter refuses. It reports one mistake and stops; the next one shows when
// that is fixed. Asked by the rules about the few lines at which a run stops.
#pragma once

#include <string_view>
#include <vector>

#include "analyzer/syntax/statement.h"

namespace owlint {

/// The mistakes of reading behind `first`, with which the line stops, in the order of the line. Only those that are left whatever
/// is done about the one before: nothing that splitting the line would cure, no word that may belong to a code that is not
/// known, and nothing in what looks like text. `codes_known`: a code that `machine` does not have is
/// a mistake, even if it is not known which codes its INI adds.
std::vector<LineError> further_faults(std::string_view raw, uint64_t offset, const LineError& first,
                                      const MachineWords& machine, bool codes_known);

}  // namespace owlint
