// `owlint audit` and its commands.
#pragma once

#include <string>
#include <vector>

#include "analyzer/cli/command_line.h"

namespace owlint::cli {

/// The command line of an audit.
struct AuditLine {
  CommandLine check;  ///< paths, machine, rules, output
  std::string store = "owlint-audit.db";
  std::string report;  ///< the page; empty: none
  std::string shard;   ///< I/N
  std::string run = "last";
  std::vector<std::string> stores;  ///< to merge
  std::string from, to;             ///< to compare
  bool fail_on_new = false, watch = false, wait = false;
};

int audit_command(const AuditLine& line);
int audit_list_command(const AuditLine& line);
/// The findings of a run in a format: for people by `show`, for others by `export`.
int audit_show_command(const AuditLine& line);
int audit_diff_command(const AuditLine& line);
int audit_merge_command(const AuditLine& line);

}  // namespace owlint::cli
