// Operations that may fail for some values: `10/[#5-1]`, `SQRT[#5]`, `#[#5]`.
#pragma once

#include <vector>

#include "analyzer/syntax/statement.h"

namespace owlint::flow {

/// Adds those of a line.
void add_fallible(const Syntax& syntax, const Statement& s, std::vector<ExprId>& out);

}  // namespace owlint::flow
