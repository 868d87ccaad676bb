// `--since REV`: the files that git knows as changed.
#pragma once

#include <set>
#include <string>

namespace owlint::cli {

/// Keys (file_key) of the files in the repository of the working folder that differ from `revision`, staged or not, and
/// those that git does not know yet. Returns false and a message if git or the revision is missing.
bool changed_since(const std::string& revision, std::set<std::string>* files, std::string* error);

}  // namespace owlint::cli
