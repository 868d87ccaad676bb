#include "analyzer/flow/engine/mode_setters.h"

#include <algorithm>

namespace owlint::flow {

ModeSetter last_setter(const Iteration& analysis, RecordId record, StatementId next, ModeMask modes) {
  const Linked& linked = analysis.linked();
  const Program& program = linked.program();
  const Trace& trace = *analysis.trace();
  const auto among = [&](std::span<const ModeChange> changes) {
    uint32_t last = 0;
    for (const ModeChange& change : changes) {
      if ((mask_of(change.mode) & modes) != 0) last = std::max(last, change.line);
    }
    return last;
  };
  const auto file_of = [&](StatementId id) { return linked.files()[linked.file_of(id)].program.get(); };
  for (; record != kNoRecord; record = trace.at(record).parent) {
    const StatementId here = trace.at(record).statement;
    if (here == kNoStatement) continue;
    // The lines behind a statement have run where the next statement comes next.
    if (here + 1 == next) {
      if (const uint32_t line = among(program.syntax.changes_after(here)); line != 0) return {file_of(here), line};
    }
    const Statement& s = program.at(here);
    if (s.kind == LineKind::kModeLine && (analysis.machine().mode_uses().changed_at(here) & modes) != 0)
      return {file_of(here), s.line};
    next = here;
  }
  if (const uint32_t line = among(program.syntax.first_changes); line != 0)
    return {linked.files()[0].program.get(), line};
  return {};
}

}  // namespace owlint::flow
