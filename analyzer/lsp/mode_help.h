// The modes in effect before a line, for hover.
#pragma once

#include <string>

#include "analyzer/lsp/workspace.h"

namespace owlint::lsp {

/// A list in Markdown: each mode with its values, and the lines that have set it. `line`: from 1. Empty if no run gets there.
std::string modes_before(Workspace& workspace, const Document& document, uint32_t line);

}  // namespace owlint::lsp
