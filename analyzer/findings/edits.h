// Makes fixes: which of them go together, and the resulting text. Used by `--fix` and by editors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analyzer/findings/finding.h"

namespace owlint {

/// The edits of one round of fixing, ordered by position; no two of them touch.
struct Round {
  std::vector<Edit> edits;
  size_t made = 0;  ///< findings that they fix
};

/// The first fix of each finding, from the beginning of the file; only safe ones unless `unsafe`. A fix that touches another
/// one waits for the next round, after a new check. Findings in other files are left out.
Round round_of_fixes(const std::vector<Finding>& findings, bool unsafe);

/// The text with the edits made; they must be ordered by position and must not overlap.
std::string apply_edits(std::string_view text, const std::vector<Edit>& edits);

/// How many findings have a safe fix, and how many have only unsafe ones.
struct Fixable {
  size_t safe = 0;
  size_t unsafe = 0;
};
Fixable count_fixable(const std::vector<Finding>& findings);

}  // namespace owlint
