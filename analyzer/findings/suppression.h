// Comments that suppress findings: `(owlint: ignore OW301 -- reason)`, `; owlint: ignore-file OW5`.
#pragma once

#include <string>
#include <vector>

#include "analyzer/findings/finding.h"

namespace owlint {

/// One code or prefix named by such a comment.
struct Suppression {
  std::string code;        ///< upper case; "" suppresses everything
  Span span;               ///< the code in the comment
  Span comment;            ///< all words of the comment
  uint32_t line = 0;       ///< the line that it suppresses; 0: the whole file
  bool used = false;
  bool malformed = false;  ///< neither `ignore` nor `ignore-file`
};

/// Reads the words behind `owlint:`. `line` is the line of the comment, `own_line` whether it stands alone there;
/// then it speaks of the next line.
std::vector<Suppression> parse_suppressions(const Source& source, Span words, uint32_t line, bool own_line);

/// Removes the findings that are suppressed, and marks the suppressions that did it.
void apply_suppressions(const Source& source, std::vector<Suppression>& suppressions, std::vector<Finding>& findings);

/// Comments that suppress the findings of a file: one before each line that has some, with their codes and the reason. In the
/// order of their places; findings in other files are left out.
std::vector<Edit> suppression_comments(const Source& source, const std::vector<Finding>& findings, const std::string& reason);

}  // namespace owlint
