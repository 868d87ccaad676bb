// Where the questions about a line are (kMotionCheck, kMachineCheck), beside the statement of the line itself: in front of M98, which
// leaves its line, and of lines that end the program; behind a line that computes values.
#pragma once

#include "analyzer/syntax/statement.h"

namespace owlint {

inline bool on_one_line(const Statement& a, const Statement& b) { return a.line == b.line && a.offset == b.offset; }

/// What the words of this line need of the motion in effect; null if it has nothing to ask.
inline const Statement* motion_check_of(const Syntax& syntax, StatementId line) {
  const auto asks = [&](StatementId id) {
    const Statement& s = syntax.statements[id];
    return s.kind == LineKind::kMotionCheck && on_one_line(s, syntax.statements[line]) ? &s : nullptr;
  };
  const Statement* before = line > 0 ? asks(line - 1) : nullptr;
  if (before != nullptr || line + 1 == syntax.statements.size()) return before;
  return asks(line + 1);
}

/// Whether this question is about a line that begins with M98.
inline bool asks_about_call(const Syntax& syntax, StatementId question) {
  const Statement& asks = syntax.statements[question];
  for (StatementId id = question + 1; id < syntax.statements.size(); ++id) {
    const Statement& s = syntax.statements[id];
    if (!on_one_line(s, asks)) return false;
    if (s.kind == LineKind::kM98) return true;
  }
  return false;
}

}  // namespace owlint
