#include "analyzer/flow/engine/mode_setters.h"

#include <algorithm>
#include <set>
#include <utility>

namespace owlint::flow {
namespace {

uint32_t last_of(std::span<const ModeChange> changes, ModeMask modes) {
  uint32_t last = 0;
  for (const ModeChange& change : changes) {
    if ((mask_of(change.mode) & modes) != 0) last = std::max(last, change.line);
  }
  return last;
}

/// The line of a statement that sets one of the modes, or one of those behind it if `next` comes next.
ModeSetter setter_at(const Iteration& analysis, StatementId here, StatementId next, ModeMask modes) {
  const Linked& linked = analysis.linked();
  const Program& program = linked.program();
  const auto file_of = [&](StatementId id) { return linked.files()[linked.file_of(id)].program.get(); };
  // The lines behind a statement have run where the next statement comes next.
  if (here + 1 == next) {
    if (const uint32_t line = last_of(program.syntax.changes_after(here), modes); line != 0)
      return {file_of(here), line};
  }
  const Statement& s = program.at(here);
  if (s.kind == LineKind::kModeLine && (analysis.machine().mode_uses().set_at(here) & modes) != 0)
    return {file_of(here), s.line};
  return {};
}

/// The lines before the first statement.
ModeSetter setter_before(const Iteration& analysis, ModeMask modes) {
  const Linked& linked = analysis.linked();
  const uint32_t line = last_of(linked.program().syntax.first_changes, modes);
  return line == 0 ? ModeSetter{} : ModeSetter{linked.files()[0].program.get(), line};
}

}  // namespace

ModeSetter last_setter(const Iteration& analysis, RecordId record, StatementId next, ModeMask modes) {
  const Trace& trace = *analysis.trace();
  for (; record != kNoRecord; record = trace.at(record).parent) {
    const StatementId here = trace.at(record).statement;
    if (here == kNoStatement) continue;
    if (const ModeSetter setter = setter_at(analysis, here, next, modes); setter.file != nullptr) return setter;
    next = here;
  }
  return setter_before(analysis, modes);
}

ModeSetters::ModeSetters(const Iteration& analysis) : analysis_(analysis) { analysis.trace()->finish(); }

/// Where a call comes back, its own last line comes before, not the call.
bool ModeSetters::leads_past_call(RecordId from, RecordId to) const {
  const Trace& trace = *analysis_.trace();
  const Trace::Record& back = trace.at(to);
  const StatementId call = trace.at(from).statement;
  return back.after_call && from == back.parent && call != kNoStatement && analysis_.program().at(call).calls();
}

std::vector<ModeSetter> ModeSetters::of(std::span<const RecordId> records, StatementId next, ModeMask modes) const {
  constexpr size_t kMostSteps = 20000;
  const Trace& trace = *analysis_.trace();
  std::vector<ModeSetter> found;
  const auto add = [&](const ModeSetter& setter) {
    if (setter.file != nullptr && std::ranges::find(found, setter) == found.end()) found.push_back(setter);
  };
  std::set<std::pair<RecordId, StatementId>> seen;
  std::vector<std::pair<RecordId, StatementId>> todo;
  const auto go = [&](RecordId record, StatementId to) {
    if (seen.emplace(record, to).second) todo.emplace_back(record, to);
  };
  for (const RecordId record : records) {
    if (record == kNoRecord) add(setter_before(analysis_, modes));
    if (record != kNoRecord) go(record, next);
  }
  while (!todo.empty() && seen.size() < kMostSteps) {
    auto [record, to] = todo.back();
    todo.pop_back();
    if (const StatementId here = trace.at(record).statement; here != kNoStatement) {
      const ModeSetter setter = setter_at(analysis_, here, to, modes);
      add(setter);
      if (setter.file != nullptr) continue;
      to = here;
    }
    // The lines behind a condition that is false are skipped.
    const StatementId behind = trace.at(record).branch == Branch::kFalse ? kNoStatement : to;
    bool begins = true;
    for (const RecordId from : trace.previous(record)) {
      if (leads_past_call(from, record)) continue;
      begins = false;
      go(from, behind);
    }
    if (begins) add(setter_before(analysis_, modes));
  }
  if (!todo.empty() && !records.empty()) found = {last_setter(analysis_, records.front(), next, modes)};
  std::erase_if(found, [](const ModeSetter& setter) { return setter.file == nullptr; });
  std::ranges::sort(found, {}, &ModeSetter::line);
  return found;
}

}  // namespace owlint::flow
