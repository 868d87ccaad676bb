// From a place in a file to the statement there.
#pragma once

#include <algorithm>

#include "analyzer/syntax/statement.h"

namespace owlint {

/// The last statement that begins at `offset` or before it; kNoStatement if all begin behind it.
inline StatementId last_statement(const Syntax& syntax, uint64_t offset) {
  const auto after = std::ranges::upper_bound(syntax.statements, offset, {}, &Statement::offset);
  return after == syntax.statements.begin() ? kNoStatement
                                            : static_cast<StatementId>(after - syntax.statements.begin() - 1);
}

}  // namespace owlint
