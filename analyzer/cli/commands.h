// The commands of the program; each returns the exit status (0 clean, 1 findings, 2 usage or unreadable input).
#pragma once

#include <memory>
#include <string>

#include "analyzer/cli/command_line.h"

namespace owlint::cli {

enum ExitStatus : int { kClean = 0, kFindings = 1, kUsage = 2, kInternal = 3 };

int check_command(const CommandLine& line);
int graph_command(const CommandLine& line, const std::string& format);
/// Prints what the flow analysis does. `states`: kept apart at a line; 0: as usual.
int debug_flow_command(const CommandLine& line, size_t states);
/// Prints which modes are in effect before the line `at`; 0: what each line changes. `format`: text or json.
int modes_command(const CommandLine& line, uint32_t at, const std::string& format);
/// Prints how far a program goes. `format`: text or json.
int extents_command(const CommandLine& line, const std::string& format);
int lsp_command();
/// `check`: change nothing, exit with 1 if something would change; `diff`: print the changes instead of making them.
int format_command(const CommandLine& line, bool check, bool diff);
/// Prints the settings for each of `line.paths` and where they come from; `check`: only checks the configuration files.
int config_command(const CommandLine& line, bool check);
/// `color`: as --color says.
int explain_command(const std::string& code_or_name, const std::string& color);
int rules_command(const std::string& format);
int rule_pages_command(const std::string& folder);

/// The program that a command is about, the first of `line.paths`, and its settings; null, after a message on stderr, if one of
/// them cannot be read.
std::shared_ptr<const Source> read_program(const CommandLine& line, checking::Settings* settings);

/// Prints `owlint: message` to stderr.
void complain(const std::string& message);

}  // namespace owlint::cli
