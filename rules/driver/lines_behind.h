// The lines of code behind a line, as a run goes down through them: for rules about what becomes of something that the flow does
// not follow.
#pragma once

#include <span>
#include <vector>

#include "rules/driver/words.h"

namespace owlint::rules {

class LinesBehind {
 public:
  LinesBehind(const Program& program, uint32_t line);

  /// Goes to the next line of code; passes over the branches that exclude the first line. False behind the line at which the sub
  /// or the program ends, which calls something, or which is too far away.
  bool next();

  uint32_t line() const { return line_; }
  /// The words of the line; of an O-word none.
  const std::vector<WrittenWord>& words() const { return words_; }
  /// The statements of the line.
  std::span<const Statement> statements() const {
    return std::span(program_.syntax.statements).subspan(begin_, next_ - begin_);
  }

 private:
  bool passes_branch();
  bool ends(StatementId id) const;

  const Program& program_;
  const uint32_t first_;
  uint32_t line_;
  StatementId begin_ = 0, next_ = 0;  // those of the line
  std::vector<WrittenWord> words_;
  bool over_ = false;
};

}  // namespace owlint::rules
