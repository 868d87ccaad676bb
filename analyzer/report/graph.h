// The block graph and the call graph of a program, as text for other tools.
#pragma once

#include <ostream>

#include "analyzer/program/program.h"

namespace owlint {

void write_graph_dot(std::ostream& out, const Program& program);
void write_graph_mermaid(std::ostream& out, const Program& program);
void write_graph_json(std::ostream& out, const Program& program);

}  // namespace owlint
