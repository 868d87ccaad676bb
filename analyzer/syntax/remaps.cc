#include "analyzer/syntax/remaps.h"

#include "analyzer/syntax/questions.h"
#include "analyzer/syntax/word_line.h"

namespace owlint {

RemapsAround remaps_around(const Syntax& syntax, StatementId question) {
  const auto& statements = syntax.statements;
  const Statement& line = statements[question];
  RemapsAround around;
  if (question > 0 && statements[question - 1].kind == LineKind::kRemap && on_one_line(statements[question - 1], line))
    around.before = &statements[question - 1];
  for (StatementId id = question + 1; id < statements.size() && on_one_line(statements[id], line); ++id) {
    if (statements[id].kind != LineKind::kRemap) continue;
    around.next = &statements[id];
    break;
  }
  return around;
}

const RemappedCode* code_of_remap(const Syntax& syntax, const Statement& remap, const MachineWords& machine) {
  WordLine line(machine);
  for (const ModeWord& word : syntax.words_of(remap))
    line.add({word.letter, word.known, word.value, word.from, word.to});
  for (const RemappedWord& word : line.remapped_words()) {
    if (line[word.word].from == remap.keyword_from) return word.code;
  }
  return nullptr;
}

bool ends_program(const Statement& statement) {
  return statement.kind == LineKind::kProgramEnd || statement.kind == LineKind::kM99Behind;
}

bool follows_remaps(const Statement& statement, const WordLine& words) {
  if (!words.has_remapped_code() || words.has_unknown_code()) return false;
  if (const MCode* const of_spindle = words.code(MGroup::kSpindle);
      of_spindle != nullptr && of_spindle->number == code::kM72)
    return false;
  return statement.kind == LineKind::kWords || (ends_program(statement) && statement.item_count == 0);
}

}  // namespace owlint
