// The lines of a tool table as LinuxCNC reads them, for findings about the table itself; see tool_table.h.
#pragma once

#include <vector>

#include "analyzer/machine/tool_table.h"

namespace owlint {

/// A line with words.
struct ToolLine {
  ToolRow row;
  bool skipped = false;     ///< for `bad`: a word that LinuxCNC does not know
  bool has_tool = false;    ///< T
  bool has_pocket = false;  ///< P; without it the line is about the spindle
  bool no_place = false;    ///< of a random changer: P beyond its places; of a fixed one: more than 1000 tools
  Span bad;                 ///< the word that makes it skipped
  Span hidden;              ///< words behind a tab, which separates none; empty if there are none
};

std::vector<ToolLine> read_tool_lines(std::string_view bytes, ToolChanger changer);

}  // namespace owlint
