// What makes two findings of different runs the same one: rule, sub and block, and the text of the line; not its number, nor
// the folder. Baselines, fingerprints and new-or-old rest on it.
#pragma once

#include <string>
#include <vector>

#include "analyzer/findings/finding.h"

namespace owlint {

struct Identity {
  std::string file;  ///< the last part of the path
  std::string code;
  std::string scope;  ///< Finding::scope
  std::string text;   ///< the line, blanks at its ends cut off, others as one

  auto operator<=>(const Identity&) const = default;
};

Identity identity_of(const Source& source, const Finding& finding);

/// A fingerprint for each finding of a file, in their order: equal ones are told apart by counting.
std::vector<std::string> fingerprints(const Source& source, const std::vector<Finding>& findings);

}  // namespace owlint
