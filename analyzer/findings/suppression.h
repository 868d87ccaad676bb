// Comments that suppress findings: `(owlint: ignore OW301 because the post writes it so)`, `; owlint: ignore-file OW5`.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analyzer/findings/finding.h"

namespace owlint {

/// One code or prefix named by such a comment.
struct Suppression {
  std::string code;   ///< as CodeOf gives it; "" suppresses everything
  Span span;          ///< the code in the comment
  Span comment;       ///< all words of the comment
  uint32_t line = 0;  ///< the line that it is for; 0: the whole file
  bool used = false;
  bool malformed = false;  ///< neither `ignore` nor `ignore-file`
};

/// The code that a word behind `ignore` stands for, or the word itself where it was meant for a code and is none; nothing for
/// a word of the reason. The first word is always meant for a code.
using CodeOf = std::function<std::optional<std::string>(std::string_view word, bool first)>;

/// Reads the words behind `owlint:`: codes, then the reason. `line` is the line of the comment, `own_line` whether it stands
/// alone there; then it speaks of the next line.
std::vector<Suppression> parse_suppressions(const Source& source, Span words, uint32_t line, bool own_line,
                                            const CodeOf& code_of);

/// Removes the findings that are suppressed, and marks the suppressions that did it.
void apply_suppressions(const Source& source, std::vector<Suppression>& suppressions, std::vector<Finding>& findings);

/// Comments that suppress the findings of a file: one before each line that has some, with their codes and the reason. Ordered
/// by position; findings in other files are left out.
std::vector<Edit> suppression_comments(const Source& source, const std::vector<Finding>& findings,
                                       const std::string& reason);

}  // namespace owlint
