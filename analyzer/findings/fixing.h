// Makes fixes: which of them go together, and what comes out. Used by `--fix` and by editors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analyzer/findings/finding.h"

namespace owlint {

/// Edits of one round of fixing, in the order of their places; no two of them touch.
struct Round {
  std::vector<Edit> edits;
  size_t made = 0;  ///< findings that they fix
};

/// The first fix of each finding, front to back; only the safe ones unless `unsafe`. One that touches another is left for
/// the next round, after a new check. Findings in other files are left out.
Round round_of_fixes(const std::vector<Finding>& findings, bool unsafe);

/// The text with the edits made; they must be in the order of their places and must not overlap.
std::string apply_edits(std::string_view text, const std::vector<Edit>& edits);

/// How many findings have a fix: safe ones, and those that have only others.
struct Fixable {
  size_t safe = 0;
  size_t unsafe = 0;
};
Fixable count_fixable(const std::vector<Finding>& findings);

}  // namespace owlint
