// `--since REV`: the files that git knows as changed.
#pragma once

#include <set>
#include <string>

namespace owlint::cli {

/// Keys (file_key) of the files in the repository of the working folder that are not as in `revision`, staged or not, and
/// those that git does not know yet. False and a message where git or the revision is not there.
bool changed_since(const std::string& revision, std::set<std::string>* files, std::string* error);

}  // namespace owlint::cli
