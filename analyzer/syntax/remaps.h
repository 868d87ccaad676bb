// The statements of a line with codes that the machine's INI remaps (LineKind::kRemap).
#pragma once

#include "analyzer/syntax/statement.h"
#include "analyzer/syntax/word_line.h"

namespace owlint {

/// Around a kModeLine of such a line: the code behind which it acts, and the one up to which it does.
struct RemapsAround {
  const Statement* before = nullptr;  ///< a kRemap, or null at the line's beginning
  const Statement* next = nullptr;    ///< a kRemap, or null at its end
};
RemapsAround remaps_around(const Syntax& syntax, StatementId question);

/// What the line of a kRemap runs; null if the machine does not remap the code.
const RemappedCode* code_of_remap(const Syntax& syntax, const Statement& remap, const MachineWords& machine);

/// Whether behind the line the program has ended: M2, M30, and M99 behind other words.
bool ends_program(const Statement& statement);
/// Whether the flow leads into what the line's remapped codes run. Else they may do anything, as where it is not known which
/// codes the line has. What M72 restores makes it lose the rest of its line; on a line that ends the program parameters are set
/// first.
bool follows_remaps(const Statement& statement, const WordLine& words);

}  // namespace owlint
