// The formatter: indents lines by subs and blocks and changes nothing else. LinuxCNC removes spaces, so it sees the same
// program; but it counts them, so no line grows beyond what LinuxCNC reads.
#pragma once

#include <vector>

#include "analyzer/findings/finding.h"
#include "analyzer/program/program.h"

namespace owlint {

struct IndentStyle {
  size_t width = 2;    ///< columns for each level
  bool spaces = true;  ///< else one tab for each level
};

/// The edits that indent a program by its structure: only spaces at the beginning of lines, in the order of the lines.
/// Blocks and subs without an end do not indent.
std::vector<Edit> indentation(const Program& program, const IndentStyle& style);

}  // namespace owlint
