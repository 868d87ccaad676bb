// The commands of the program; each returns the exit status (0 clean, 1 findings, 2 usage or unreadable input).
#pragma once

#include <string>

#include "analyzer/cli/settings.h"

namespace owlint::cli {

enum ExitStatus : int { kClean = 0, kFindings = 1, kUsage = 2, kInternal = 3 };

int check_command(const CommandLine& line);
int graph_command(const CommandLine& line, const std::string& format);
int explain_command(const std::string& code_or_name);
int rules_command(const std::string& format);

/// Prints `owlint: message` to stderr.
void complain(const std::string& message);

}  // namespace owlint::cli
