// When two findings of different runs are the same one: if rule, sub, block and the text of the line are the same; the line
// number and the folder do not matter. Baselines, fingerprints and "new" or "gone" depend on it.
#pragma once

#include <string>
#include <vector>

#include "analyzer/findings/finding.h"

namespace owlint {

struct Identity {
  std::string file;  ///< the last part of the path
  std::string code;
  std::string scope;  ///< Finding::scope
  std::string text;   ///< the line without spaces at its ends, with single spaces inside

  auto operator<=>(const Identity&) const = default;
};

Identity identity_of(const Source& source, const Finding& finding);

/// A fingerprint for each finding of a file, in their order; equal ones are counted, so that each has its own.
std::vector<std::string> fingerprints(const Source& source, const std::vector<Finding>& findings);

}  // namespace owlint
