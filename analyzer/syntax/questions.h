// Where the questions about a line are (kMachineCheck, kModeLine), beside the statement of the line itself: in front of it,
// in this order.
#pragma once

#include "analyzer/syntax/statement.h"

namespace owlint {

inline bool on_one_line(const Statement& a, const Statement& b) { return a.line == b.line && a.offset == b.offset; }

/// What the words of this line need of the modes; null if it has nothing to ask.
inline const Statement* mode_line_of(const Syntax& syntax, StatementId line) {
  if (line == 0) return nullptr;
  const Statement& asks = syntax.statements[line - 1];
  return asks.kind == LineKind::kModeLine && on_one_line(asks, syntax.statements[line]) ? &asks : nullptr;
}

/// Whether the line has M72, which loses the rest of it if it restores something: even the end of the program.
inline bool may_lose_rest(const Syntax& syntax, StatementId line) {
  constexpr double kM72 = 72;
  const Statement* const asks = mode_line_of(syntax, line);
  if (asks == nullptr) return false;
  for (const ModeWord& word : syntax.words_of(*asks)) {
    if (word.letter == 'm' && (!word.known || word.value == kM72)) return true;
  }
  return false;
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
