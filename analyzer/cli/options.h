// The commands of owlint and their options, as they are declared to CLI11.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "analyzer/cli/audit.h"
#include "analyzer/cli/command_line.h"

namespace owlint::cli {

/// What the command line said, by command.
struct Said {
  CommandLine check, graph, modes, extents, format, config, debugged;
  AuditLine audit;
  std::string graph_format = "dot", modes_format = "text", extents_format = "text", rules_format = "text";
  uint32_t modes_line = 0;
  std::string code;            ///< to explain
  std::string pages;           ///< folder for the rules' pages
  std::string generated;       ///< folder for manual pages and completions
  size_t debugged_states = 0;  ///< kept apart at a line; 0: as usual
  bool format_check = false, format_diff = false;
  bool config_show = false, config_check = false;
};

/// Declares everything; parsing then fills `said`, which must live as long as `app`.
void add_commands(CLI::App& app, Said& said);

}  // namespace owlint::cli
