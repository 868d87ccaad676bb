// The block graph of a program and the call graph of all files that it calls, for other tools and for the eye.
#pragma once

#include <ostream>
#include <string>

#include "analyzer/program/linker.h"

namespace owlint {

void write_graph_dot(std::ostream& out, const Linked& linked);
void write_graph_mermaid(std::ostream& out, const Linked& linked);
void write_graph_json(std::ostream& out, const Linked& linked);
/// Drawn by Graphviz. Returns what went wrong, or nothing.
std::string write_graph_svg(std::ostream& out, const Linked& linked);

}  // namespace owlint
