// Findings that are one mistake in many places of a run, such as the calls of a sub that is nowhere: reported once.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analyzer/findings/file_report.h"
#include "analyzer/text/files.h"

namespace owlint::checking {

/// Where a run looks: the files that it checks, and the folders that it was asked to check, by their file_key.
struct Tree {
  std::vector<std::string> files;
  std::vector<std::string> folders;
};

/// The folders of paths as they stand on a command line; of a file, the one that it lies in.
std::vector<std::string> folders_of(const Files& files, const std::vector<std::string>& paths);

/// Of each group of findings below one folder the first is kept, with the others as related places. Where the tree has a file of
/// the name that was not found, the finding says so.
void fold_groups(std::span<FileReport> reports, const Tree& tree);

}  // namespace owlint::checking
