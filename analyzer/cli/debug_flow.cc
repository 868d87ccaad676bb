// `owlint debug-flow`: the fixpoint of the flow analysis to watch, for those who work on it.
#include <algorithm>
#include <iostream>

#include "analyzer/cli/commands.h"
#include "analyzer/flow/engine/debug.h"
#include "analyzer/text/files.h"

namespace owlint::cli {

int debug_flow_command(const CommandLine& line, size_t states) {
  Settings settings;
  const auto source = read_program(line, &settings);
  if (source == nullptr) return kUsage;
  flow::Limits limits;
  for (auto& level : limits.levels) {
    if (states == 0) continue;
    level.states = std::min(level.states, states);
    level.contexts = std::min(level.contexts, states);
  }
  Library library(disk());
  const Linked linked(library.load(source, settings.profile), settings.profile, library);
  flow::write_states(std::cout, linked, settings.profile, limits);
  return kClean;
}

}  // namespace owlint::cli
