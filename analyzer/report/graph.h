// The block graph of a program and the call graph of all files that it calls, for other tools and for people.
#pragma once

#include <ostream>
#include <string>

#include "analyzer/findings/finding.h"
#include "analyzer/program/linker.h"

namespace owlint {

/// The nodes that have `findings` are marked. Classes say what a node is: `line-12`, `file-3` for the fourth of the linked
/// files, `error`, `warning` or `info` for its worst finding.
void write_graph_dot(std::ostream& out, const Linked& linked, const std::vector<Finding>& findings);
void write_graph_mermaid(std::ostream& out, const Linked& linked);
void write_graph_json(std::ostream& out, const Linked& linked);
/// Drawn by Graphviz. Returns an error message, or nothing.
std::string write_graph_svg(std::ostream& out, const Linked& linked, const std::vector<Finding>& findings);

}  // namespace owlint
