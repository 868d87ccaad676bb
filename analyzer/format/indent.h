// The formatter: leading indentation follows subs and blocks, nothing else changes. LinuxCNC drops blanks, so that it
// sees the same program, but counts them: no line grows beyond what it reads.
#pragma once

#include <vector>

#include "analyzer/findings/finding.h"
#include "analyzer/program/program.h"

namespace owlint {

struct IndentStyle {
  size_t width = 2;    ///< columns a level
  bool spaces = true;  ///< else one tab a level
};

/// What has to change for a program to be indented by its structure; edits of the blanks at the beginning of lines, in
/// the order of the lines. Blocks and subs without their ends do not indent.
std::vector<Edit> indentation(const Program& program, const IndentStyle& style);

}  // namespace owlint
