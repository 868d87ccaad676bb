// The statements of a line with codes that the machine's INI remaps (LineKind::kRemap).
#pragma once

#include "analyzer/syntax/statement.h"

namespace owlint {

/// Around a kModeLine of such a line: the code behind which it acts, and the one up to which it does.
struct RemapsAround {
  const Statement* before = nullptr;  ///< a kRemap, or null at the line's beginning
  const Statement* next = nullptr;    ///< a kRemap, or null at its end
};
RemapsAround remaps_around(const Syntax& syntax, StatementId question);

/// What the line of a kRemap runs; null if the machine does not remap the code.
const RemappedCode* code_of_remap(const Syntax& syntax, const Statement& remap, const MachineWords& machine);

}  // namespace owlint
